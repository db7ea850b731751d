"""The statistics of figures and report (docs/statistics.md): tests, intervals, equivalence, Holm's correction.

Every bootstrap starts from a fixed seed, so the same data give the same numbers.
"""

import dataclasses
import math

import numpy as np
from scipy import stats

SEED = 20180917  # of every bootstrap; the day the paper came out
LEVEL = 0.95  # of intervals, unless said otherwise
RESAMPLES = 5000


@dataclasses.dataclass(frozen=True)
class TestResult:
    """A test of a null hypothesis against the claim."""

    __test__ = False  # no test case, whatever its name begins with

    name: str
    p: float  # NaN if the data do not allow the test
    sizes: tuple  # independent units in each group


@dataclasses.dataclass(frozen=True)
class Interval:
    """An estimate with its confidence interval, all in one unit; NaN where there are no data."""

    estimate: float
    low: float
    high: float


NOTHING = Interval(math.nan, math.nan, math.nan)


def clean(values):
    """As an array of floats, without what is not a number."""
    array = np.asarray(values, dtype=float)
    return array[~np.isnan(array)]


def mann_whitney(greater, smaller, alternative="greater"):
    """Mann-Whitney U between independent groups, by default for the first being greater."""
    first, second = clean(greater), clean(smaller)
    p = math.nan
    if len(first) and len(second):
        p = float(stats.mannwhitneyu(first, second, alternative=alternative).pvalue)
    return TestResult("Mann-Whitney U", p, (len(first), len(second)))


def signed_rank(differences, alternative="greater"):
    """Wilcoxon's signed-rank test of paired differences, by default for them being positive. Zeros rank (Pratt).

    Exact, with ties and zeros too, which SciPy's exact distribution does not know: given the ranks, every difference is
    as likely positive as negative.
    """
    values = clean(differences) * (1.0 if alternative == "greater" else -1.0)
    ranks = np.round(2.0 * stats.rankdata(np.abs(values))).astype(int)[values != 0]  # doubled: ties have halves
    positive = values[values != 0] > 0
    chances = np.ones(1)  # of each sum of the ranks of positive differences
    for rank in ranks:
        longer = np.zeros(len(chances) + rank)
        longer[: len(chances)] += 0.5 * chances
        longer[rank:] += 0.5 * chances
        chances = longer
    p = float(min(1.0, chances[int(ranks[positive].sum()) :].sum())) if len(values) else math.nan
    return TestResult("Wilcoxon signed-rank", p, (len(values),))


def fisher_exact(successes, total, other_successes, other_total, alternative="greater"):
    """Fisher's exact test of two shares, by default for the first being greater."""
    p = math.nan
    if total and other_total:
        table = [[successes, total - successes], [other_successes, other_total - other_successes]]
        p = float(stats.fisher_exact(table, alternative=alternative)[1])
    return TestResult("Fisher's exact", p, (total, other_total))


def binomial(successes, total, share=0.5, alternative="greater"):
    """Exact binomial test of a share."""
    p = float(stats.binomtest(successes, total, share, alternative=alternative).pvalue) if total else math.nan
    return TestResult("exact binomial", p, (total,))


def equivalence_paired(differences, margin):
    """Whether paired differences lie within +-margin: two one-sided signed-rank tests (TOST); p is the larger one."""
    values = clean(differences)
    lower = signed_rank(values + margin).p
    upper = signed_rank(margin - values).p
    return TestResult(
        f"TOST, signed-rank, margin {margin:g}", max(lower, upper) if len(values) else math.nan, (len(values),)
    )


def equivalence_independent(values, others, margin):
    """Whether two independent groups differ by less than +-margin: two one-sided Mann-Whitney tests (TOST)."""
    first, second = clean(values), clean(others)
    lower = mann_whitney(first + margin, second).p
    upper = mann_whitney(second + margin, first).p
    return TestResult(
        f"TOST, Mann-Whitney, margin {margin:g}",
        max(lower, upper) if len(first) and len(second) else math.nan,
        (len(first), len(second)),
    )


def against_neutral(observed, neutral, draws=19999):
    """Whether a statistic of lineages is larger, on average, than that of neutral lineages: a randomisation test.

    observed: of each lineage. neutral: for each lineage, that of its neutral replicates. Under the null hypothesis a
    lineage is exchangeable with its replicates, so the mean over lineages is compared with means over one draw from
    each lineage and its replicates. The test is exact, whatever the distributions.
    """
    pools = [
        np.concatenate([[value], clean(replicates)])
        for value, replicates in zip(observed, neutral)
        if not np.isnan(value) and len(clean(replicates))
    ]
    p = math.nan
    if pools:
        random = np.random.default_rng(SEED)
        means = np.mean([pool[random.integers(len(pool), size=draws)] for pool in pools], axis=0)
        actual = np.mean([pool[0] for pool in pools])
        tolerance = 1e-12  # the mean of the observed values themselves may be summed in another order
        p = (1 + int(np.sum(means >= actual - tolerance))) / (draws + 1)
    return TestResult("randomisation, neutral lineages", p, (len(pools),))


def holm(p_values):
    """Holm's adjusted p of a family of claims, in their order. NaN (no test was possible) stays, and does not count."""
    p = np.asarray(p_values, dtype=float)
    adjusted = np.full(len(p), math.nan)
    tested = np.flatnonzero(~np.isnan(p))
    largest = 0.0
    for rank, index in enumerate(tested[np.argsort(p[tested], kind="stable")]):
        largest = max(largest, min(1.0, (len(tested) - rank) * p[index]))
        adjusted[index] = largest
    return adjusted


def median_interval(values, level=LEVEL, resamples=RESAMPLES):
    """Median and its percentile bootstrap interval."""
    return statistic_interval(values, np.median, level, resamples)


def statistic_interval(values, statistic, level=LEVEL, resamples=RESAMPLES):
    """A statistic (called with `axis`) of independent units and its percentile bootstrap interval."""
    sample = clean(values)
    if not len(sample):
        return NOTHING
    drawn = _draws(len(sample), resamples)
    low, high = _percentiles(statistic(sample[drawn], axis=1), level)
    return Interval(float(statistic(sample, axis=0)), low, high)


def median_difference_interval(values, others, level=LEVEL, resamples=RESAMPLES):
    """Difference of the medians of two independent groups, both resampled."""
    first, second = clean(values), clean(others)
    if not len(first) or not len(second):
        return NOTHING
    random = np.random.default_rng(SEED)
    differences = np.median(first[random.integers(len(first), size=(resamples, len(first)))], axis=1) - np.median(
        second[random.integers(len(second), size=(resamples, len(second)))], axis=1
    )
    low, high = _percentiles(differences, level)
    return Interval(float(np.median(first) - np.median(second)), low, high)


def median_ratio_interval(values, others, level=LEVEL, resamples=RESAMPLES):
    """Ratio of the medians of two independent groups, both resampled; NaN where the second median is not positive."""
    first, second = clean(values), clean(others)
    if not len(first) or not len(second) or np.median(second) <= 0:
        return NOTHING
    random = np.random.default_rng(SEED)
    over = np.median(first[random.integers(len(first), size=(resamples, len(first)))], axis=1)
    under = np.median(second[random.integers(len(second), size=(resamples, len(second)))], axis=1)
    low, high = _percentiles(over / np.where(under > 0, under, math.nan), level)
    return Interval(float(np.median(first) / np.median(second)), low, high)


def share_interval(successes, total, level=LEVEL):
    """A share and its exact (Clopper-Pearson) interval."""
    if not total:
        return NOTHING
    exact = stats.binomtest(successes, total).proportion_ci(level, method="exact")
    return Interval(successes / total, float(exact.low), float(exact.high))


def median_curve(table, level=LEVEL, resamples=RESAMPLES):
    """Median and percentile bootstrap band of curves. table: unit x point. Whole units are resampled.

    Returns median, low, high, each per point. Points at which a unit has no value use the others.
    """
    table = np.asarray(table, dtype=float)
    return _curve(table, _draws(table.shape[0], resamples), level)


def clustered_median_curve(table, clusters, level=LEVEL, resamples=RESAMPLES):
    """As `median_curve`, but what is resampled is clusters of units, such as all walks of one champion.

    clusters: of each unit, a label.
    """
    table = np.asarray(table, dtype=float)
    labels = np.asarray(clusters)
    members = [np.flatnonzero(labels == label) for label in np.unique(labels)]
    sizes = {len(cluster) for cluster in members}
    if len(sizes) == 1:
        drawn = np.array(members)[_draws(len(members), resamples)].reshape(resamples, -1)
        return _curve(table, drawn, level)
    random = np.random.default_rng(SEED)
    medians = np.array(
        [
            np.nanmedian(
                table[np.concatenate([members[i] for i in random.integers(len(members), size=len(members))])], axis=0
            )
            for _ in range(resamples)
        ]
    )
    low, high = _percentiles(medians, level, axis=0)
    return np.nanmedian(table, axis=0), low, high


def _curve(table, drawn, level):
    points = table.shape[1]
    low, high = np.empty(points), np.empty(points)
    lacks = np.isnan(table).any(axis=0)
    for point in range(points):  # a column at a time: all at once would not fit into memory
        column = table[:, point]
        if point and not lacks[point] and np.array_equal(column, table[:, point - 1]):
            low[point], high[point] = low[point - 1], high[point - 1]
            continue
        samples = column[drawn]
        if lacks[point]:
            samples = samples[~np.isnan(samples).all(axis=1)]  # draws of those only that have no value here
        low[point], high[point] = _percentiles(
            (np.nanmedian if lacks[point] else np.median)(samples, axis=1), level
        )
    return np.nanmedian(table, axis=0), low, high


def _draws(size, resamples):
    return np.random.default_rng(SEED).integers(size, size=(resamples, size))


def _percentiles(values, level, axis=None):
    outside = 100.0 * (1.0 - level) / 2.0
    low, high = np.nanpercentile(values, [outside, 100.0 - outside], axis=axis)
    return (float(low), float(high)) if axis is None else (low, high)
