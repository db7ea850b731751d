#!/usr/bin/python3
"""Figures: the numbers in their CSV files against known archives, and what is said where there are none."""

import pathlib
import sys
import tempfile
import unittest

import numpy as np
import pandas as pd

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import devo_evo  # noqa: E402
from devo_evo import figures, statistics  # noqa: E402
from devo_evo.figures import canalization, discovery, walks  # noqa: E402
from synthetic import Experiment  # noqa: E402
from synthetic_study import AS_CLAIMED, SyntheticStudy  # noqa: E402


class FiguresTest(unittest.TestCase):
    """What is drawn of a study of six trials, as the paper has it."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = pathlib.Path(cls.temporary.name)
        SyntheticStudy(cls.folder / "study", AS_CLAIMED, trials=6, sweep_trials=3)
        cls.study = devo_evo.open_study(cls.folder / "study")
        cls.addClassCleanup(cls.study.close)
        figures.draw_all(cls.study, cls.folder / "figures")

    def table(self, name):
        return pd.read_csv(self.folder / "figures" / f"{name}.csv")

    def test_each_is_there_as_pdf_png_and_csv(self):
        names = {path.name for path in (self.folder / "figures").iterdir()}
        for name in (
            "fig3",
            "fig4",
            "fig5",
            "fig6",
            "figS1",
            "figS2",
            "figS3",
            "figS4",
            "fig_time_to_fast",
            "fig_robustness",
            "fig_frozen",
        ):
            self.assertTrue({f"{name}.pdf", f"{name}.png", f"{name}.csv"} <= names, name)

    def test_the_same_data_give_the_same_bytes(self):
        figures.draw_all(self.study, self.folder / "again", ["3", "S4"])
        for name in ("fig3.pdf", "fig3.png", "fig3.csv", "figS4.pdf", "figS4.png", "figS4.csv"):
            self.assertEqual((self.folder / "figures" / name).read_bytes(), (self.folder / "again" / name).read_bytes())

    def test_every_figure_says_profile_trials_and_generations(self):
        for name in ("3", "4", "5", "6", "S1", "S2", "time", "robustness"):
            text = " ".join(figures.draw(name, self.study).notes)
            self.assertIn("Profile paper", text)
            self.assertIn("Evo-Devo: 6 trials, 10000 generations", text)
        self.assertIn("3 trials of 10000 generations", figures.draw("S3", self.study).notes[0])

    def test_fig_3_has_medians_of_champions_and_of_curves(self):
        table = self.table("fig3")
        champions = self.study.main("evo_devo").run_champions()["fitness"]
        bar = table[(table["panel"] == "B") & (table["series"] == "evo_devo") & (table["of"] == "run champions")].iloc[
            0
        ]
        expected = statistics.median_interval(champions, resamples=1000)
        np.testing.assert_allclose(
            bar[["median", "low", "high"]].astype(float), [expected.estimate, expected.low, expected.high]
        )
        last = table[(table["panel"] == "A") & (table["series"] == "evo_devo")].iloc[-1]
        self.assertAlmostEqual(last["median"], champions.median())
        self.assertEqual(last["x"], 10000)
        removed = table[(table["series"] == "removed")].iloc[0]
        self.assertAlmostEqual(removed["median"], self.study.removed()["fitness"].median())

    def test_fig_s1_is_right_aligned_with_one_row_an_ancestor(self):
        table = self.table("figS1")
        for trial, rows in table.groupby("trial"):
            self.assertEqual(rows["x"].iloc[-1], table["x"].max())
            self.assertEqual(len(rows), len(self.study.main("evo_devo").lineage(trial)))

    def test_fig_4_b_counts_every_design_once(self):
        cells = self.table("fig4").query("panel == 'B'")
        individuals = pd.concat(
            [self.study.main("evo_devo").individuals(trial, ("fitness", "phenotype_hash")) for trial in range(1, 7)]
        )
        self.assertEqual(cells["designs"].sum(), individuals[individuals["fitness"] > -1]["phenotype_hash"].nunique())

    def test_fig_5_starts_at_one_and_ends_where_the_walks_do(self):
        table = self.table("fig5").query("panel == 'A' and series == 'evo_devo'")
        self.assertEqual((table["x"].iloc[0], table["median"].iloc[0]), (0, 1.0))
        self.assertEqual(table["x"].iloc[-1], 8)
        self.assertEqual(table["champions"].iloc[0], 6)
        self.assertEqual(table["walks"].iloc[0], 18)

    def test_fig_6_is_aligned_at_the_first_roll_and_never_padded(self):
        table = self.table("fig6").query("measure == 'fell_over'")
        curve = table[table["panel"] == "A"]
        self.assertEqual(curve["x"].iloc[0], 0)
        self.assertAlmostEqual(curve["median"].iloc[0], 9.5, delta=0.1)
        self.assertAlmostEqual(curve["median"].iloc[-1], 0.1, delta=0.1)
        self.assertEqual(set(curve["lineages"]), {5})
        self.assertEqual(table[table["panel"] == "B"]["series"].tolist(), ["first", "champion"])

    def test_fig_s2_has_the_velocity_of_fast_and_slow_champions(self):
        table = self.table("figS2").query("row == 'Velocity'")
        self.assertEqual(
            set(table["series"]), {"fast champion", "slow champion", "fast frozen_at_birth", "slow frozen_at_birth"}
        )
        self.assertEqual(table["x"].min(), 0.25)  # the middle of the first half second

    def test_fig_s3_has_eight_rates_of_both_treatments(self):
        self.assertEqual(len(self.table("figS3").groupby(["mutation_rate", "series"])), 16)

    def test_fig_s4_has_formula_and_counts_one_upon_the_other(self):
        table = self.table("figS4")
        counted = table[table["series"] == "counted"].iloc[0]
        formula = np.interp(
            counted["x"],
            *table[(table["series"] == "formula") & (table["traits"] == counted["traits"])][["x", "y"]].to_numpy().T,
        )
        self.assertAlmostEqual(counted["y"], formula, delta=1e-3)

    def test_an_unknown_figure_is_named(self):
        with self.assertRaisesRegex(devo_evo.InvalidInput, "no figure 'S9'; the figures are 3, 4, 5"):
            figures.draw_all(self.study, self.folder / "no", ["S9"])


class NumbersTest(unittest.TestCase):
    def test_hexagons_lie_where_matplotlib_lays_them(self):
        random = np.random.default_rng(4)
        x, y, values = random.uniform(5, 95, 2000), random.uniform(5, 95, 2000), random.normal(size=2000)
        ours = canalization.hexagons(x, y, values)
        axes = figures.style.mpl_figure.Figure().subplots()
        theirs = axes.hexbin(x, y, C=values, gridsize=30, extent=(0, 100, 0, 100), reduce_C_function=np.median)
        expected = pd.DataFrame(theirs.get_offsets(), columns=["x", "y"]).assign(median=theirs.get_array().data)
        self.assertEqual(len(ours), len(expected))
        merged = ours.round(6).merge(expected.round(6), on=["x", "y"], suffixes=("", "_theirs"))
        self.assertEqual(len(merged), len(ours))
        np.testing.assert_allclose(merged["median"], merged["median_theirs"], atol=1e-6)

    def test_walks_are_drawn_as_far_as_all_of_them_go(self):
        frame = pd.DataFrame(
            {"trial": [1, 1, 1, 2, 2], "walk": 1, "step": [0, 1, 2, 0, 1], "relative": [1.0, 0.2, 0.9, 1.0, 0.4]}
        )
        curve = walks.curve(frame)
        self.assertEqual(curve["x"].tolist(), [0, 1])
        self.assertAlmostEqual(curve["median"].iloc[1], 0.3)

    def test_a_walk_step_that_fails_counts_as_zero(self):
        frame = pd.DataFrame(
            {"trial": [1, 1, 2, 2], "walk": 1, "step": [0, 1, 0, 1], "relative": [1.0, np.nan, 1.0, 0.4]}
        )
        self.assertEqual(walks.curve(frame)["median"].tolist(), [1.0, 0.2])

    def test_onset_of_rolling_is_the_whole_life_if_there_is_none(self):
        frame = pd.DataFrame(
            {
                "fell_over_since_birth_s": [np.nan, 3.0],
                "first_top_contact_since_birth_s": [9.0, 2.0],
                "turns": [0.3, -5.0],
            }
        )
        self.assertEqual(discovery.onset(frame, 10.0).tolist(), [10.0, 3.0])
        self.assertEqual(discovery.onset(frame, 10.0, "first_top_contact").tolist(), [9.0, 2.0])
        self.assertEqual(discovery.onset(frame, 10.0, "turns").tolist(), [10.0, 2.0])


class LittleDataTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def draw(self, output, *names):
        with devo_evo.open_study(output) as study:
            return [figures.draw(name, study) for name in names]

    def test_a_single_experiment_is_drawn_as_far_as_it_goes(self):
        experiment = Experiment(self.folder / "a", generations=3)
        experiment.add_trial(1, range(4), [1.0, 2.0, None, 3.0], body=[0.3] * 4, control=[0.4] * 4)
        experiment.add_trial(2, range(2), [9.0, 9.5], body=[0.3] * 2, control=[0.4] * 2)
        fitness, canalized, walked = self.draw(experiment.close(), "3", "4", "5")
        self.assertIn("Evo: no finished generation", fitness.notes[0])
        self.assertIn("Evo-Devo: 1 trial, 3 generations", fitness.notes[0])
        self.assertIn("left out: trial 2 at generation 1", fitness.notes[0])
        curve = fitness.numbers.query("panel == 'A'")
        self.assertEqual(curve["median"].tolist(), [1.0, 2.0, 2.0, 3.0])
        self.assertEqual(set(curve["trials"]), {1})
        self.assertEqual(canalized.numbers.query("panel == 'B'")["designs"].sum(), 5)  # not the invalid one
        self.assertTrue(walked.numbers.empty)

    def test_an_experiment_with_nothing_but_invalid_robots_is_drawn(self):
        experiment = Experiment(self.folder / "a", generations=1)
        experiment.add_trial(1, range(2), [None, None], body=[0.3] * 2, control=[0.4] * 2)
        fitness, _, _ = self.draw(experiment.close(), "3", "4", "S1")
        curve = fitness.numbers.query("panel == 'A'")
        self.assertEqual(curve["median"].tolist(), [0.0, 0.0])

    def test_an_experiment_that_has_not_begun_is_drawn_empty(self):
        for drawing in self.draw(
            Experiment(self.folder / "a").close(), "3", "4", "5", "6", "S1", "S3", "time", "robustness"
        ):
            self.assertTrue(drawing.numbers.empty, drawing.name)

    def test_a_folder_without_either_is_refused(self):
        with self.assertRaisesRegex(devo_evo.ArchiveError, "neither study.db nor experiment.db"):
            devo_evo.open_study(self.folder)

    def test_a_folder_that_cannot_be_written_is_named(self):
        (self.folder / "figures").write_text("a file")
        output = Experiment(self.folder / "a").close()
        with devo_evo.open_study(output) as study, self.assertRaisesRegex(devo_evo.DevoEvoError, "cannot be written"):
            figures.draw_all(study, self.folder / "figures", ["S4"])


if __name__ == "__main__":
    unittest.main()
