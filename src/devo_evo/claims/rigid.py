"""Claims about rigid bodies: Fig. S5."""

import numpy as np
import pandas as pd

from .. import power
from ..figures import rigid as figure
from ..statistics import equivalence_independent, median_interval, median_ratio_interval
from .base import Claim, Outcome, missing
from .canalization import CONTROL_MARGIN, EFFECT, needed
from .outcomes import positive, show

FAMILY = "rigid bodies"
GENERATIONS = 200  # that would do; the paper does not say how long these evolved
LATE = 0.5  # share of a life: later is late, earlier is early [1]
EVOLVABILITY_MARGIN = 1.1  # ratio of the fitness of run champions


def _of_rollers(measure):
    """A measure of (lineages of Evo-Devo run champions that roll, archive, generations)."""

    def of_study(study):
        archive = study.rigid("evo_devo")
        if archive is None:
            return missing("rigid bodies that develop")
        generations = archive.horizon().generation
        frame = figure.lineages(study)
        rolling = frame[frame["fast"]]
        if rolling.empty:
            return Outcome(
                ours=f"none of {frame['trial'].nunique()} run champions turns over once", generations=generations
            )
        return measure(rolling, archive, generations)

    return of_study


def _change(frame, window):
    grouped = frame.groupby("trial")[window]
    return grouped.last() - grouped.first()


def _shrinks(frame, _, generations):
    loss = -_change(frame, "morphology_window")
    interval = median_interval(loss)
    return positive(loss, interval, generations, f"median of founder minus champion {show(interval, 3)}")


def _stays(frame, _, generations):
    change = _change(frame, "control_window")
    interval = median_interval(change)
    return positive(
        change + CONTROL_MARGIN, interval, generations, f"median of champion minus founder {show(interval, 3)}"
    )


def _differential(frame, _, generations):
    differences = _change(frame, "control_window") - _change(frame, "morphology_window")
    interval = median_interval(differences)
    return positive(differences, interval, generations, f"median change of W_Phi minus that of W_L {show(interval, 3)}")


def onsets(frame):
    """When the first ancestor that turns over, be it by half, and the run champion had turned by half [s], by trial."""
    rolling = frame[frame["first_roll_since_birth_s"].notna()]
    grouped = rolling.sort_values("ancestor").groupby("trial")["first_roll_since_birth_s"]
    return pd.DataFrame({"first": grouped.first(), "champion": grouped.last()})


def _late(frame, archive, generations):
    lifetime = float(archive.parameters["rigid_lifetime"])
    times = onsets(frame)
    interval = median_interval(times["first"])
    words = f"first ancestor to roll: on its back at {show(interval)} s of {lifetime:g} s"
    return positive(times["first"] - LATE * lifetime, interval, generations, words)


def _early(frame, archive, generations):
    lifetime = float(archive.parameters["rigid_lifetime"])
    times = onsets(frame)
    interval = median_interval(times["champion"])
    words = f"run champion: on its back at {show(interval)} s of {lifetime:g} s"
    return positive(LATE * lifetime - times["champion"], interval, generations, words)


def _earlier(frame, _, generations):
    times = onsets(frame)
    difference = times["first"] - times["champion"]
    interval = median_interval(difference)
    return positive(difference, interval, generations, f"median {show(interval)} s earlier")


def stray(frame):
    """How far robots stray from the line to the light, in units of their way down [1]."""
    return frame["sideways"].abs() / frame["descent"]


def _guided(_, archive, generations):
    designs = archive.individuals(columns=("trial", "id", "fitness", "turns", "sideways", "descent"), valid_only=True)
    designs = designs[(designs["turns"] >= figure.TURNS) & (designs["descent"] > 0)]
    designs = designs.assign(stray=stray(designs))
    champions = archive.run_champions()
    differences = {}
    for trial, rolling in designs.groupby("trial"):
        own = rolling[rolling["id"] == champions["id"].get(trial)]
        others = rolling[rolling["fitness"] <= rolling["fitness"].median()]
        if len(own) and len(others):
            differences[trial] = float(others["stray"].median() - own["stray"].iloc[0])
    values = np.array(list(differences.values()))
    interval = median_interval(values)
    words = "median of the worse half of rolling designs minus the run champion " + show(interval, 3)
    return positive(values, interval, generations, words)


def _evolvability(study):
    archives = [study.rigid(treatment) for treatment in figure.TREATMENTS]
    if any(archive is None for archive in archives):
        return missing("rigid bodies of both treatments")
    evo, devo = [archive.run_champions()["fitness"] for archive in archives]
    generations = min(archive.horizon().generation for archive in archives)
    interval = median_ratio_interval(devo, evo)
    return Outcome(
        ours=f"ratio of medians, Evo-Devo to Evo, {show(interval)}",
        interval=interval,
        test=equivalence_independent(np.log(devo), np.log(evo), np.log(EVOLVABILITY_MARGIN)),
        refuted=interval.low > EVOLVABILITY_MARGIN or interval.high < 1.0 / EVOLVABILITY_MARGIN,
        trials=min(len(evo), len(devo)),
        generations=generations,
    )


_NOT_GIVEN = "not given"


def _claim(key, statement, estimand, measure, test="signed-rank, one-sided", **details):
    return Claim(
        key,
        FAMILY,
        statement,
        "S5",
        "qualitative",
        _NOT_GIVEN,
        estimand,
        test,
        measure,
        GENERATIONS,
        **{"plan": needed, "planning": EFFECT, **details},
    )


CLAIMS = [
    _claim(
        "rigid-window-loss",
        "In rigid bodies, too, W_L of lineages that find rolling shrinks.",
        "W_L of the founder minus that of the run champion; run champions that turn over at least once",
        _of_rollers(_shrinks),
    ),
    _claim(
        "rigid-control-stays",
        "Their W_Phi does not shrink.",
        "W_Phi of the run champion minus that of its founder",
        _of_rollers(_stays),
        f"signed-rank, one-sided: above \u2212{CONTROL_MARGIN:g}",
        planning="P(sum of two differences > \u22120.2) = 0.9",
    ),
    _claim(
        "rigid-canalization",
        "In rigid bodies, too, the body is canalized and control is not.",
        "change of W_Phi from founder to champion minus that of W_L, within lineages",
        _of_rollers(_differential),
    ),
    _claim(
        "rigid-first-roll-late",
        "The first ancestor to roll does so late in its life.",
        "time of the first half turn of the oldest ancestor that turns over by half at least",
        _of_rollers(_late),
        "signed-rank, one-sided: in the second half of life",
    ),
    _claim(
        "rigid-champion-rolls-early",
        "Its descendants roll early.",
        "time of the first half turn of the run champion",
        _of_rollers(_early),
        "signed-rank, one-sided: in the first half of life",
    ),
    _claim(
        "rigid-earlier",
        "Rolling moves towards birth.",
        "time of the first half turn, oldest ancestor that turns over by half minus run champion, within lineages",
        _of_rollers(_earlier),
    ),
    _claim(
        "rigid-guided",
        "The best controllers guide the roll towards the light.",
        "way sideways per way down, median of the worse half of a trial's rolling designs minus the run champion",
        _of_rollers(_guided),
    ),
    _claim(
        "rigid-evolvability",
        "In rigid bodies development does not change evolvability.",
        "ratio of the fitness of run champions, Evo-Devo to Evo",
        _evolvability,
        f"equivalence (TOST, Mann-Whitney), margin a factor of {EVOLVABILITY_MARGIN:g}",
        final=True,
        plan=lambda alpha: power.equivalence_trials(
            float(np.log(EVOLVABILITY_MARGIN)), 0.085, alpha, independent=True
        ),
        planning="no true difference, standard deviation of a factor of 1.09",
    ),
]
