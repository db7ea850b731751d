#!/usr/bin/python3
"""What people read about the launch file agrees with it."""

import pathlib
import re
import subprocess
import unittest
import xml.etree.ElementTree

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]


def launch_arguments():
    """Names of the arguments of experiment.launch, in order."""
    launch = xml.etree.ElementTree.parse(REPOSITORY / "launch/experiment.launch").getroot()
    return [argument.get("name") for argument in launch.findall("arg")]


class LaunchArgumentsTest(unittest.TestCase):
    def test_each_is_explained_where_it_is_declared(self):
        launch = xml.etree.ElementTree.parse(REPOSITORY / "launch/experiment.launch").getroot()
        self.assertEqual([arg.get("name") for arg in launch.findall("arg") if not arg.get("doc")], [])

    def test_help_of_run_sh_lists_them(self):
        help_text = subprocess.run([REPOSITORY / "run.sh", "--help"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(re.findall(r"^    (\w+):=", help_text, re.MULTILINE), launch_arguments())

    def test_readme_lists_them(self):
        readme = (REPOSITORY / "README.md").read_text(encoding="utf-8")
        table = readme[readme.index("### Launch arguments"):]
        table = table[:table.index("\n#", 1)]
        self.assertEqual(re.findall(r"^\| `(\w+)`", table, re.MULTILINE), launch_arguments())


class LinksTest(unittest.TestCase):
    def test_files_that_documents_point_to_exist(self):
        for document in [REPOSITORY / "README.md", *sorted((REPOSITORY / "docs").glob("*.md"))]:
            for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", document.read_text(encoding="utf-8")):
                self.assertTrue((document.parent / target).exists(), f"{document.name} points to {target}")


if __name__ == "__main__":
    unittest.main()
