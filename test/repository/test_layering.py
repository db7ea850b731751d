#!/usr/bin/python3
"""Dependencies point one way: nothing outside src/ros, src/rviz_plugin and src/nodes knows of ROS or Qt, and the inner layers
not of the outer."""

import pathlib
import re
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)

# What each layer may include of ours, besides itself; outermost last.
LAYERS = {
    "soft_body": set(),
    "rigid_body": {"soft_body"},
    "evolution": {"soft_body"},
    "bodies": {"soft_body", "rigid_body", "evolution"},
    "farm": {"soft_body", "evolution"},
    "archive": {"soft_body", "evolution", "bodies", "experiment"},
    "experiment": {"soft_body", "evolution", "bodies", "farm", "archive"},
    "render": {"soft_body", "rigid_body", "evolution", "bodies", "archive", "experiment"},
    "study": {"soft_body", "rigid_body", "evolution", "bodies", "farm", "archive", "experiment"},
    "verification": {"soft_body", "evolution", "farm", "archive", "experiment"},
    "picture": {"soft_body", "evolution", "bodies", "archive", "experiment", "render"},
    "interchange": {"soft_body", "evolution", "archive", "experiment"},
    "explanation": {"experiment"},
    "cli": {"soft_body", "evolution", "bodies", "farm", "archive", "experiment", "study", "render", "verification", "picture",
            "interchange", "explanation"},
}
ROS_HEADER = re.compile(r"^(ros|roscpp|rosbag|tf2|tf2_ros|\w+_msgs|std_srvs|diagnostic_updater)/"
                        r"|^devo_evo/[A-Z]\w*\.h$|^rviz(_plugin)?/|^pluginlib/|^Q[A-Zt]\w*(/|$)")


def includes_of(layer):
    """Pairs of file and header included by it, over all files of a layer."""
    for folder in ("include/devo_evo", "src"):
        for path in sorted((REPOSITORY / folder / layer).glob("**/*")):
            if path.suffix in (".h", ".cpp", ".in"):
                for header in INCLUDE.findall(path.read_text(encoding="utf-8")):
                    yield path.relative_to(REPOSITORY), header


class LayeringTest(unittest.TestCase):
    def test_the_core_includes_nothing_of_ros(self):
        found = [f"{path}: {header}" for layer in LAYERS for path, header in includes_of(layer)
                 if ROS_HEADER.search(header)]
        self.assertEqual(found, [])

    def test_layers_include_inner_ones_only(self):
        for layer, allowed in LAYERS.items():
            for path, header in includes_of(layer):
                match = re.match(r"(?:devo_evo/)?(\w+)/", header)
                if match and match.group(1) in LAYERS:
                    self.assertIn(match.group(1), allowed | {layer}, f"{path} includes {header}")

    def test_every_layer_is_looked_at(self):
        for layer in LAYERS:
            self.assertTrue(list(includes_of(layer)), f"no file of layer {layer} includes anything: was it renamed?")


if __name__ == "__main__":
    unittest.main()
