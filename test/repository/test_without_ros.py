#!/usr/bin/python3
"""The part without ROS builds where there is no ROS: in a file system that shows nothing of it, if the kernel allows that."""

import os
import pathlib
import subprocess
import tempfile
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]

# Everything by which CMake or the compiler could find ROS here.
HIDDEN = ["/opt/ros", "/usr/share/catkin", "/usr/share/roscpp", "/usr/share/std_msgs", "/usr/include/ros",
          "/usr/include/std_msgs", "/usr/share/message_generation"]


def in_a_world_without_ros(script):
    """The command line that runs a script with these folders empty."""
    mounts = "; ".join(f"[ ! -d {folder} ] || mount -t tmpfs none {folder}" for folder in HIDDEN)
    return ["unshare", "--user", "--map-root-user", "--mount", "bash", "-ec", f"{mounts}\n{script}"]


class WithoutRosTest(unittest.TestCase):
    def test_library_and_tool_build_and_work(self):
        with tempfile.TemporaryDirectory() as build:
            # Without optimisation, which takes most of the time and is tested elsewhere.
            script = (f"[ -z \"$(ls -A /usr/include/ros 2>/dev/null)\" ] || exit 77\n"
                      f"cmake -G Ninja -S {REPOSITORY} -B {build} -DDEVO_EVO_ROS=OFF -DBUILD_TESTING=OFF "
                      f"-DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O0\n"
                      f"cmake --build {build} --parallel {os.cpu_count()} --target devo_evo_cli\n"
                      f"{build}/devo_evo --version\n")
            environment = {name: value for name, value in os.environ.items()
                           if not name.startswith("ROS_") and name not in ("CMAKE_PREFIX_PATH", "PYTHONPATH")}
            allowed = subprocess.run(in_a_world_without_ros("true"), capture_output=True, check=False).returncode == 0
            command = in_a_world_without_ros(script) if allowed else ["bash", "-ec", script.split("\n", 1)[1]]
            if not allowed:
                print("mounts are not allowed here: ROS could not be hidden, only left out")
            done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout[-2000:] + done.stderr[-2000:])
            self.assertIn("devo_evo ", done.stdout.splitlines()[-1])


if __name__ == "__main__":
    unittest.main()
