#!/usr/bin/python3
"""The tool's commands `figures` and `report`: files, exit statuses, and what is said when something is wrong."""

import os
import pathlib
import re
import sqlite3
import subprocess
import sys
import tempfile
import unittest
import xml.dom.minidom

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import devo_evo  # noqa: E402
from devo_evo.claims import CLAIMS  # noqa: E402
from synthetic import Experiment  # noqa: E402
from synthetic_study import AS_CLAIMED, SyntheticStudy  # noqa: E402


def run_tool(*arguments, **environment):
    """The tool as anybody would call it: it finds the module by itself."""
    inherited = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    return subprocess.run(
        [os.environ["DEVO_EVO_TOOL"], *map(str, arguments)],
        capture_output=True,
        text=True,
        check=False,
        env={**inherited, **environment},
        timeout=300,
    )


class ReportTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.study = pathlib.Path(cls.temporary.name) / "my <study>"
        SyntheticStudy(cls.study, AS_CLAIMED, trials=4, sweep_trials=2)
        cls.result = run_tool("report", cls.study)

    def test_it_succeeds_and_says_what_came_out(self):
        self.assertEqual((self.result.returncode, self.result.stderr), (0, ""))
        self.assertRegex(self.result.stdout, rf"report.html, .*report.md: of {len(CLAIMS)} claims \d+ hold")

    def test_the_page_is_well_formed_and_needs_nothing_else(self):
        page = (self.study / "report" / "report.html").read_text(encoding="utf-8")
        body = re.sub(r"<!DOCTYPE html>|<meta[^>]*>|<img[^>]*>", "", page)
        xml.dom.minidom.parseString(body)
        self.assertEqual(len(re.findall(r'src="data:image/png;base64,', page)), 12)
        self.assertNotRegex(page, r'(?:src|href)="(?!data:)')
        self.assertIn("Report on my &lt;study&gt;", page)

    def test_every_claim_has_its_row_in_both(self):
        page = (self.study / "report" / "report.html").read_text(encoding="utf-8")
        text = (self.study / "report" / "report.md").read_text(encoding="utf-8")
        for claim in CLAIMS:
            self.assertIn(f"| {claim.statement} |", text)
            self.assertIn(claim.statement.split("'")[0], page)
        self.assertIn("too few trials (15 would do)", text)
        self.assertIn("52.88 [48.18, 55.16]", text)

    def test_rows_of_the_markdown_have_as_many_cells_as_their_header(self):
        text = (self.study / "report" / "report.md").read_text(encoding="utf-8")
        width = None
        for line in text.splitlines():
            cells = len(re.findall(r"(?<!\\)\|", line)) if line.startswith("|") else None
            self.assertTrue(width is None or cells is None or cells == width, line)
            width = cells

    def test_pictures_that_it_names_are_there(self):
        text = (self.study / "report" / "report.md").read_text(encoding="utf-8")
        for name in re.findall(r"\]\((figures/[^)]+)\)", text):
            self.assertTrue((self.study / "report" / name).is_file(), name)


class CommandTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def experiment(self):
        experiment = Experiment(self.folder / "a", generations=1)
        experiment.add_trial(1, range(2), [1.0, 2.0])
        return experiment.close()

    def test_one_figure_goes_where_it_is_told(self):
        result = run_tool("figures", self.experiment(), "--only", "S4", "--into", self.folder / "into")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(
            sorted(path.name for path in (self.folder / "into").iterdir()), ["figS4.csv", "figS4.pdf", "figS4.png"]
        )

    def test_without_an_output_or_with_an_unknown_figure_nothing_is_done(self):
        for arguments in (
            ("figures",),
            ("figures", self.experiment(), "--only", "9"),
            ("figures", self.folder, "--frobnicate"),
        ):
            result = run_tool(*arguments)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertRegex(result.stderr, "^devo_evo: error: ")
        self.assertFalse((self.folder / "a" / "figures").exists())

    def test_a_folder_without_a_study_is_an_error_in_one_line(self):
        for command in ("figures", "report"):
            result = run_tool(command, self.folder / "nothing")
            self.assertEqual(result.returncode, 1)
            self.assertRegex(result.stderr, r"^devo_evo: error: there is neither study\.db nor experiment\.db in .*\n$")

    def test_a_lost_champion_stops_the_report(self):
        output = self.experiment()
        database = sqlite3.connect(output / "experiment.db")
        database.execute("UPDATE generations SET best_fitness = 0.5 WHERE generation = 1")
        database.commit()
        database.close()
        result = run_tool("report", output)
        self.assertEqual(result.returncode, 1)
        self.assertIn("selection lost its best", result.stderr)

    def test_a_missing_package_is_named_with_its_remedy(self):
        (self.folder / "scipy.py").write_text("raise ModuleNotFoundError(\"No module named 'scipy'\", name='scipy')\n")
        result = run_tool("report", self.experiment(), PYTHONPATH=str(self.folder))
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"^devo_evo: error: the Python package scipy is missing; install python3-scipy")

    def test_help_needs_no_python(self):
        result = run_tool("report", "--help", PATH="")
        self.assertEqual(result.returncode, 0)
        self.assertIn("--into", result.stdout)


class ImportTest(unittest.TestCase):
    def test_importing_the_package_loads_nothing_heavy(self):
        # The ROS messages live in this package, too.
        code = "import sys, devo_evo; assert 'pandas' not in sys.modules and 'scipy' not in sys.modules"
        subprocess.run([sys.executable, "-c", code], check=True)

    def test_every_name_it_lists_is_there(self):
        for name in devo_evo.__all__:
            self.assertTrue(hasattr(devo_evo, name), name)
        with self.assertRaises(AttributeError):
            devo_evo.nothing  # pylint: disable=pointless-statement


if __name__ == "__main__":
    unittest.main()
