"""Claims about developmental windows: Fig. 4 and S1."""

import numpy as np
import pandas as pd

from .. import power
from ..statistics import Interval, against_neutral, median_interval
from .base import FAST, ROLLING_GENERATIONS, Claim, Outcome, missing, within
from .outcomes import equivalent, greater, positive, show

FAMILY = "canalization"
CONTROL_MARGIN = 0.1  # of W_Phi; about what drift alone raises it by
NEAR_ZERO = 0.1  # W_L of a canalized body
WINDOWS = ("morphology_window", "control_window")


def courses(study):
    """Windows along the lineages of Evo-Devo run champions: a frame by trial with founder, maximum, last of both, and
    whether the champion is fast."""
    archive = study.main("evo_devo")
    if archive is None:
        return None
    frame = archive.lineages()
    if frame.empty:
        return None
    grouped = frame.groupby("trial")
    result = pd.DataFrame({"fast": grouped["fitness"].last() >= FAST, "length": grouped.size()})
    for window in WINDOWS:
        result[f"{window}_founder"] = grouped[window].first()
        result[f"{window}_maximum"] = grouped[window].max()
        result[f"{window}_last"] = grouped[window].last()
    return result


def on_fast(measure):
    """A measure of the courses of fast lineages (study, courses, generations)."""

    def of_study(study):
        table = courses(study)
        if table is None:
            return missing("lineages of Evo-Devo run champions")
        generations = study.main("evo_devo").horizon().generation
        fast = table[table["fast"]]
        if fast.empty:
            return Outcome(
                ours=f"none of {len(table)} run champions travels {FAST:g} body lengths", generations=generations
            )
        return measure(study, fast, generations)

    return of_study


def neutral_statistics(study, trials, statistic):
    """The statistic (of replicate x position) of the neutral lineages of each trial; None if any is missing."""
    neutral = study.neutral_lineages()
    if any(trial not in neutral for trial in trials):
        return None
    return [statistic(neutral[trial]) for trial in trials]


def _beside_neutral(words, of_course, of_neutral):
    def measure(study, fast, generations):
        observed = of_course(fast)
        interval = median_interval(observed)
        neutral = neutral_statistics(study, fast.index, of_neutral)
        if neutral is None:
            return Outcome(
                ours=f"{words} {show(interval, 3)}; no neutral lineages to compare with",
                interval=interval,
                trials=0,
                missing="neutral lineages of every fast lineage",
                generations=generations,
            )
        typical = np.median(np.concatenate(neutral))
        return Outcome(
            ours=f"{words} {show(interval, 3)}, of neutral lineages {typical:.3f}",
            interval=interval,
            test=against_neutral(observed, neutral),
            against=against_neutral(-observed, [-values for values in neutral]).p,
            trials=len(fast),
            generations=generations,
        )

    return on_fast(measure)


def _rise(window):
    return _beside_neutral(
        "median rise",
        lambda fast: fast[f"{window}_maximum"] - fast[f"{window}_founder"],
        lambda neutral: neutral[window].max(axis=1) - neutral[window][:, 0],
    )


def _fall(window):
    return _beside_neutral(
        "median fall",
        lambda fast: fast[f"{window}_maximum"] - fast[f"{window}_last"],
        lambda neutral: neutral[window].max(axis=1) - neutral[window][:, -1],
    )


def _loss(window):
    return _beside_neutral(
        "median of founder minus champion",
        lambda fast: fast[f"{window}_founder"] - fast[f"{window}_last"],
        lambda neutral: neutral[window][:, 0] - neutral[window][:, -1],
    )


def _near_zero(_, fast, generations):
    interval = median_interval(fast["morphology_window_last"])
    return within(
        interval,
        0.0,
        NEAR_ZERO,
        ours=f"median W_L {show(interval, 3)}",
        trials=len(fast),
        trials_needed=power.interval_trials(len(fast), interval.high - interval.low, NEAR_ZERO / 2),
        generations=generations,
    )


def _control_like_drift(study, fast, generations):
    neutral = neutral_statistics(study, fast.index, lambda windows: windows["control_window"][:, -1])
    if neutral is None:
        return missing("neutral lineages of every fast lineage")
    differences = fast["control_window_last"] - [np.median(values) for values in neutral]
    interval = median_interval(differences)
    founders = median_interval(fast["control_window_last"] - fast["control_window_founder"])
    return equivalent(
        differences,
        CONTROL_MARGIN,
        interval,
        generations,
        f"champion minus neutral median {show(interval, 3)}; minus its founder {show(founders, 3)}",
    )


def _differential(_, fast, generations):
    differences = (fast["control_window_last"] - fast["control_window_founder"]) - (
        fast["morphology_window_last"] - fast["morphology_window_founder"]
    )
    interval = median_interval(differences)
    return positive(differences, interval, generations, f"median change of W_Phi minus that of W_L {show(interval, 3)}")


def _slow_lack_it(study):
    table = courses(study)
    if table is None:
        return missing("lineages of Evo-Devo run champions")
    falls = table["morphology_window_founder"] - table["morphology_window_last"]
    fast, slow = falls[table["fast"]], falls[~table["fast"]]
    generations = study.main("evo_devo").horizon().generation
    if fast.empty or slow.empty:
        return Outcome(ours=f"{len(fast)} fast and {len(slow)} slow lineages", generations=generations)
    interval = Interval(float(fast.median() - slow.median()), float("nan"), float("nan"))
    return greater(
        fast,
        slow,
        interval,
        generations,
        f"W_L of founder minus champion: {len(fast)} fast {fast.median():.3f}, {len(slow)} slow "
        f"{slow.median():.3f}",
    )


def needed(alpha):
    """Lineages or trials for a signed-rank test of EFFECT."""
    return power.signed_rank_trials(0.9, alpha)


def equivalence_needed(alpha):
    """Lineages or trials to show equivalence within CONTROL_MARGIN."""
    return power.equivalence_trials(CONTROL_MARGIN, 0.1, alpha)


_DRIFT = "randomisation against neutral lineages of the same founder, length and mutation rates"
EFFECT = "P(sum of two differences > 0) = 0.9"
_NOT_GIVEN = "not given"

CLAIMS = [
    Claim(
        "window-rise",
        FAMILY,
        "W_L of lineages that find rolling first rises.",
        "Fig. 4A, S1",
        "maximum over founder, p < 0.001",
        _NOT_GIVEN,
        "maximum of W_L in the lineage minus the founder's, beside neutral lineages",
        _DRIFT,
        _rise("morphology_window"),
        ROLLING_GENERATIONS,
        plan=needed,
        planning=EFFECT,
    ),
    Claim(
        "window-fall",
        FAMILY,
        "W_L then falls.",
        "Fig. 4A, S1",
        "to almost zero",
        _NOT_GIVEN,
        "maximum of W_L in the lineage minus the champion's, beside neutral lineages",
        _DRIFT,
        _fall("morphology_window"),
        ROLLING_GENERATIONS,
        plan=needed,
        planning=EFFECT,
    ),
    Claim(
        "window-loss",
        FAMILY,
        "Run champions have much smaller W_L than their founders.",
        "S1",
        "p < 0.001",
        _NOT_GIVEN,
        "W_L of the founder minus the champion's, beside neutral lineages",
        _DRIFT,
        _loss("morphology_window"),
        ROLLING_GENERATIONS,
        plan=needed,
        planning=EFFECT,
    ),
    Claim(
        "window-near-zero",
        FAMILY,
        "W_L of run champions is almost zero.",
        "Fig. 4, S1",
        "almost zero",
        _NOT_GIVEN,
        "median W_L of fast run champions",
        f"95 % interval within 0 to {NEAR_ZERO:g}",
        on_fast(_near_zero),
        final=True,
    ),
    Claim(
        "control-drifts",
        FAMILY,
        "W_Phi of run champions is what drift makes it.",
        "S1",
        "champion against founder not significant; like a random walk",
        _NOT_GIVEN,
        "champion's W_Phi minus the median of its neutral lineages",
        f"equivalence (TOST, signed-rank), margin {CONTROL_MARGIN:g}",
        on_fast(_control_like_drift),
        final=True,
        plan=equivalence_needed,
        planning="no true difference, standard deviation 0.1",
    ),
    Claim(
        "differential",
        FAMILY,
        "The body is canalized while control is not.",
        "Results",
        "qualitative",
        _NOT_GIVEN,
        "change of W_Phi from founder to champion minus that of W_L, within lineages",
        "signed-rank, one-sided",
        on_fast(_differential),
        ROLLING_GENERATIONS,
        plan=needed,
        planning=EFFECT,
    ),
    Claim(
        "slow-lack-it",
        FAMILY,
        "Lineages that stay slow lack the fall of W_L.",
        "S1",
        "5 of 30 trials",
        _NOT_GIVEN,
        "W_L of founder minus champion, fast against slow lineages",
        "Mann-Whitney U, one-sided",
        _slow_lack_it,
        final=True,
        plan=lambda alpha: power.mann_whitney_trials(0.9, alpha, ratio=5.0),
        planning="P(fast > slow) = 0.9, five times as many fast ones",
    ),
]
