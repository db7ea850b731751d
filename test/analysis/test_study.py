#!/usr/bin/python3
"""A real study, as small as can be, read, drawn and judged; and how often the window tests err on neutral lineages."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import numpy as np

import devo_evo
from devo_evo import claims, figures, statistics

REPLICATES = 60


class StudyTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = pathlib.Path(cls.temporary.name)
        numbers = {
            "trials": 3,
            "generations": 12,
            "population": 8,
            "lifetime": 0.01,
            "walks": 2,
            "walk_steps": 5,
            "sweep_48ths": "8,48",
            "sweep_trials": 1,
            "sweep_generations": 2,
            "baseline_trials": 1,
            "baseline_generations": 2,
            "impact_reproductions": 2000,
            "neutral_lineages": REPLICATES,
        }
        options = [word for name, value in numbers.items() for word in (f"--{name}", str(value))]
        subprocess.run(
            [os.environ["DEVO_EVO_TOOL"], "study", "--scale", "quick", *options, "--output", str(cls.folder / "study")],
            check=True,
            capture_output=True,
        )
        cls.study = devo_evo.open_study(cls.folder / "study")
        cls.addClassCleanup(cls.study.close)

    def test_every_part_has_its_frame(self):
        self.assertEqual(self.study.profile, "paper")
        self.assertEqual(len(self.study.main_arms()), 6)  # with two baselines of each treatment
        self.assertEqual(
            sorted(self.study.sweep()), [("evo", 8 / 48), ("evo", 1.0), ("evo_devo", 8 / 48), ("evo_devo", 1.0)]
        )
        for frame in (
            self.study.variants(),
            self.study.walks(),
            self.study.ancestors(),
            self.study.traces(),
            self.study.robustness(),
            self.study.mutational_impact(),
        ):
            self.assertGreater(len(frame), 0)

    def test_an_arm_whose_archive_was_only_just_made_has_not_begun(self):
        copy = pathlib.Path(self.temporary.name) / "killed"
        shutil.copytree(self.folder / "study", copy)
        (copy / "sweep" / "evo-8_48" / "experiment.db").write_bytes(b"")
        with devo_evo.open_study(copy) as study:
            self.assertEqual(len(study.sweep()), 3)
            self.assertEqual(set(study.sweep()), set(self.study.sweep()) - {("evo", 8 / 48)})

    def test_removed_champions_are_those_frozen_at_birth_to_the_last_bit(self):
        archive = self.study.main("evo_devo")
        champions = archive.run_champions()
        frozen = [genome.without_development() for genome in archive.genomes(champions["id"].items())]
        again = devo_evo.evaluate(frozen, archive.parameters)
        np.testing.assert_array_equal(again["fitness"], self.study.removed()["fitness"].reindex(champions.index))

    def test_walks_start_from_their_champion(self):
        walks = self.study.walks().query("step == 0 and robot == 'champion' and part == 'main'")
        for treatment, rows in walks.groupby("treatment"):
            champions = self.study.main(treatment).run_champions()["fitness"]
            np.testing.assert_array_equal(rows["fitness"], champions.reindex(rows["trial"]))
        self.assertEqual(set(walks["relative"].dropna()), {1.0})

    def test_ancestors_are_the_archives_lineages(self):
        rows = (
            self.study.ancestors()
            .query("part == 'main' and treatment == 'evo_devo'")
            .sort_values(["trial", "position"])
        )
        lineages = self.study.main("evo_devo").lineages()
        for column in ("id", "fitness", "morphology_window", "control_window"):
            np.testing.assert_array_equal(rows[column], lineages[column], column)
        closed = rows["body_initial_towards_final"] + rows["body_final_towards_initial"]
        change = -rows.groupby("trial")["morphology_window"].diff()
        np.testing.assert_allclose(closed.astype(float), change, atol=1e-12)

    def test_neutral_lineages_are_as_long_and_begin_with_the_founder(self):
        lineages = self.study.main("evo_devo").lineages()
        for trial, windows in self.study.neutral_lineages().items():
            real = lineages[lineages["trial"] == trial]
            self.assertEqual(windows["morphology_window"].shape, (REPLICATES, len(real)))
            self.assertEqual(set(windows["morphology_window"][:, 0]), {real["morphology_window"].iloc[0]})
            self.assertEqual(set(windows["control_window"][:, 0]), {real["control_window"].iloc[0]})

    def test_window_tests_seldom_find_in_neutral_lineages_what_is_not_there(self):
        neutral = [windows["morphology_window"] for windows in self.study.neutral_lineages().values()]
        statistics_of = {
            "rise": lambda courses: courses.max(axis=1) - courses[:, 0],
            "fall": lambda courses: courses.max(axis=1) - courses[:, -1],
            "loss": lambda courses: courses[:, 0] - courses[:, -1],
        }
        for name, statistic in statistics_of.items():
            values = [statistic(courses) for courses in neutral]
            p = [  # each replicate in its turn is taken for the real lineages
                statistics.against_neutral(
                    [own[replicate] for own in values], [np.delete(own, replicate) for own in values], draws=999
                ).p
                for replicate in range(REPLICATES)
            ]
            # At a true rate of 1/20, more than 8 of 60 hardly ever come up.
            self.assertLessEqual(np.sum(np.array(p) <= 0.05), 8, name)
            self.assertAlmostEqual(np.mean(p), 0.5, delta=0.12, msg=name)

    def test_counted_changes_agree_with_the_formula(self):
        (claim,) = [claim for claim in claims.CLAIMS if claim.key == "impact-operator"]
        self.assertTrue(claim.measure(self.study).supported)

    def test_every_claim_is_judged(self):
        verdicts = {judgement.claim.key: judgement.verdict for judgement in claims.judge(claims.CLAIMS, self.study)}
        self.assertIs(verdicts["fast-share"], claims.Verdict.TOO_FEW_GENERATIONS)
        without = {key for key, verdict in verdicts.items() if verdict is claims.Verdict.NO_DATA}
        # Of the sweep only two rates were run.
        self.assertTrue({"sooner-1/3", "best-1/2", "high-rates-find"} <= without, without)
        self.assertNotIn("control-breaks-evo", without)

    def test_figures_of_every_part_have_numbers(self):
        for name in ("3", "4", "5", "S1", "S2", "S3", "S4", "time", "robustness", "frozen"):
            self.assertFalse(figures.draw(name, self.study).numbers.empty, name)


if __name__ == "__main__":
    unittest.main()
