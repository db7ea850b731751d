"""Claims about when in life robots roll: Fig. 6."""

import numpy as np
import pandas as pd

from .. import power
from ..statistics import median_interval
from ..figures import discovery as figure
from .base import FAST, ROLLING_GENERATIONS, Claim, Outcome, missing, within
from .outcomes import positive, show

FAMILY = "heterochrony"
LATE, EARLY = 0.5, 0.1  # shares of a life: later is the end of life, earlier is at birth [1]
ONE_ROLL = (0.75, 1.25)  # full turns
STEP_OF_ONE_ROLL = (0.5, 2.0)  # "about 1 body length" [body lengths]


def _with_times(measure):
    """A measure of (times by trial: first, champion [s]; lifetime [s]; generations)."""

    def of_study(study):
        archive = study.main("evo_devo")
        if archive is None or study.ancestors().empty:
            return missing("ancestors simulated again")
        generations = archive.horizon().generation
        frame = figure.lineages(study)
        if frame.empty:
            return Outcome(ours=f"no run champion of at least {FAST:g} body lengths", generations=generations)
        return measure(figure.first_and_champion(frame), float(archive.parameters["lifetime"]), generations)

    return of_study


def _late(times, lifetime, generations):
    interval = median_interval(times["first"])
    difference = times["first"] - LATE * lifetime
    return positive(
        difference, interval, generations, f"first ancestor to roll: at {show(interval)} s of {lifetime:g} s"
    )


def _early(times, lifetime, generations):
    interval = median_interval(times["champion"])
    difference = EARLY * lifetime - times["champion"]
    return positive(difference, interval, generations, f"run champion: at {show(interval)} s of {lifetime:g} s")


def _earlier(times, _, generations):
    difference = times["first"] - times["champion"]
    interval = median_interval(difference)
    return positive(difference, interval, generations, f"median {show(interval)} s earlier")


def fast_lineages(study):
    """Ancestors of fast Evo-Devo run champions, with `since`: steps since the first that rolled; NaN: none did."""
    frame = study.ancestors()
    archive = study.main("evo_devo")
    if frame.empty or archive is None:
        return None
    frame = frame[
        (frame["part"] == "main") & (frame["treatment"] == "evo_devo") & frame["trial"].isin(archive.horizon().trials)
    ].sort_values(["trial", "position"])
    champions = frame.groupby("trial").tail(1).set_index("trial")["fitness"]
    frame = frame[frame["trial"].map(champions >= FAST)].copy()
    first = figure.lineages(study)
    first = first[first["x"] == 0].set_index("trial")["position"]
    frame["since"] = frame["position"] - frame["trial"].map(first)
    return frame


def _one_roll(study):
    frame = fast_lineages(study)
    if frame is None:
        return missing("ancestors simulated again")
    generations = study.main("evo_devo").horizon().generation
    gains = {}
    for trial, rows in frame.groupby("trial"):
        turns = rows["turns"].abs().to_numpy()
        fitness = rows["fitness"].to_numpy(dtype=float)
        once = np.flatnonzero((turns[1:] >= ONE_ROLL[0]) & (turns[1:] <= ONE_ROLL[1]) & (turns[:-1] < ONE_ROLL[0]))
        if len(once):  # the first step in the lineage from not rolling to rolling once
            gains[trial] = fitness[once[0] + 1] - fitness[once[0]]
    interval = median_interval(list(gains.values()))
    words = f"median gain {show(interval)} body lengths" if gains else "no step of a lineage from no roll to one"
    return within(
        interval,
        *STEP_OF_ONE_ROLL,
        ours=words,
        trials=len(gains),
        generations=generations,
        trials_needed=power.interval_trials(len(gains), interval.high - interval.low, 0.75),
    )


def shifts(frame):
    """Of each lineage from the first ancestor that rolls: how much of W_L steps closed by moving initial sizes towards
    final ones (progenesis), and the other way round (neoteny) [1]."""
    later = frame[frame["since"] > 0]
    return pd.DataFrame(
        {
            "progenesis": later.groupby("trial")["body_initial_towards_final"].sum(),
            "neoteny": later.groupby("trial")["body_final_towards_initial"].sum(),
        }
    )


def _progenesis(study):
    frame = fast_lineages(study)
    if frame is None:
        return missing("ancestors simulated again")
    generations = study.main("evo_devo").horizon().generation
    moved = shifts(frame)
    if moved.empty:
        return Outcome(ours=f"no run champion of at least {FAST:g} body lengths", generations=generations)
    difference = moved["progenesis"] - moved["neoteny"]
    interval = median_interval(difference)
    return positive(
        difference,
        interval,
        generations,
        f"median closed by progenesis {moved['progenesis'].median():.3f}, by neoteny "
        f"{moved['neoteny'].median():.3f}; difference {show(interval, 3)}",
    )


def _pairs(alpha):
    return power.signed_rank_trials(0.9, alpha)


_EFFECT = "P(sum of two differences > 0) = 0.9"
_ROLLING = "more of the top layer than of the rest touches the floor"

CLAIMS = [
    Claim(
        "first-roll-late",
        FAMILY,
        "The first ancestor to roll does so at the end of its life.",
        "Fig. 6",
        "about 10 s",
        "not given",
        f"time before rolling ({_ROLLING}) of the oldest rolling ancestor of each fast run champion",
        "signed-rank, one-sided: in the second half of life",
        _with_times(_late),
        ROLLING_GENERATIONS,
        plan=_pairs,
        planning=_EFFECT,
    ),
    Claim(
        "champion-rolls-at-birth",
        FAMILY,
        "Run champions roll from birth.",
        "Fig. 6",
        "about 0 s",
        "not given",
        "time before rolling of each fast run champion",
        "signed-rank, one-sided: in the first tenth of life",
        _with_times(_early),
        final=True,
        plan=_pairs,
        planning=_EFFECT,
    ),
    Claim(
        "rolling-comes-earlier",
        FAMILY,
        "Descendants roll earlier in life than the first ancestor that rolled.",
        "Fig. 6",
        "from about 10 s to about 0 s",
        "not given",
        "time of the first ancestor minus the champion's",
        "signed-rank, one-sided",
        _with_times(_earlier),
        ROLLING_GENERATIONS,
        plan=_pairs,
        planning=_EFFECT,
    ),
    Claim(
        "one-roll",
        FAMILY,
        "Rolling once moves a robot by about one body length.",
        "Results",
        "1 body length",
        "not given",
        "gain in fitness at the first step of a lineage from no turn to one (0.75 to 1.25)",
        "95 % interval within 0.5 to 2 body lengths",
        _one_roll,
        ROLLING_GENERATIONS,
    ),
    Claim(
        "progenesis",
        FAMILY,
        "Rolling moves towards birth by progenesis more than by neoteny.",
        "Discussion",
        "qualitative",
        "not given",
        "W_L closed by moving initial sizes minus that by moving final sizes, over the steps "
        "of a lineage after the first that rolls",
        "signed-rank, one-sided",
        _progenesis,
        ROLLING_GENERATIONS,
        plan=_pairs,
        planning=_EFFECT,
    ),
]
