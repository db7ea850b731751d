#!/usr/bin/python3
"""What is written about the analysis agrees with it."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from devo_evo.claims import listing

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]


class StatisticsPageTest(unittest.TestCase):
    def test_it_lists_every_claim_as_the_code_has_it(self):
        page = (REPOSITORY / "docs/statistics.md").read_text(encoding="utf-8")
        self.assertEqual(
            page[page.index("<!-- claims -->\n") + len("<!-- claims -->\n") :].strip(), listing.markdown().strip()
        )


class ExampleTest(unittest.TestCase):
    def test_the_worked_script_works(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(
                [
                    os.environ["DEVO_EVO_TOOL"],
                    "evolve",
                    "--trials",
                    "2",
                    "--generations",
                    "3",
                    "--population",
                    "4",
                    "--lifetime",
                    "0.1",
                    "--output",
                    f"{folder}/run",
                ],
                check=True,
                capture_output=True,
            )
            result = subprocess.run(
                [sys.executable, REPOSITORY / "docs/analysis_example.py", f"{folder}/run", folder],
                check=False,
                capture_output=True,
                text=True,
            )
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertIn("2 trials at generation 3", result.stdout)
            self.assertTrue((pathlib.Path(folder) / "lineages.png").is_file())


if __name__ == "__main__":
    unittest.main()
