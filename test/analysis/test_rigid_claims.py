#!/usr/bin/python3
"""Rigid bodies: Fig. S5 and its claims, on archives in which they hold, or their opposite does."""

import pathlib
import sys
import tempfile
import unittest

import numpy as np
import pandas as pd

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import devo_evo  # noqa: E402
from devo_evo import claims, figures, report  # noqa: E402
from devo_evo.claims import Verdict  # noqa: E402
from devo_evo.figures import rigid  # noqa: E402
from synthetic import RigidExperiment  # noqa: E402

ANCESTORS = 6  # of each lineage
ROLLS_FROM = 3
TRIALS = 30
GENERATIONS = 200

# Windows of founder and champion, times of the first half turn of the first to roll and of the champion [s], ways
# sideways of champions and others [m], and how much fitter Evo is.
AS_CLAIMED = {"body": (0.33, 0.03), "control": (0.33, 0.40), "roll": (8.0, 2.6), "stray": (0.1, 2.0), "evo": 1.0}
OPPOSITE = {"body": (0.10, 0.50), "control": (0.60, 0.05), "roll": (3.0, 9.0), "stray": (2.0, 0.1), "evo": 2.0}


def make(folder, treatment, story, trials=TRIALS, rolling=True):
    """An experiment of one treatment."""
    experiment = RigidExperiment(folder, treatment, generations=GENERATIONS)
    random = np.random.default_rng(5 if treatment == "evo" else 6)
    develops = treatment == "evo_devo"
    for trial in range(1, trials + 1):
        scale = random.uniform(0.97, 1.03) * (1.0 if develops else story["evo"])
        generations = np.linspace(0, GENERATIONS, ANCESTORS).round().astype(int)
        for number, generation in enumerate(generations):
            share = number / (ANCESTORS - 1)
            rolls = rolling and number >= ROLLS_FROM
            time = np.interp(number, [ROLLS_FROM, ANCESTORS - 1], story["roll"]) + random.uniform(0.0, 0.2)
            fitness = (0.0025 + 0.002 * share) * scale
            experiment.add_quadruped(
                trial,
                number,
                number - 1 if number else None,
                generation,
                fitness=fitness,
                descent=10.0 if rolls else 1.0,
                sideways=(-1) ** trial * story["stray"][0 if number == ANCESTORS - 1 else 1],
                turns=4.0 if rolls else 0.1,
                first_roll_since_birth_s=time if rolls else None,
                morphology_window=np.interp(share, [0, 1], story["body"]) + random.uniform(0.0, 0.01) if develops else 0.0,
                control_window=np.interp(share, [0, 1], story["control"]) + random.uniform(0.0, 0.01) if develops else 0.0,
            )
            experiment.add_survivors(trial, generation, number, fitness)
    experiment.close()


class StudyOfOne(unittest.TestCase):
    """Rigid arms as a study has them."""

    def study(self, story, **arguments):
        """A study whose two rigid arms are made as told."""
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        folder = pathlib.Path(temporary.name)
        make(folder / "rigid/evo_devo", "evo_devo", story, **arguments)
        make(folder / "rigid/evo", "evo", story, **arguments)
        study = devo_evo.open_study(folder / "rigid/evo_devo")
        self.addCleanup(study.close)
        study.output = folder
        study.arms = pd.DataFrame(
            [
                {"arm": f"rigid/{treatment}", "part": "rigid", "treatment": treatment, "selection": "afpo"}
                for treatment in ("evo", "evo_devo")
            ]
        )
        return study


class ClaimsTest(StudyOfOne):
    def verdicts(self, study):
        return {judgement.claim.key: judgement.verdict for judgement in claims.judge(claims.rigid.CLAIMS, study)}

    def test_they_hold_where_it_is_so(self):
        for key, verdict in self.verdicts(self.study(AS_CLAIMED)).items():
            with self.subTest(key):
                self.assertIs(verdict, Verdict.HOLDS)

    def test_they_do_not_hold_where_the_opposite_is_so(self):
        for key, verdict in self.verdicts(self.study(OPPOSITE)).items():
            with self.subTest(key):
                self.assertIs(verdict, Verdict.DOES_NOT_HOLD)

    def test_three_trials_are_too_few(self):
        result = self.verdicts(self.study(AS_CLAIMED, trials=3))
        self.assertEqual(set(result.values()), {Verdict.TOO_FEW_TRIALS})

    def test_without_rollers_nothing_is_said_of_rolling(self):
        result = self.verdicts(self.study(AS_CLAIMED, rolling=False))
        self.assertIs(result["rigid-first-roll-late"], Verdict.TOO_FEW_TRIALS)
        self.assertIs(result["rigid-evolvability"], Verdict.HOLDS)


class OnsetsTest(unittest.TestCase):
    def test_a_half_turn_late_in_life_is_a_beginning(self):
        frame = pd.DataFrame(
            {
                "trial": [1, 1, 1, 1],
                "ancestor": [0, 1, 2, 3],
                "turns": [0.1, 0.6, 0.1, 5.0],
                "first_roll_since_birth_s": [np.nan, 9.4, np.nan, 2.1],
            }
        )
        times = claims.rigid.onsets(frame)
        self.assertEqual(times["first"].tolist(), [9.4])
        self.assertEqual(times["champion"].tolist(), [2.1])


class FigureTest(StudyOfOne):
    def test_lineages_are_right_aligned_and_told_by_their_champions(self):
        rows = rigid.lineages(self.study(AS_CLAIMED, trials=2))
        self.assertEqual(len(rows), 2 * ANCESTORS)
        self.assertTrue(rows["fast"].all())
        self.assertEqual(rows["x"].max(), ANCESTORS - 1)
        founder, champion = rows.iloc[0], rows.iloc[ANCESTORS - 1]
        self.assertAlmostEqual(founder["morphology_window"], 0.33, delta=0.011)
        self.assertAlmostEqual(champion["morphology_window"], 0.03, delta=0.011)

    def test_its_table_has_what_is_plotted(self):
        study = self.study(AS_CLAIMED, trials=12)
        with tempfile.TemporaryDirectory() as folder:
            (drawing,) = [drawing for drawing, _ in figures.draw_all(study, folder, ["S5"])]
            table = pd.read_csv(pathlib.Path(folder) / "figS5.csv")
            self.assertGreater((pathlib.Path(folder) / "figS5.png").stat().st_size, 10000)
        self.assertEqual(len(table[table["panel"] == "A"]), 12 * ANCESTORS)
        last = table[(table["panel"] == "B") & (table["x"] == GENERATIONS)].set_index("series")["median"]
        champions = study.rigid("evo_devo").run_champions()["fitness"]
        self.assertAlmostEqual(last["evo_devo"], champions.median())
        self.assertIn("2 more lineages in the table", " ".join(drawing.notes))

    def test_all_lineages_have_the_axes_that_are_labelled_once(self):
        drawing = figures.draw("S5", self.study({**OPPOSITE, "body": (0.1, 0.9)}, trials=3))
        limits = [axes.get_ylim() for axes in drawing.figure.axes[:9]]  # three a lineage
        for row in range(3):
            self.assertEqual(len(set(limits[row::3])), 1, f"row {row}")
        self.assertGreater(limits[0][1], 0.9)

    def test_without_rigid_bodies_it_says_so(self):
        study = self.study(AS_CLAIMED, trials=1)
        study.arms = study.arms.iloc[:0]
        self.assertTrue(figures.draw("S5", study).numbers.empty)


class SingleExperimentTest(unittest.TestCase):
    def test_an_experiment_with_rigid_bodies_is_no_main_experiment(self):
        with tempfile.TemporaryDirectory() as folder:
            make(folder, "evo_devo", AS_CLAIMED, trials=3)
            with devo_evo.open_study(folder) as study:
                self.assertIsNone(study.main("evo_devo"))
                self.assertEqual(study.rigid("evo_devo").body, "rigid")
                self.assertIsNone(study.rigid("evo"))
                frame = study.rigid("evo_devo").run_champions()
                self.assertEqual(frame.attrs["units"]["fitness"], "1/m^2")
                self.assertEqual(frame.attrs["units"]["descent"], "m")
                self.assertIn("rigid bodies", " ".join(j.claim.family for j in report.write(study, folder)))


if __name__ == "__main__":
    unittest.main()
