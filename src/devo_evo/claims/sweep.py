"""Claims about fixed mutation rates: Fig. S3."""

from fractions import Fraction

import numpy as np

from .. import power, survival
from ..mutation_impact import LAMBDAS
from ..statistics import TestResult, equivalence_independent, fisher_exact, median_difference_interval
from ..figures.survival import times_to_fast
from .base import FAST, Claim, Outcome, missing
from .outcomes import greater, show

FAMILY = "sweep"
TIME_MARGIN = 0.1  # share of the run's generations
LOW, HIGH = LAMBDAS[:4], LAMBDAS[5:]  # up to 1/6, from 1/2


def arm(study, treatment, rate):
    """The archive of the sweep at the rate nearest to `rate`; None if there is none."""
    for (name, other), archive in study.sweep().items():
        if name == treatment and abs(other - rate) < 1e-6:
            return archive
    return None


def _both(measure):
    def at(rate):
        def of_study(study):
            evo, devo = arm(study, "evo", rate), arm(study, "evo_devo", rate)
            if evo is None or devo is None:
                return missing(f"the sweep at lambda = {name_of(rate)}")
            return measure(evo, devo, min(evo.horizon().generation, devo.horizon().generation))

        return of_study

    return at


def name_of(rate):
    """The rate as a fraction, such as "1/6"."""
    return str(Fraction(rate).limit_denominator(48))


def _reached(evo_reached, devo_reached):
    return (
        f"30 body lengths reached by {int(devo_reached.sum())} of {len(devo_reached)} Evo-Devo and "
        f"{int(evo_reached.sum())} of {len(evo_reached)} Evo trials"
    )


def _sooner(evo, devo, generations):
    (evo_times, evo_reached), (devo_times, devo_reached) = times_to_fast(evo), times_to_fast(devo)
    return Outcome(
        ours=_reached(evo_reached, devo_reached),
        test=survival.log_rank(devo_times, devo_reached, evo_times, evo_reached),
        against=survival.log_rank(devo_times, devo_reached, evo_times, evo_reached, "later").p,
        trials=min(len(evo_times), len(devo_times)),
        generations=generations,
    )


def _as_soon(evo, devo, generations):
    (evo_times, evo_reached), (devo_times, devo_reached) = times_to_fast(evo), times_to_fast(devo)
    margin = TIME_MARGIN * generations
    interval = median_difference_interval(evo_times, devo_times)
    test = equivalence_independent(evo_times, devo_times, margin)
    if not evo_reached.any() and not devo_reached.any():  # nothing happened, which is not "as soon"
        test = TestResult(test.name, 1.0, test.sizes)
    return Outcome(
        ours=f"{_reached(evo_reached, devo_reached)}; difference of median generations {show(interval, 0)}",
        interval=interval,
        test=test,
        refuted=interval.low > margin or interval.high < -margin,
        trials=min(len(evo_times), len(devo_times)),
        generations=generations,
    )


def _best_beats_random(rate):
    def measure(study):
        devo, random = arm(study, "evo_devo", rate), arm(study, "evo", 1.0)
        if devo is None or random is None:
            return missing(f"the sweep at lambda = {name_of(rate)} (Evo-Devo) and 1 (Evo)")
        better, others = devo.run_champions()["fitness"].dropna(), random.run_champions()["fitness"].dropna()
        interval = median_difference_interval(better, others)
        return greater(
            better,
            others,
            interval,
            min(devo.horizon().generation, random.horizon().generation),
            f"medians {better.median():.2f} and {others.median():.2f}; difference {show(interval)} body lengths",
        )

    return measure


def _champions(study, rates):
    """Fitness of all run champions at these rates, and the least generations. None: an arm is missing."""
    values, generations = [], []
    for treatment in ("evo", "evo_devo"):
        for rate in rates:
            archive = arm(study, treatment, rate)
            if archive is None:
                return None, 0
            values.append(archive.run_champions()["fitness"].dropna().to_numpy())
            generations.append(archive.horizon().generation)
    return np.concatenate(values), min(generations)


def _finds(study):
    (low, generations), (high, others) = _champions(study, LOW), _champions(study, HIGH)
    if low is None or high is None:
        return missing("the whole sweep")
    fast_low, fast_high = int(np.sum(low >= FAST)), int(np.sum(high >= FAST))
    return Outcome(
        ours=f"{fast_high}/{len(high)} fast at lambda >= 1/2, {fast_low}/{len(low)} at lambda <= 1/6",
        test=fisher_exact(fast_high, len(high), fast_low, len(low)),
        against=fisher_exact(fast_low, len(low), fast_high, len(high)).p,
        trials=min(len(low), len(high)),
        generations=min(generations, others),
    )


def _refines(study):
    (low, generations), (high, others) = _champions(study, LOW), _champions(study, HIGH)
    if low is None or high is None:
        return missing("the whole sweep")
    low, high = low[low < FAST], high[high < FAST]
    interval = median_difference_interval(low, high)
    return greater(
        low,
        high,
        interval,
        min(generations, others),
        f"slow run champions: difference of medians {show(interval)} body lengths",
    )


def _sooner_claim(rate):
    return Claim(
        f"sooner-{name_of(rate)}",
        FAMILY,
        f"Evo needs more generations than Evo-Devo at λ = {name_of(rate)}.",
        "S3",
        "qualitative",
        "not given",
        "generations to a best fitness of 30 body lengths, trials that never did censored",
        "log-rank, one-sided",
        _both(_sooner)(rate),
        plan=lambda alpha: power.log_rank_trials(4.0, 0.5, alpha),
        planning="hazard ratio 4, half of all trials fast",
    )


CLAIMS = (
    [_sooner_claim(rate) for rate in LAMBDAS[3:7]]
    + [
        Claim(
            "as-soon-1",
            FAMILY,
            "At λ = 1, Evo does not need more generations than Evo-Devo.",
            "S3",
            "qualitative",
            "not given",
            "generations to 30 body lengths (the whole run if never), Evo minus Evo-Devo",
            f"equivalence (TOST, Mann-Whitney), margin {TIME_MARGIN:.0%} of the run",
            _both(_as_soon)(1.0),
            final=True,
            plan=lambda alpha: power.equivalence_trials(TIME_MARGIN, 0.1, alpha, independent=True),
            planning="no true difference, standard deviation a tenth of the run",
        )
    ]
    + [
        Claim(
            f"best-{name_of(rate)}",
            FAMILY,
            f"Evo-Devo at λ = {name_of(rate)} ends faster than random search (Evo at λ = 1).",
            "S3",
            "p < 0.01",
            "not given",
            "difference of the median fitness of run champions",
            "Mann-Whitney U, one-sided",
            _best_beats_random(rate),
            final=True,
            plan=lambda alpha: power.mann_whitney_trials(0.75, alpha),
            planning="P(Evo-Devo > Evo) = 0.75",
        )
        for rate in (0.5, 2 / 3)
    ]
    + [
        Claim(
            "high-rates-find",
            FAMILY,
            "Higher mutation rates find rolling more often.",
            "S3",
            "qualitative",
            "not given",
            "share of run champions of at least 30 body lengths, λ ≥ 1/2 minus λ ≤ 1/6, both treatments",
            "Fisher's exact, one-sided",
            _finds,
            final=True,
            plan=lambda alpha: power.fisher_trials(0.8, 0.4, alpha),
            planning="80 % against 40 %",
        ),
        Claim(
            "low-rates-refine",
            FAMILY,
            "Lower mutation rates refine better: slow designs are faster.",
            "S3",
            "qualitative",
            "not given",
            "median fitness of slow run champions, λ ≤ 1/6 minus λ ≥ 1/2, both treatments",
            "Mann-Whitney U, one-sided",
            _refines,
            final=True,
            plan=lambda alpha: power.mann_whitney_trials(0.8, alpha),
            planning="P(low > high) = 0.8",
        ),
    ]
)
