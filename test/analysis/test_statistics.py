#!/usr/bin/python3
"""The statistics, against hand-worked numbers, published examples and simulations."""

import math
import unittest

import numpy as np
import scipy.stats

from devo_evo import mutation_impact, power, statistics, survival


class TestsTest(unittest.TestCase):
    def test_mann_whitney_of_three_against_three_is_one_in_twenty(self):
        self.assertAlmostEqual(statistics.mann_whitney([4, 5, 6], [1, 2, 3]).p, 1 / 20)
        self.assertAlmostEqual(statistics.mann_whitney([1, 2, 3], [4, 5, 6]).p, 1.0)

    def test_signed_rank_of_five_positive_differences_is_one_in_thirty_two(self):
        self.assertAlmostEqual(statistics.signed_rank([1, 2, 3, 4, 5]).p, 1 / 32)
        self.assertEqual(statistics.signed_rank([0, 0, 0]).p, 1.0)

    def test_signed_rank_is_exact_with_ties_and_zeros(self):
        # Ranks 1 (the zero), 2.5, 2.5, 4; sums of positive ranks of the eight signs: only 9 is as large.
        self.assertAlmostEqual(statistics.signed_rank([0, 1, 1, 2]).p, 1 / 8)
        self.assertAlmostEqual(statistics.signed_rank([0, 1, -1, 2]).p, 3 / 8)  # 6.5 or 9: the ones may change places
        values = np.random.default_rng(2).normal(0.3, 1.0, 25)
        self.assertAlmostEqual(
            statistics.signed_rank(values).p, scipy.stats.wilcoxon(values, alternative="greater", mode="exact").pvalue
        )
        self.assertAlmostEqual(statistics.signed_rank(-values, "less").p, statistics.signed_rank(values).p)

    def test_fisher_of_the_papers_counts(self):
        self.assertAlmostEqual(statistics.fisher_exact(25, 30, 6, 30, "two-sided").p, 1.5e-6, delta=0.1e-6)

    def test_values_that_are_missing_do_not_count(self):
        result = statistics.mann_whitney([4, 5, math.nan, 6], [1, 2, 3])
        self.assertEqual((result.sizes, round(result.p, 12)), ((3, 3), 0.05))
        for result in (
            statistics.mann_whitney([], [1]),
            statistics.signed_rank([]),
            statistics.fisher_exact(0, 0, 1, 2),
            statistics.equivalence_paired([], 1),
            statistics.equivalence_independent([1], [], 1),
        ):
            self.assertTrue(math.isnan(result.p), result.name)

    def test_holm_as_worked_by_hand(self):
        np.testing.assert_allclose(
            statistics.holm([0.01, 0.04, 0.03, math.nan, 0.005]), [0.03, 0.06, 0.06, math.nan, 0.02]
        )
        np.testing.assert_allclose(statistics.holm([0.9, 0.8]), [1.0, 1.0])
        self.assertEqual(len(statistics.holm([])), 0)

    def test_equivalence_needs_the_differences_within_the_margin(self):
        near = np.linspace(-1.0, 1.0, 20)
        self.assertLess(statistics.equivalence_paired(near, 3.0).p, 0.001)
        self.assertGreater(statistics.equivalence_paired(near + 3.0, 3.0).p, 0.4)
        self.assertLess(statistics.equivalence_independent(near, near + 0.1, 3.0).p, 0.001)
        self.assertGreater(statistics.equivalence_independent(near, near + 5.0, 3.0).p, 0.9)

    def test_no_difference_is_not_shown_by_few_trials(self):
        self.assertGreater(statistics.equivalence_paired([0.1, -0.1, 0.0], 3.0).p, 0.05)


class IntervalsTest(unittest.TestCase):
    def test_median_interval_holds_the_median_and_is_always_the_same(self):
        values = np.arange(31.0)
        interval = statistics.median_interval(values)
        self.assertEqual(interval, statistics.median_interval(values))
        self.assertEqual(interval.estimate, 15.0)
        self.assertTrue(7.0 <= interval.low <= 12.0 and 18.0 <= interval.high <= 23.0, interval)

    def test_of_one_value_the_interval_is_that_value(self):
        self.assertEqual(statistics.median_interval([3.0]), statistics.Interval(3.0, 3.0, 3.0))
        self.assertTrue(math.isnan(statistics.median_interval([]).estimate))

    def test_nineteen_of_twenty_intervals_hold_the_truth(self):
        random = np.random.default_rng(3)
        covered = 0
        for _ in range(400):
            interval = statistics.median_interval(random.normal(size=30), resamples=500)
            covered += interval.low <= 0.0 <= interval.high
        self.assertTrue(0.90 <= covered / 400 <= 0.98, covered / 400)

    def test_share_interval_is_clopper_and_pearsons(self):
        interval = statistics.share_interval(25, 30)
        np.testing.assert_allclose((interval.low, interval.high), (0.6528, 0.9436), atol=1e-4)

    def test_walks_of_one_champion_are_one_unit(self):
        # Ten champions with ten equal walks each: no narrower than ten single walks.
        values = np.random.default_rng(1).normal(size=10)
        table, clusters = np.repeat(values, 10)[:, np.newaxis], np.repeat(np.arange(10), 10)
        _, low, high = statistics.clustered_median_curve(table, clusters, resamples=2000)
        _, naive_low, naive_high = statistics.median_curve(table, resamples=2000)
        self.assertGreater(high[0] - low[0], 2.0 * (naive_high[0] - naive_low[0]))

    def test_clusters_of_unequal_size_are_resampled_whole(self):
        table = np.array([[1.0], [1.0], [1.0], [9.0]])
        median, low, high = statistics.clustered_median_curve(table, [0, 0, 0, 1], resamples=500)
        self.assertEqual((median[0], low[0], high[0]), (1.0, 1.0, 9.0))

    def test_a_point_that_one_unit_has_is_that_units(self):
        table = np.array([[1.0, np.nan], [2.0, np.nan], [3.0, 7.0]])
        _, low, high = statistics.median_curve(table, resamples=200)  # most draws leave that unit out
        self.assertEqual((low[1], high[1]), (7.0, 7.0))

    def test_a_curve_uses_the_units_it_has(self):
        table = np.array([[1.0, 2.0], [3.0, math.nan], [5.0, 4.0]])
        median, _, _ = statistics.median_curve(table, resamples=200)
        np.testing.assert_array_equal(median, [3.0, 3.0])


class NeutralTest(unittest.TestCase):
    def test_false_positives_are_as_rare_as_they_should_be(self):
        random = np.random.default_rng(11)
        p_values = []
        for _ in range(300):  # skewed, and of another distribution in each lineage
            pools = [random.exponential(scale, size=41) for scale in (0.1, 1.0, 3.0, 0.5, 2.0)]
            p_values.append(
                statistics.against_neutral([pool[0] for pool in pools], [pool[1:] for pool in pools], draws=999).p
            )
        for level in (0.05, 0.2, 0.5):
            rate = np.mean(np.array(p_values) <= level)
            self.assertLess(abs(rate - level), 3.0 * math.sqrt(level * (1 - level) / 300), f"{rate} at {level}")

    def test_a_rise_that_no_neutral_lineage_has_is_found(self):
        neutral = [np.random.default_rng(n).normal(size=30) for n in range(6)]
        self.assertLess(statistics.against_neutral([5.0] * 6, neutral).p, 1e-3)
        self.assertGreater(statistics.against_neutral([-5.0] * 6, neutral).p, 0.999)
        self.assertTrue(math.isnan(statistics.against_neutral([], []).p))


class SurvivalTest(unittest.TestCase):
    # Remission of leukaemia in weeks (Freireich et al. 1963, in every textbook); True: it ended.
    TREATED = (
        [6, 6, 6, 6, 7, 9, 10, 10, 11, 13, 16, 17, 19, 20, 22, 23, 25, 32, 32, 34, 35],
        [True] * 3 + [False, True, False, True, False, False] + [True, True] + [False] * 3 + [True, True] + [False] * 5,
    )
    PLACEBO = ([1, 1, 2, 2, 3, 4, 4, 5, 5, 8, 8, 8, 8, 11, 11, 12, 12, 15, 17, 22, 23], [True] * 21)

    def test_kaplan_meier_of_a_textbooks_data(self):
        curve = survival.kaplan_meier(*self.TREATED).set_index("time")
        np.testing.assert_allclose(
            curve.loc[[6, 7, 10, 13, 16, 22, 23], "survival"],
            [0.857, 0.807, 0.753, 0.690, 0.627, 0.538, 0.448],
            atol=5e-4,
        )
        self.assertEqual(survival.median_time(*self.TREATED), 23)
        self.assertEqual(survival.median_time(*self.PLACEBO), 8)

    def test_log_rank_of_a_textbooks_data(self):
        # The two-sided chi-squared is 16.79 in the textbooks.
        p = survival.log_rank(*self.PLACEBO, *self.TREATED).p
        self.assertAlmostEqual(p, 0.5 * math.erfc(math.sqrt(16.79 / 2)), delta=1e-7)
        self.assertAlmostEqual(survival.log_rank(*self.PLACEBO, *self.TREATED, "later").p, 1 - p)

    def test_without_events_nothing_is_told(self):
        self.assertTrue(math.isinf(survival.median_time([5, 5], [False, False])))
        self.assertTrue(math.isnan(survival.log_rank([5], [False], [5], [False]).p))


class PowerTest(unittest.TestCase):
    def test_fisher_power_is_that_of_simulated_trials(self):
        random = np.random.default_rng(5)
        rejected = [
            statistics.fisher_exact(*(int(x) for x in (a, 12, b, 12))).p <= 0.05
            for a, b in zip(random.binomial(12, 0.8, 2000), random.binomial(12, 0.2, 2000))
        ]
        self.assertAlmostEqual(power.fisher_power(0.8, 0.2, 12), np.mean(rejected), delta=0.03)

    def test_the_numbers_given_have_the_power(self):
        trials = power.fisher_trials(25 / 30, 6 / 30)
        self.assertGreaterEqual(power.fisher_power(25 / 30, 6 / 30, trials), 0.8)
        self.assertLess(power.fisher_power(25 / 30, 6 / 30, trials - 1), 0.8)
        random = np.random.default_rng(6)
        trials = power.mann_whitney_trials(0.8)  # P(X > Y) = 0.8 for normal deviates 1.19 apart
        rejected = [
            statistics.mann_whitney(random.normal(1.19, 1, trials), random.normal(0, 1, trials)).p <= 0.05
            for _ in range(400)
        ]
        self.assertGreater(np.mean(rejected), 0.74)
        trials = power.equivalence_trials(1.0, 1.0)
        accepted = [statistics.equivalence_paired(random.normal(0, 1, trials), 1.0).p <= 0.05 for _ in range(400)]
        self.assertGreater(np.mean(accepted), 0.74)

    def test_the_smallest_p_that_so_many_trials_can_give_is_small_enough(self):
        self.assertGreaterEqual(power.signed_rank_trials(1.0, 0.001), 10)  # 2^-10 < 0.001
        self.assertLessEqual(
            1.0 / math.comb(2 * power.mann_whitney_trials(1.0, 0.001), power.mann_whitney_trials(1.0, 0.001)), 0.001
        )


class MutationImpactTest(unittest.TestCase):
    def test_numbers_of_selected_traits_as_tabulated(self):
        np.testing.assert_allclose(
            mutation_impact.selected_traits(4)[1:], [0.738281, 0.210938, 0.046875, 0.003906], atol=1e-6
        )
        np.testing.assert_allclose(
            mutation_impact.selected_traits(4, "released_code")[1:], [0.617143, 0.308571, 0.068571, 0.005714], atol=1e-6
        )
        for n in (1, 2, 4, 8):
            for profile in ("paper", "released_code"):
                chances = mutation_impact.selected_traits(n, profile)
                self.assertAlmostEqual(chances.sum(), 1.0)
                self.assertAlmostEqual(chances @ np.arange(n + 1), mutation_impact.expected_traits(n, profile))

    def test_changed_voxels_as_tabulated(self):
        rates = np.array(mutation_impact.LAMBDAS)
        for n, profile, expected in (
            (2, "paper", [1.245, 2.479, 4.917, 9.667, 18.667, 27, 34.667, 48]),
            (4, "paper", [1.309, 2.602, 5.142, 10.045, 19.171, 27.457, 34.977, 48]),
            (2, "released_code", [1.326, 2.639, 5.222, 10.222, 19.556, 28, 35.556, 48]),
            (4, "released_code", [1.451, 2.880, 5.671, 10.992, 20.639, 29.057, 36.355, 48]),
        ):
            np.testing.assert_allclose(mutation_impact.changed_voxels(n, rates, profile), expected, atol=6e-4)

    def test_the_voxel_share_is_the_mean_over_the_traits_selected(self):
        for n in (1, 2, 4, 8):
            for profile in ("paper", "released_code"):
                chances = mutation_impact.selected_traits(n, profile)
                for rate in (0.0, 0.3, 1.0):
                    expected = 1.0 - sum(chance * (1.0 - rate) ** s for s, chance in enumerate(chances))
                    self.assertAlmostEqual(float(mutation_impact.changed_voxel_share(n, rate, profile)), expected)

    def test_ever_more_traits_approach_the_limit(self):
        for profile in ("paper", "released_code"):
            self.assertAlmostEqual(
                float(mutation_impact.changed_voxel_share(5000, 0.5, profile)),
                float(mutation_impact.limiting_voxel_share(0.5, profile)),
                places=3,
            )


if __name__ == "__main__":
    unittest.main()
