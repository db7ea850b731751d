"""Claims about random walks: Fig. 5. Ten walks of one champion are one unit: the median of them."""

import numpy as np

from .. import power
from ..statistics import median_difference_interval, median_interval
from ..figures import walks as figure
from .base import Claim, Outcome, missing
from .outcomes import greater, positive, show

FAMILY = "walks"
HALF = 0.5  # of the champion's fitness: less is broken, more is most of it [1]
FEW_STEPS = 5  # "the first few"
NAMES = {"evo": "Evo", "evo_devo": "Evo-Devo", "fast": "fast Evo-Devo", "slow": "slow Evo-Devo"}


def retained(study, space, series, step=None):
    """Relative fitness [1] of each champion after a step (default: the last of all walks), median over its walks, and
    the step. A step that failed is 0."""
    rows = figure.select(figure.usable(study), space, series)
    if rows.empty:
        return rows["relative"], 0
    last = int(rows.groupby(["trial", "walk"])["step"].max().min())
    step = last if step is None else min(step, last)
    at_step = rows[rows["step"] == step]
    return at_step.assign(relative=at_step["relative"].fillna(0.0)).groupby("trial")["relative"].median(), step


def _generations(study):
    found = [study.main(treatment) for treatment in ("evo", "evo_devo")]
    return min((archive.horizon().generation for archive in found if archive is not None), default=0)


def _against_half(space, series, step, breaks):
    def measure(study):
        if figure.usable(study).empty:
            return missing("random walks")
        values, at = retained(study, space, series, step)
        generations = _generations(study)
        if not len(values):
            return Outcome(ours=f"no {NAMES[series]} run champions", generations=generations)
        interval = median_interval(values)
        difference = HALF - values if breaks else values - HALF
        return positive(difference, interval, generations, f"{show(interval)} of the fitness is left after step {at}")

    return measure


def _more_left(space, more, less):
    def measure(study):
        if figure.usable(study).empty:
            return missing("random walks")
        first, step = retained(study, space, more)
        second, _ = retained(study, space, less)
        generations = _generations(study)
        if not len(first) or not len(second):
            return Outcome(
                ours=f"{len(first)} {NAMES[more]} and {len(second)} {NAMES[less]} run champions",
                generations=generations,
            )
        interval = median_difference_interval(first, second)
        return greater(
            first,
            second,
            interval,
            generations,
            f"{np.median(first):.2f} against {np.median(second):.2f} is left after step {step}; difference "
            f"{show(interval)}",
        )

    return measure


def _pairs(alpha):
    return power.signed_rank_trials(0.9, alpha)


_EFFECT = "P(sum of two differences > 0) = 0.9"


def _half_claim(key, statement, panel, space, series, step, breaks=True):
    what = "less" if breaks else "more"
    return Claim(
        key,
        FAMILY,
        statement,
        f"Fig. 5{panel}",
        "qualitative",
        "not given",
        f"relative fitness after {'step ' + str(step) if step else 'the last step'}, {NAMES[series]} run champions",
        f"signed-rank, one-sided: {what} than half",
        _against_half(space, series, step, breaks),
        final=True,
        plan=_pairs,
        planning=_EFFECT,
    )


CLAIMS = [
    _half_claim("control-breaks-evo", "The first control mutation immobilises Evo robots.", "A", "control", "evo", 1),
    _half_claim(
        "control-spares-evo-devo",
        "Evo-Devo robots keep most of their function after many control mutations (1,000 in the paper).",
        "A",
        "control",
        "evo_devo",
        None,
        breaks=False,
    ),
    Claim(
        "control-robustness",
        FAMILY,
        "Evo-Devo bodies are more robust to control mutations than Evo bodies.",
        "Fig. 5A",
        "qualitative",
        "not given",
        "relative fitness after the last step, difference of medians over champions",
        "Mann-Whitney U, one-sided",
        _more_left("control", "evo_devo", "evo"),
        final=True,
        plan=lambda alpha: power.mann_whitney_trials(0.8, alpha),
        planning="P(Evo-Devo > Evo) = 0.8",
    ),
    Claim(
        "fast-are-robust",
        FAMILY,
        "Fast Evo-Devo designs are robust to control mutations, slow ones are not.",
        "Fig. 5B",
        "25 fast, 5 slow",
        "not given",
        "relative fitness after the last step, difference of medians over champions",
        "Mann-Whitney U, one-sided",
        _more_left("control", "fast", "slow"),
        final=True,
        plan=lambda alpha: power.mann_whitney_trials(0.95, alpha, ratio=5.0),
        planning="P(fast > slow) = 0.95, five times as many fast ones",
    ),
    _half_claim(
        "control-breaks-slow", "The first control mutation breaks slow Evo-Devo designs.", "B", "control", "slow", 1
    ),
    _half_claim(
        "body-breaks-evo", "The first few body mutations immobilise Evo robots.", "C", "body", "evo", FEW_STEPS
    ),
    _half_claim(
        "body-breaks-evo-devo",
        "The first few body mutations immobilise Evo-Devo robots.",
        "C",
        "body",
        "evo_devo",
        FEW_STEPS,
    ),
    _half_claim(
        "body-breaks-fast", "Fast Evo-Devo designs are sensitive to body mutations.", "D", "body", "fast", FEW_STEPS
    ),
    _half_claim("body-breaks-slow", "So are slow ones.", "D", "body", "slow", FEW_STEPS),
]
