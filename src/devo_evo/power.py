"""How many trials it takes: power of the tests, at effects that are fixed before any data (docs/statistics.md)."""

import math

from scipy import stats

POWER = 0.8
ALPHA = 0.05
MOST = 10000  # trials; beyond, "more" is answer enough


def _quantiles(alpha, power):
    return stats.norm.isf(alpha) + stats.norm.ppf(power)


def fisher_power(share, other, trials, alpha=ALPHA):
    """Power of Fisher's exact test (one-sided), `trials` in each of two groups with these true shares."""
    weights = stats.binom.pmf(range(trials + 1), trials, share)
    others = stats.binom.pmf(range(trials + 1), trials, other)
    power = 0.0
    for count, weight in enumerate(weights):
        if weight < 1e-9:
            continue
        # P(X >= count) given the margins falls as the other group has fewer: rejected up to some number of them.
        for less, probability in enumerate(others):
            if stats.hypergeom.sf(count - 1, 2 * trials, count + less, trials) > alpha:
                break
            power += weight * probability
    return power


def fisher_trials(share, other, alpha=ALPHA, power=POWER):
    """Trials in each group for the power."""
    return _least(lambda trials: fisher_power(share, other, trials, alpha) >= power, 100)


def mann_whitney_trials(superiority, alpha=ALPHA, power=POWER, ratio=1.0):
    """Trials in the first group (Noether 1987). superiority: P(first > second); ratio: second to first in size."""
    share = 1.0 / (1.0 + ratio)
    total = _quantiles(alpha, power) ** 2 / (12.0 * share * (1.0 - share) * (superiority - 0.5) ** 2)
    by_effect = math.ceil(total * share)
    # The smallest p that so many can give.
    by_size = _least(lambda n: 1.0 / math.comb(n + round(ratio * n), n) <= alpha, MOST)
    return max(by_effect, by_size)


def signed_rank_trials(superiority, alpha=ALPHA, power=POWER):
    """Pairs (Noether 1987). superiority: P(the sum of two differences is positive)."""
    by_effect = math.ceil(_quantiles(alpha, power) ** 2 / (3.0 * (superiority - 0.5) ** 2))
    return max(by_effect, math.ceil(-math.log2(alpha)))


def log_rank_trials(hazard_ratio, share_with_event, alpha=ALPHA, power=POWER):
    """Trials in each group, one-sided (Schoenfeld 1981). share_with_event: of both groups together."""
    events = 4.0 * _quantiles(alpha, power) ** 2 / math.log(hazard_ratio) ** 2
    return math.ceil(events / share_with_event / 2.0)


def binomial_trials(share, null_share, alpha=ALPHA, power=POWER):
    """Trials for the exact binomial test of a share below null_share."""

    def enough(trials):
        critical = stats.binom.ppf(alpha, trials, null_share) - 1
        while stats.binom.cdf(critical + 1, trials, null_share) <= alpha:
            critical += 1
        return critical >= 0 and stats.binom.cdf(critical, trials, share) >= power

    return _least(enough, MOST)


def equivalence_trials(margin, deviation, alpha=ALPHA, power=POWER, independent=False):
    """Pairs, or trials in each group, for a TOST of no true difference: as for t-tests, divided by the efficiency of
    rank tests, 3/pi. deviation: standard deviation of the differences, or of each group."""
    groups = 2.0 if independent else 1.0

    def enough(trials):
        freedom = groups * (trials - 1)
        quantile = stats.t.isf(alpha, freedom) + stats.t.isf((1.0 - power) / 2.0, freedom)
        return trials >= groups * (quantile * deviation / margin) ** 2 * math.pi / 3.0 and 0.5**trials <= alpha

    return _least(enough, MOST)


def interval_trials(trials, width, allowed):
    """Trials for an interval that has `width` now to shrink to `allowed`, with the square root of their number."""
    if not trials or not math.isfinite(width) or width <= 0 or allowed <= 0:
        return None
    return min(MOST, max(trials + 1, math.ceil(trials * (width / allowed) ** 2)))


def _least(enough, most):
    for trials in range(2, most + 1):
        if enough(trials):
            return trials
    return most
