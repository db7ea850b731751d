#!/usr/bin/python3
"""packages.txt, which is installed from, and package.xml, which catkin reads, name the same dependencies."""

import pathlib
import unittest
import xml.etree.ElementTree

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]


def read_packages():
    """Debian package, package.xml dependency and optional group, if any, as packages.txt lists them."""
    lines = (REPOSITORY / "packages.txt").read_text(encoding="utf-8").splitlines()
    return [line.split() for line in lines if line and not line.startswith("#")]


def read_manifest():
    """Names of all dependencies in package.xml."""
    manifest = xml.etree.ElementTree.parse(REPOSITORY / "package.xml").getroot()
    return {element.text for element in manifest if element.tag.endswith("depend")}


class PackagesTest(unittest.TestCase):
    def test_every_line_names_a_package_and_what_it_stands_for(self):
        for fields in read_packages():
            self.assertIn(len(fields), (2, 3), fields)

    def test_no_package_is_listed_twice(self):
        packages = [fields[0] for fields in read_packages()]
        self.assertEqual(sorted(set(packages)), sorted(packages))

    def test_list_and_manifest_name_the_same_dependencies(self):
        listed = {fields[1] for fields in read_packages()} - {"-"}
        self.assertEqual(listed, read_manifest())


if __name__ == "__main__":
    unittest.main()
