#!/usr/bin/python3
"""The study at scale `quick`, as it is: every experiment, every figure and the report, by the commands that people use.

One run, which most tests share; it takes a minute or two of two cores.
"""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import pandas as pd

import devo_evo
from devo_evo import figures
from devo_evo.claims import CLAIMS, Verdict, judge
from devo_evo.mutation_impact import LAMBDAS

TREATMENTS = ("evo", "evo_devo")
BASELINES = ("neutral", "random_search")
TRIALS, GENERATIONS, WALKS, WALK_STEPS = 3, 20, 3, 20
SWEEP_TRIALS, SWEEP_GENERATIONS = 2, 10
RIGID_TRIALS, RIGID_GENERATIONS = 2, 2
WORLDS = 17  # with the one that robots evolved in


def run_tool(*arguments):
    return subprocess.run(
        [os.environ["DEVO_EVO_TOOL"], *map(str, arguments)], capture_output=True, text=True, check=True
    )


class QuickStudyTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name) / "study"
        cls.said = run_tool("study", "--scale", "quick", "--output", cls.folder).stderr
        run_tool("report", cls.folder)
        cls.study = devo_evo.open_study(cls.folder)
        cls.addClassCleanup(cls.study.close)
        cls.drawings = {name: figures.draw(name, cls.study) for name in figures.NAMES}

    def test_all_parts_run_and_nothing_is_left(self):
        parts = re.findall(r"^devo_evo: (\w+): done$", self.said, re.MULTILINE)
        estimate = run_tool("study", "--scale", "quick", "--output", self.folder, "--estimate").stdout
        rows = re.findall(r"^(\w+) +(\d+) +(\d+) ", estimate, re.MULTILINE)
        self.assertEqual([part for part, _, _ in rows], parts + ["all"])
        self.assertEqual(
            parts,
            ["main", "removed", "walks", "lineages", "traces", "robustness", "impact", "baselines", "sweep", "rigid"],
        )
        self.assertEqual({left for _, _, left in rows}, {"0"}, estimate)
        self.assertGreater(int(rows[-1][1]), 9000)

    def test_every_arm_evolved_as_far_as_the_scale_says(self):
        arms = {f"main/{treatment}": (TRIALS, GENERATIONS) for treatment in TREATMENTS}
        arms.update(
            {f"baselines/{treatment}-{kind}": (TRIALS, GENERATIONS) for treatment in TREATMENTS for kind in BASELINES}
        )
        arms.update(
            {
                f"sweep/{treatment}-{round(48 * rate)}_48": (SWEEP_TRIALS, SWEEP_GENERATIONS)
                for treatment in TREATMENTS
                for rate in LAMBDAS
            }
        )
        arms.update({f"rigid/{treatment}": (RIGID_TRIALS, RIGID_GENERATIONS) for treatment in TREATMENTS})
        self.assertEqual(set(self.study.arms["arm"]), set(arms))
        for arm, (trials, generations) in arms.items():
            table = self.study.archive(arm).trials()
            self.assertEqual(table["generations"].tolist(), trials * [generations], arm)
            digest = run_tool("digest", self.folder / arm).stdout.strip()
            self.assertIn(f"devo_evo: {arm}: digest {digest}\n", self.said)

    def test_every_run_champion_was_analysed(self):
        champions = len(TREATMENTS) * TRIALS
        self.assertEqual(len(self.study.variants()), TRIALS * 9)
        walks = self.study.walks()
        kinds = walks.groupby(["treatment", "trial", "space", "robot", "operator", "walk"]).size()
        self.assertEqual(set(kinds), {WALK_STEPS + 1})
        # Of control and of body; of Evo by either operator, of Evo-Devo also without development.
        self.assertEqual(len(kinds), TRIALS * (2 + 3) * 2 * WALKS)
        self.assertEqual(len(self.study.traces()), champions * 2)
        self.assertEqual(len(self.study.robustness()), champions * WORLDS)
        ancestors = self.study.ancestors()
        for treatment in TREATMENTS:
            lineages = self.study.main(treatment).lineages()
            self.assertEqual(len(ancestors[ancestors["treatment"] == treatment]), len(lineages))
            self.assertEqual(
                ancestors[ancestors["treatment"] == treatment].groupby("trial")["fitness"].last().tolist(),
                self.study.main(treatment).run_champions()["fitness"].tolist(),
            )
        self.assertEqual(sorted(self.study.neutral_lineages()), list(range(1, TRIALS + 1)))
        self.assertEqual(len(self.study.mutational_impact()), 4 * len(LAMBDAS))

    def test_every_figure_is_drawn_with_exactly_its_numbers(self):
        for name, drawing in self.drawings.items():
            stem = self.folder / "report" / "figures" / drawing.name
            self.assertEqual(stem.with_suffix(".pdf").read_bytes()[:5], b"%PDF-", name)
            self.assertEqual(stem.with_suffix(".png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n", name)
            numbers = drawing.numbers.to_csv(index=False, lineterminator="\n")
            self.assertEqual(stem.with_suffix(".csv").read_text(encoding="utf-8"), numbers, name)
            # Only of rolling there is nothing yet.
            self.assertEqual(drawing.numbers.empty, name == "6", name)

    def test_every_figure_says_what_it_is_made_of(self):
        for name, drawing in self.drawings.items():
            notes = " ".join(drawing.notes)
            if name == "S5":
                self.assertEqual(notes.count(f"{RIGID_TRIALS} trials, {RIGID_GENERATIONS} generations"), 2)
                continue
            self.assertRegex(notes, r"Profile paper\.|profile paper", name)
            if name in ("S3", "S4"):
                continue  # of the sweep, and of no evolution at all
            self.assertIn(f"{TRIALS} trials, {GENERATIONS} generations", notes, name)

    def test_curves_are_those_of_the_archives(self):
        table = pd.read_csv(self.folder / "report" / "figures" / "fig3.csv")
        for treatment in TREATMENTS:
            generations = self.study.main(treatment).generations()
            median = generations.groupby("generation")["best_fitness"].median().clip(lower=0.0)
            curve = table[(table["panel"] == "A") & (table["series"] == treatment)]
            self.assertEqual(curve["x"].tolist(), list(range(GENERATIONS + 1)))
            self.assertTrue(((curve["median"].to_numpy() - median.to_numpy()) ** 2 < 1e-18).all())

    def test_the_report_judges_every_claim_and_claims_nothing_about_the_end_of_evolution(self):
        text = (self.folder / "report" / "report.md").read_text(encoding="utf-8")
        page = (self.folder / "report" / "report.html").read_text(encoding="utf-8")
        self.assertNotRegex(page, r'(?:src|href)="(?!data:)')
        for judgement in judge(CLAIMS, self.study):
            row = next(line for line in text.splitlines() if line.startswith(f"| {judgement.claim.statement} |"))
            self.assertTrue(row.endswith(f"| {judgement.verdict_text} |"), row)
            if judgement.claim.final:
                self.assertIn(judgement.verdict, (Verdict.TOO_FEW_GENERATIONS, Verdict.NO_DATA), row)
            if judgement.claim.family == "impact":
                self.assertIs(judgement.verdict, Verdict.HOLDS, row)


class QuickPartialTest(unittest.TestCase):
    """The part that runs only if asked for."""

    def test_only_what_is_to_develop_does(self):
        with tempfile.TemporaryDirectory() as folder:
            run_tool("study", "--scale", "quick", "--only", "partial", "--output", folder)
            with devo_evo.open_study(folder) as study:
                self.assertEqual(study.arms["arm"].tolist(), ["partial/evo_devo_body", "partial/evo_devo_control"])
                for arm in study.arms["arm"]:
                    archive = study.archive(arm)
                    self.assertEqual(archive.trials()["generations"].tolist(), TRIALS * [GENERATIONS], arm)
                    lineages = archive.lineages()
                    self.assertEqual((lineages["morphology_window"] > 0).all(), arm.endswith("body"), arm)
                    self.assertEqual((lineages["control_window"] > 0).all(), arm.endswith("control"), arm)
                    self.assertEqual(lineages["morphology_window"].max() == 0, arm.endswith("control"), arm)
                    self.assertEqual(lineages["control_window"].max() == 0, arm.endswith("body"), arm)


if __name__ == "__main__":
    unittest.main()
