"""What the paper conjectures or leaves open: external robustness and rolling against development."""

import numpy as np

from .. import power
from ..statistics import median_difference_interval, median_interval
from ..figures import walks as walk_figure
from .base import FAST, Claim, Outcome, missing
from .outcomes import equivalent, greater, show

FAMILY = "beyond the paper"
RETAINED_MARGIN = 0.1  # of relative fitness [1]


def relative_by_world(study, quantity=None):
    """Relative fitness [1] of each run champion in changed worlds, mean over them: a series by treatment and trial. A
    life that diverged or went backwards counts as 0."""
    frame = study.robustness()
    frame = frame[(frame["part"] == "main") & (frame["quantity"] != "none") & (frame["home"] > 0)]
    if quantity:
        frame = frame[frame["quantity"] == quantity]
    frame = frame.assign(relative=frame["relative"].fillna(0.0).clip(lower=0.0))
    return frame.groupby(["treatment", "trial"])["relative"].mean()


def _robust(study):
    relative = relative_by_world(study)
    if relative.empty:
        return missing("lives in changed worlds")
    evo = relative.get("evo", relative.iloc[:0])
    devo = relative.get("evo_devo", relative.iloc[:0])
    archives = [study.main(name) for name in ("evo", "evo_devo")]
    generations = min((archive.horizon().generation for archive in archives if archive is not None), default=0)
    interval = median_difference_interval(devo, evo)
    parts = ", ".join(
        f"{quantity} {show(median_difference_interval(*_split(study, quantity)))}"
        for quantity in ("friction", "gravity", "slope", "actuation_amplitude")
    )
    return greater(devo, evo, interval, generations, f"difference of medians {show(interval)}; {parts}")


def _split(study, quantity):
    relative = relative_by_world(study, quantity)
    return relative.get("evo_devo", relative.iloc[:0]), relative.get("evo", relative.iloc[:0])


def _removed_walks(study):
    walks = study.walks()
    walks = walks[
        (walks["part"] == "main")
        & (walks["treatment"] == "evo_devo")
        & (walks["space"] == "control")
        & (walks["operator"] == walk_figure.OPERATOR)
        & (walks["start"] >= FAST)
    ]
    archive = study.main("evo_devo")
    generations = archive.horizon().generation if archive is not None else 0
    all_walks = study.walks()
    if not (all_walks["robot"] == "removed").any():
        return missing("walks of champions whose development was removed")
    if walks.empty:
        return Outcome(ours=f"no run champion of at least {FAST:g} body lengths", generations=generations)
    last = walks[walks["step"] == walks["step"].max()]
    left = last.assign(relative=last["relative"].fillna(0.0)).groupby(["robot", "trial"])["relative"].median()
    champion, removed = left.get("champion"), left.get("removed")
    if champion is None or removed is None:
        return Outcome(ours=f"no copies without development of at least {FAST:g} body lengths", generations=generations)
    differences = (champion - removed).dropna()
    interval = median_interval(differences)
    return equivalent(
        differences,
        RETAINED_MARGIN,
        interval,
        generations,
        f"{np.median(champion):.2f} with development, {np.median(removed):.2f} without; difference "
        f"{show(interval)}",
    )


CLAIMS = [
    Claim(
        "external-robustness",
        FAMILY,
        "Evo-Devo robots are more robust to changes of their world.",
        "Discussion",
        "conjectured",
        "not given",
        "relative fitness of run champions, mean over changed friction, gravity, slope and actuation amplitude",
        "Mann-Whitney U, one-sided",
        _robust,
        final=True,
        plan=lambda alpha: power.mann_whitney_trials(0.75, alpha),
        planning="P(Evo-Devo > Evo) = 0.75",
    ),
    Claim(
        "rolling-not-development",
        FAMILY,
        "It is rolling, not development, that makes fast robots robust to control mutations.",
        "not in the paper",
        "not asked",
        "not given",
        "relative fitness after the last control step, fast "
        "champion minus its copy without development mutated by Evo's operator",
        f"equivalence (TOST, signed-rank), margin {RETAINED_MARGIN:g}",
        _removed_walks,
        final=True,
        plan=lambda alpha: power.equivalence_trials(RETAINED_MARGIN, 0.1, alpha),
        planning="no true difference, standard deviation 0.1",
    ),
]
