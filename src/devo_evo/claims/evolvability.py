"""Claims about fitness: Fig. 3, the two basins, time to the fast design."""

import numpy as np

from .. import power, survival
from ..statistics import (
    Interval,
    fisher_exact,
    median_difference_interval,
    median_interval,
    median_ratio_interval,
    binomial,
    share_interval,
)
from ..figures.survival import times_to_fast
from .base import FAST, Claim, Outcome, missing, within
from .outcomes import equivalent, greater, show

FAMILY = "evolvability"
REMOVED_MARGIN = 5.0  # a tenth of what Evo-Devo robots travel in the paper [body lengths]
SLOW_BELOW, FAST_ABOVE, RANGE = 15.0, 50.0, 70.0  # the paper's basins (S3), and where they lie [body lengths]


def arms(study):
    """Archives of Evo and Evo-Devo, and the generations that both have; None if one is missing."""
    evo, devo = study.main("evo"), study.main("evo_devo")
    if evo is None or devo is None:
        return None
    return evo, devo, min(evo.horizon().generation, devo.horizon().generation)


def in_both(measure):
    """A measure of both treatments' run champions (fitness of Evo, of Evo-Devo, generations)."""

    def of_study(study):
        found = arms(study)
        if found is None:
            return missing("the main experiment of both treatments")
        evo, devo, generations = found
        return measure(evo.run_champions()["fitness"].dropna(), devo.run_champions()["fitness"].dropna(), generations)

    return of_study


def _fast_shares(evo, devo, generations):
    fast_evo, fast_devo = int(np.sum(evo >= FAST)), int(np.sum(devo >= FAST))
    share = share_interval(fast_devo, len(devo))
    other = share_interval(fast_evo, len(evo))
    ten_evo, ten_devo = int(np.sum(evo >= 10.0)), int(np.sum(devo >= 10.0))
    return Outcome(
        ours=f"Evo-Devo {fast_devo}/{len(devo)} [{share.low:.0%}, {share.high:.0%}], Evo {fast_evo}/{len(evo)} "
        f"[{other.low:.0%}, {other.high:.0%}]; at the released code's 10 body lengths {ten_devo} and {ten_evo}",
        interval=Interval(share.estimate - other.estimate, share.low - other.high, share.high - other.low),
        test=fisher_exact(fast_devo, len(devo), fast_evo, len(evo)),
        against=fisher_exact(fast_devo, len(devo), fast_evo, len(evo), "less").p,
        trials=min(len(evo), len(devo)),
        generations=generations,
    )


def _final_fitness(evo, devo, generations):
    interval = median_difference_interval(devo, evo)
    return greater(
        devo,
        evo,
        interval,
        generations,
        f"medians {np.median(devo):.2f} and {np.median(evo):.2f}; difference {show(interval)} body lengths",
    )


def _median_within(which, low, high):
    def measure(evo, devo, generations):
        values = evo if which == "evo" else devo
        interval = median_interval(values)
        return within(
            interval,
            low,
            high,
            ours=f"{show(interval)} body lengths",
            trials=len(values),
            trials_needed=power.interval_trials(len(values), interval.high - interval.low, (high - low) / 2),
            generations=generations,
        )

    return in_both(measure)


def _time_to_fast(study):
    found = arms(study)
    if found is None:
        return missing("the main experiment of both treatments")
    (evo, evo_reached), (devo, devo_reached) = times_to_fast(found[0]), times_to_fast(found[1])
    medians = survival.median_time(devo, devo_reached), survival.median_time(evo, evo_reached)
    words = ["never within the run" if np.isinf(median) else f"{median:.0f}" for median in medians]
    return Outcome(
        ours=f"median generation (Kaplan-Meier): Evo-Devo {words[0]} ({devo_reached.sum()} of {len(devo)} trials), "
        f"Evo {words[1]} ({evo_reached.sum()} of {len(evo)})",
        test=survival.log_rank(devo, devo_reached, evo, evo_reached),
        against=survival.log_rank(devo, devo_reached, evo, evo_reached, "later").p,
        trials=min(len(evo), len(devo)),
        generations=found[2],
    )


def _removed(study):
    removed, devo = study.removed(), study.main("evo_devo")
    if removed is None:
        return missing("run champions with their development removed")
    champions = devo.run_champions()["fitness"]
    differences = (champions - removed["fitness"].reindex(champions.index)).dropna()
    interval = median_interval(differences)
    return equivalent(
        differences, REMOVED_MARGIN, interval, devo.horizon().generation, f"median loss {show(interval)} body lengths"
    )


def _removed_against_evo(study):
    removed, found = study.removed(), arms(study)
    if removed is None or found is None:
        return missing("run champions with their development removed, and Evo")
    evo = found[0].run_champions()["fitness"].dropna()
    values = removed["fitness"].dropna()
    ratio = median_ratio_interval(values, evo)
    return greater(values, evo, ratio, found[2], f"ratio of medians {show(ratio)}")


def _basins(evo, devo, generations):
    fitness_of_all = np.concatenate([evo, devo])
    between = int(np.sum((fitness_of_all > SLOW_BELOW) & (fitness_of_all < FAST_ABOVE)))
    slow, fast = int(np.sum(fitness_of_all <= SLOW_BELOW)), int(np.sum(fitness_of_all >= FAST_ABOVE))
    share = (FAST_ABOVE - SLOW_BELOW) / RANGE
    interval = share_interval(between, len(fitness_of_all))
    test = binomial(between, len(fitness_of_all), share, "less")
    if not slow or not fast:  # one basin is no two
        test = type(test)(test.name, 1.0, test.sizes)
    return Outcome(
        ours=f"{slow} slow (at most {SLOW_BELOW:g}), {between} between, {fast} fast (at least {FAST_ABOVE:g} "
        "body lengths); "
        f"share between {interval.estimate:.0%} [{interval.low:.0%}, {interval.high:.0%}]",
        interval=interval,
        test=test,
        against=binomial(between, len(fitness_of_all), share, "greater").p,
        trials=len(fitness_of_all),
        generations=generations,
    )


CLAIMS = [
    Claim(
        "fast-share",
        FAMILY,
        "More Evo-Devo than Evo trials find the fast (rolling) design.",
        "Results",
        "25/30 (83.3 %) against 6/30 (20 %)",
        "22/30 against 10/30",
        "share of run champions of at least 30 body lengths, Evo-Devo minus Evo",
        "Fisher's exact, one-sided",
        in_both(_fast_shares),
        plan=lambda alpha: power.fisher_trials(25 / 30, 6 / 30, alpha),
        planning="25/30 against 6/30",
    ),
    Claim(
        "final-fitness",
        FAMILY,
        "Evo-Devo run champions are faster than those of Evo.",
        "Results, Fig. 3A",
        "over 50 against about 10 body lengths",
        "52.88 [48.18, 55.16] against 12.01 [11.39, 29.73] (90 % intervals)",
        "difference of the median fitness of run champions",
        "Mann-Whitney U, one-sided",
        in_both(_final_fitness),
        plan=lambda alpha: power.mann_whitney_trials(0.8, alpha),
        planning="P(Evo-Devo > Evo) = 0.8",
    ),
    Claim(
        "evo-median",
        FAMILY,
        "Evo robots travel about 10 body lengths in 10 s.",
        "Results, Fig. 3",
        "about 10",
        "12.01 [11.39, 29.73] (90 %)",
        "median fitness of Evo run champions",
        "95 % interval within 5 to 20 body lengths",
        _median_within("evo", 5.0, 20.0),
        final=True,
    ),
    Claim(
        "evo-devo-median",
        FAMILY,
        "Evo-Devo robots travel over 5 body lengths a second.",
        "Results, Fig. 3A",
        "over 50",
        "52.88 [48.18, 55.16] (90 %)",
        "median fitness of Evo-Devo run champions",
        "95 % interval within 40 to 75 body lengths",
        _median_within("evo_devo", 40.0, 75.0),
        final=True,
    ),
    Claim(
        "time-to-fast",
        FAMILY,
        "Evo-Devo takes fewer generations to reach 30 body lengths.",
        "Results, Fig. 3A, S3",
        "not given",
        "medians among those that did: 2,569 [1,555, 5,294] (22 trials) against 5,538 [2,676, 6,902] (10)",
        "generations to a best fitness of 30 body lengths, trials that never did censored",
        "log-rank, one-sided",
        _time_to_fast,
        plan=lambda alpha: power.log_rank_trials(4.0, 0.52, alpha),
        planning="hazard ratio 4, half of all trials fast",
    ),
    Claim(
        "removed",
        FAMILY,
        "Without their development, Evo-Devo run champions are hardly slower.",
        "Results, Fig. 3B",
        "slight decrease, not significant",
        "not given",
        "champion minus its copy frozen at birth, median over trials",
        f"equivalence (TOST, signed-rank), margin {REMOVED_MARGIN:g} body lengths",
        _removed,
        final=True,
        plan=lambda alpha: power.equivalence_trials(REMOVED_MARGIN, 5.0, alpha),
        planning="no true difference, standard deviation 5 body lengths",
    ),
    Claim(
        "removed-against-evo",
        FAMILY,
        "Without development they still are almost five times faster than Evo robots.",
        "Results, Fig. 3B",
        "almost 5 times",
        "not given",
        "ratio of the medians of run champions",
        "Mann-Whitney U, one-sided",
        _removed_against_evo,
        final=True,
        plan=lambda alpha: power.mann_whitney_trials(0.8, alpha),
        planning="P(removed > Evo) = 0.8",
    ),
    Claim(
        "two-basins",
        FAMILY,
        "There are two basins: slow designs, and fast ones that roll, with little between.",
        "Results, S3",
        "slow 5 to 15, fast 50 to 70 body lengths",
        "at most 30: 26, 30 to 65: 24, above 65: 8 of 60",
        "share of run champions of both treatments between 15 and 50 body lengths",
        "exact binomial against the half that an even spread over 0 to 70 would put there; both basins occupied",
        in_both(_basins),
        final=True,
        plan=lambda alpha: power.binomial_trials(0.2, 0.5, alpha),
        planning="a share of 20 % between",
    ),
]
