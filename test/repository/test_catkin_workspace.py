#!/usr/bin/python3
"""The package in a catkin workspace beside one that uses it, by catkin_make and by catkin build.

Configured in earnest and messages made; of what remains, ninja only says what it would build, since compiling everything once
more takes long.
"""

import os
import pathlib
import subprocess
import tempfile
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
PYTHON = "/usr/bin/python3"

MANIFEST = """\
<package format="3">
  <name>devo_evo_user</name><version>0.0.0</version><description>Uses devo_evo.</description>
  <maintainer email="nobody@devo-evo.example">nobody</maintainer><license>none</license>
  <buildtool_depend>catkin</buildtool_depend>
  <depend>devo_evo</depend>
</package>
"""
BUILD = """\
cmake_minimum_required(VERSION 3.16)
project(devo_evo_user LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 17)
find_package(catkin REQUIRED COMPONENTS devo_evo)
catkin_package()
add_executable(reader main.cpp)
add_dependencies(reader ${catkin_EXPORTED_TARGETS})
target_include_directories(reader PRIVATE ${catkin_INCLUDE_DIRS})
target_link_libraries(reader PRIVATE ${catkin_LIBRARIES})
"""
PROGRAM = """\
#include <devo_evo/RobotGenome.h>
#include <devo_evo/soft_body/settings.h>
int main() { return devo_evo::RobotGenome().arrays.size() + devo_evo::SoftBodySettings().grid_x == 4 ? 0 : 1; }
"""
CONFIGURATION = ["--cmake-args", "-DCMAKE_BUILD_TYPE=Release", "-DCATKIN_ENABLE_TESTING=OFF",
                 f"-DPYTHON_EXECUTABLE={PYTHON}"]
ONLY_MESSAGES = ["--make-args", "devo_evo_generate_messages"]


def run(*command, folder):
    """Standard output of a command in a shell that has sourced nothing."""
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("ROS_", "CATKIN_", "CMAKE_PREFIX", "PYTHONPATH", "PKG_CONFIG"))}
    environment.update(PATH="/usr/sbin:/usr/bin:/sbin:/bin", PWD=str(folder))  # catkin_make believes PWD
    done = subprocess.run(command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{command} exited with {done.returncode}:\n{done.stdout[-4000:]}")
    return done.stdout


class CatkinWorkspaceTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.workspace = pathlib.Path(folder.name).resolve()
        sources = self.workspace / "src"
        user = sources / "devo_evo_user"
        user.mkdir(parents=True)
        (sources / "devo_evo").symlink_to(REPOSITORY)
        for name, text in (("package.xml", MANIFEST), ("CMakeLists.txt", BUILD), ("main.cpp", PROGRAM)):
            (user / name).write_text(text, encoding="utf-8")

    def expect_a_sound_development_space(self, messages):
        """What one has after sourcing the set-up file: the package, its Python module and its messages."""
        script = (f"source devel/setup.bash && rospack find devo_evo && {PYTHON} -c "
                  "'import devo_evo.msg, devo_evo.archive; print(devo_evo.msg.RobotGenome._type)'")
        self.assertIn("devo_evo/RobotGenome", run("bash", "-ec", script, folder=self.workspace))
        self.assertTrue((messages / "include/devo_evo/RobotGenome.h").exists())

    def test_catkin_make_configures_both_and_would_build_all_of_them(self):
        # Whatever else the machine does: catkin_make would wait for its load to fall.
        run("catkin_make", "--use-ninja", "-j", str(os.cpu_count()), "-l", "1000", *CONFIGURATION, *ONLY_MESSAGES,
            folder=self.workspace)
        self.expect_a_sound_development_space(self.workspace / "devel")
        plan = run("ninja", "-t", "commands", folder=self.workspace / "build")
        for product in ("devel/lib/devo_evo/evolver", "devel/lib/devo_evo/devo_evo", "devel/lib/libdevo_evo_core.a", "reader"):
            self.assertIn(product, plan)

    def test_catkin_build_configures_the_package_and_makes_its_messages(self):
        # Merged, or else it would look for the messages' target in a package of its own.
        run("catkin", "config", "--init", "--merge-devel", folder=self.workspace)
        run("catkin", "build", "devo_evo", "--no-status", "--no-notify", "-j", str(os.cpu_count()), *CONFIGURATION,
            *ONLY_MESSAGES, folder=self.workspace)
        self.expect_a_sound_development_space(self.workspace / "devel")


if __name__ == "__main__":
    unittest.main()
