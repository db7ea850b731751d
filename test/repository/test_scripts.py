#!/usr/bin/python3
"""run.sh and scripts/ as far as they need neither network nor ROS."""

import os
import pathlib
import subprocess
import tempfile
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]


def listed_packages():
    lines = (REPOSITORY / "packages.txt").read_text(encoding="utf-8").splitlines()
    return sorted(line.split()[0] for line in lines if line and not line.startswith("#"))


class InstallPackagesTest(unittest.TestCase):
    """With commands of our own in the place of dpkg-query, apt-get, sudo and id."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.calls = self.folder / "calls"
        self.set_user(0)
        self.fake("apt-get", f'echo "apt-get $*" >> {self.calls}')
        self.fake("sudo", f'echo sudo >> {self.calls}; "$@"')

    def fake(self, command, script):
        path = self.folder / command
        path.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
        path.chmod(0o755)

    def set_user(self, number):
        self.fake("id", f"echo {number}")

    def set_installed(self, packages):
        (self.folder / "installed").write_text("".join(f"installed {package}\n" for package in packages),
                                               encoding="utf-8")
        self.fake("dpkg-query", f"cat {self.folder}/installed")

    def run_script(self, *arguments):
        environment = dict(os.environ, PATH=f"{self.folder}:/usr/bin:/bin")
        return subprocess.run([REPOSITORY / "scripts/install_packages", *arguments], env=environment,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)

    def read_calls(self):
        return self.calls.read_text(encoding="utf-8").splitlines() if self.calls.exists() else []

    def test_nothing_missing_calls_nothing_and_says_nothing(self):
        self.set_installed(listed_packages() + ["another"])
        result = self.run_script()
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        self.assertEqual(self.read_calls(), [])

    def test_only_the_missing_are_installed_after_one_update(self):
        self.set_installed(set(listed_packages()) - {"cmake", "catkin"})
        self.assertEqual(self.run_script().returncode, 0)
        update, install = self.read_calls()
        self.assertRegex(update, r"^apt-get .* update$")
        self.assertRegex(install, r"^apt-get .* install -y --no-install-recommends catkin cmake$")

    def test_an_optional_group_is_only_installed_when_asked_for(self):
        self.set_installed(set(listed_packages()) - {"libbenchmark-dev"})
        self.assertEqual(self.run_script("--missing").stdout, "")
        self.assertEqual(self.run_script("--missing", "--for", "benchmarks").stdout, "libbenchmark-dev\n")

    def test_a_package_that_was_removed_counts_as_missing(self):
        self.set_installed(set(listed_packages()) - {"cmake"})
        with open(self.folder / "installed", "a", encoding="utf-8") as installed:
            installed.write("config-files cmake\n")
        self.assertEqual(self.run_script("--missing").stdout, "cmake\n")
        self.assertEqual(self.read_calls(), [])

    def test_a_user_goes_through_sudo(self):
        self.set_user(1000)
        self.set_installed(set(listed_packages()) - {"cmake"})
        self.assertEqual(self.run_script().returncode, 0)
        self.assertEqual([call.split()[0] for call in self.read_calls()], ["sudo", "apt-get", "sudo", "apt-get"])

    def test_an_update_that_fails_does_not_prevent_the_installation(self):
        self.fake("apt-get", f'echo "apt-get $*" >> {self.calls}; case "$*" in *update) exit 100;; esac')
        self.set_installed(set(listed_packages()) - {"cmake"})
        self.assertEqual(self.run_script().returncode, 0)
        self.assertEqual(len(self.read_calls()), 2)

    def test_an_installation_that_fails_is_an_error(self):
        self.fake("apt-get", "exit 100")
        self.set_installed(set(listed_packages()) - {"cmake"})
        result = self.run_script()
        self.assertEqual(result.returncode, 1)
        self.assertIn("could not install", result.stderr)


class RunArgumentsTest(unittest.TestCase):
    @staticmethod
    def run_script(*arguments):
        return subprocess.run([REPOSITORY / "run.sh", *arguments], stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, check=False)

    def test_help_explains_and_does_nothing(self):
        result = self.run_script("--help")
        self.assertEqual(result.returncode, 0)
        self.assertIn("Usage: ./run.sh", result.stdout)

    def test_what_is_no_launch_argument_is_refused_before_anything_happens(self):
        for argument in ("generations=5", "--generations", "5", "GENERATIONS:=5", ":=5", ""):
            result = self.run_script(argument)
            self.assertEqual(result.returncode, 2, argument)
            self.assertIn(f"'{argument}' is not argument:=value", result.stderr)
            self.assertEqual(result.stdout, "")

    def test_an_unknown_argument_is_refused_and_the_known_ones_are_named(self):
        for argument in ("sead:=1", "seed trials:=1", "o:=x"):
            result = self.run_script(argument)
            self.assertEqual((result.returncode, result.stdout), (2, ""), argument)
            self.assertIn("treatment profile trials", result.stderr)

    def test_an_argument_given_twice_is_refused(self):
        result = self.run_script("seed:=1", "trials:=2", "seed:=3")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("'seed' is given twice", result.stderr)


class FuzzAndSanitizeArgumentsTest(unittest.TestCase):
    @staticmethod
    def run_script(name, *arguments):
        return subprocess.run([REPOSITORY / "scripts" / name, *arguments], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, check=False)

    def test_help_explains_and_does_nothing(self):
        for name in ("fuzz", "sanitize"):
            result = self.run_script(name, "--help")
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertIn(f"scripts/{name} [", result.stdout)

    def test_wrong_arguments_are_refused_before_anything_happens(self):
        for arguments in (("--seconds", "0"), ("--seconds",), ("--faster",), ("no_such_target",)):
            result = self.run_script("fuzz", *arguments)
            self.assertEqual((result.returncode, result.stdout), (2, ""), arguments)
        result = self.run_script("sanitize", "memory")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("address or thread", result.stderr)

    def test_what_tries_the_farm_explains_itself(self):
        for name, option in (("chaos", "--seed"), ("soak", "--generations"), ("benchmark_farm", "--simulators")):
            result = self.run_script(name, "--help")
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertIn(f"scripts/{name} [", result.stdout)
            self.assertIn(option, result.stdout)
            self.assertEqual(self.run_script(name, "--faster").returncode, 2)

    def test_chaos_needs_programs(self):
        result = self.run_script("chaos", "--build", "/nonexistent")
        self.assertEqual(result.returncode, 2)
        self.assertIn("there is no evolver in /nonexistent", result.stderr)

    def test_every_fuzz_target_has_a_corpus_and_every_corpus_a_target(self):
        sources = [*(REPOSITORY / "test/fuzz").glob("*.cpp"), *(REPOSITORY / "test/fuzz/ros").glob("*.cpp")]
        corpora = [path for path in (REPOSITORY / "test/fuzz/corpus").iterdir() if any(path.iterdir())]
        self.assertEqual(sorted(path.stem for path in sources), sorted(path.name for path in corpora))


if __name__ == "__main__":
    unittest.main()
