#!/usr/bin/python3
"""What is installed works by itself: the tool, the library for find_package(devo_evo_core), launch files, manual."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

BUILD = pathlib.Path(os.environ.get("BUILD_DIR", pathlib.Path(__file__).resolve().parents[2] / "build"))
WITH_ROS = (BUILD / "devel").is_dir()

PROGRAM = """\
#include <devo_evo/soft_body/simulation.h>
#include <iostream>
int main() {
  devo_evo::SoftBodySettings settings; settings.lifetime = 0.1;
  const std::vector<double> sizes(48, 0.25), phases(48, 0.125);
  std::cout << std::hex << devo_evo::evaluate(settings, { { sizes, sizes, phases, phases } })[0].state_hash << "\\n";
}
"""
CMAKE = """\
cmake_minimum_required(VERSION 3.16)
project(five_lines LANGUAGES CXX)
find_package(devo_evo_core REQUIRED)
add_executable(five_lines main.cpp)
target_link_libraries(five_lines PRIVATE devo_evo::devo_evo_core)
"""


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command} exited with {done.returncode}:\n{done.stdout[-3000:]}\n{done.stderr[-3000:]}")
    return done.stdout


def cached(variable):
    """The value that the build was configured with."""
    for line in (BUILD / "CMakeCache.txt").read_text(encoding="utf-8").splitlines():
        if line.startswith(variable + ":"):
            return line.split("=", 1)[1]
    return ""


class InstallTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        root = pathlib.Path(cls.folder.name)
        # With DESTDIR, since catkin installs some of its files to the prefix that was configured.
        run("cmake", "--install", BUILD, env={**os.environ, "DESTDIR": str(root)})
        cls.prefix = root / cached("CMAKE_INSTALL_PREFIX").lstrip("/")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_everything_is_there(self):
        expected = ["bin/devo_evo", "include/devo_evo/soft_body/simulation.h", "share/devo_evo/config/experiment.yaml",
                    "share/man/man1/devo_evo.1", "share/bash-completion/completions/devo_evo", "share/doc/devo_evo/LICENSE"]
        if WITH_ROS:
            expected += ["lib/devo_evo/evolver", "lib/devo_evo/simulator", "lib/devo_evo/devo_evo",
                         "lib/libdevo_evo_rviz.so", "share/devo_evo/plugin_description.xml",
                         "share/devo_evo/launch/experiment.launch", "share/devo_evo/package.xml",
                         "share/devo_evo/cmake/devo_evoConfig.cmake", "include/devo_evo/RobotGenome.h"]
        self.assertEqual([path for path in expected if not (self.prefix / path).exists()], [])

    @unittest.skipUnless(WITH_ROS, "without catkin, every prefix will do")
    def test_another_prefix_than_the_configured_one_is_refused_before_anything_is_installed(self):
        elsewhere = pathlib.Path(self.folder.name) / "elsewhere"
        done = subprocess.run(["cmake", "--install", BUILD, "--prefix", elsewhere], capture_output=True, text=True, check=False)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn(f"configure it with -DCMAKE_INSTALL_PREFIX={elsewhere}", " ".join(done.stderr.split()))
        self.assertFalse(elsewhere.exists())

    def test_the_python_module_is_found_by_the_tool_and_by_python(self):
        modules = self.prefix / "lib/python3/dist-packages"
        self.assertTrue((modules / "devo_evo/claims/__init__.py").exists(), modules)
        found = run("/usr/bin/python3", "-c", "import devo_evo; print(devo_evo.__file__)",
                    env={**os.environ, "PYTHONPATH": str(modules)})
        self.assertTrue(found.startswith(str(modules)), found)

    def test_the_tool_runs(self):
        self.assertTrue(run(self.prefix / "bin/devo_evo", "--version").startswith("devo_evo "))
        self.assertIn("body lengths", run(self.prefix / "bin/devo_evo", "explain", "fitness"))

    def test_a_program_of_five_lines_evaluates_a_robot_as_the_tool_does(self):
        source = pathlib.Path(self.folder.name) / "five_lines"
        source.mkdir()
        (source / "main.cpp").write_text(PROGRAM, encoding="utf-8")
        (source / "CMakeLists.txt").write_text(CMAKE, encoding="utf-8")
        sanitizers = cached("DEVO_EVO_SANITIZE")  # whose runtime is the compiler's own
        flags = [f"-DCMAKE_CXX_FLAGS=-fsanitize={sanitizers}", f"-DCMAKE_CXX_COMPILER={cached('CMAKE_CXX_COMPILER')}"]
        run("cmake", "-G", "Ninja", "-S", source, "-B", source / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}",
            *(flags if sanitizers else []))
        run("cmake", "--build", source / "build")
        state_hash = run(source / "build/five_lines").strip().zfill(16)
        robot = {"id": 1, "size_gene_initial": [0.25] * 48, "phase_initial_cycles": [0.125] * 48}
        (source / "robot.jsonl").write_text(json.dumps(robot), encoding="utf-8")
        told = json.loads(run(self.prefix / "bin/devo_evo", "evaluate", source / "robot.jsonl", "--lifetime", "0.1"))
        self.assertEqual(state_hash, told["state_hash"])

    def test_bash_completes_commands_options_and_names(self):
        completion = self.prefix / "share/bash-completion/completions/devo_evo"

        def complete(*words):
            quoted = " ".join(f"'{word}'" for word in words)
            script = (f"source {completion}; COMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}; _devo_evo; "
                      "printf '%s\\n' \"${COMPREPLY[@]}\"")
            return run("bash", "-c", script).split()

        self.assertEqual(complete("devo_evo", "ver"), ["verify"])
        self.assertEqual(complete("devo_evo", "verify", "--lin"), ["--lineage"])
        self.assertEqual(complete("devo_evo", "explain", "airb"), ["airborne_fraction"])

    def test_the_manual_page_names_every_command_and_option(self):
        page = (self.prefix / "share/man/man1/devo_evo.1").read_text(encoding="utf-8").replace("\\-", "-")
        tool = self.prefix / "bin/devo_evo"
        help_text = run(tool, "--help")
        commands = [line.split()[0] for line in help_text.split("Subcommands:")[1].splitlines()
                    if line.startswith("  ") and line[2] != " "]
        self.assertIn("verify", commands)
        for command in commands:
            self.assertIn(f".SS {command}\n", page)
            for line in run(tool, command, "--help").splitlines():
                for word in line.split() if line.startswith("  -") else []:
                    if word.startswith("--"):
                        self.assertIn(word.split(",")[0].rstrip(","), page, command)


if __name__ == "__main__":
    unittest.main()
