#!/usr/bin/python3
"""The experiment that README.md shows gives what it says there, down to the digest.

Who changes results on purpose runs ./run.sh and updates README.md, section "What you see".
"""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
TOOL = os.environ["DEVO_EVO_TOOL"]


def results_in(text):
    """What a run's last lines say about the best robot, and its digest."""
    return re.findall(r"Best robot: .*|travelled .* turns.*|developmental windows: W_L .*|Digest: .*", text)


class ReadmeExperimentTest(unittest.TestCase):
    def test_the_default_experiment_gives_what_readme_shows(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([TOOL, "evolve", "--output", folder + "/results"], stdin=subprocess.DEVNULL,
                                 stdout=subprocess.PIPE, text=True, check=True)
        readme = (REPOSITORY / "README.md").read_text(encoding="utf-8")
        self.assertEqual(len(results_in(run.stdout)), 4, run.stdout)
        self.assertEqual(results_in(run.stdout), results_in(readme))


if __name__ == "__main__":
    unittest.main()
