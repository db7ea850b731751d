#!/usr/bin/python3
"""The Dockerfile's steps, without Docker: what it copies is enough, its command runs there, its entry point takes arguments.

Commands that would install or build are ours and only say what they were asked.
"""

import fnmatch
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
PLACE = "/devo_evo"  # of the package in the image


def read_steps():
    """Instructions and their arguments, in order."""
    text = (REPOSITORY / "Dockerfile").read_text(encoding="utf-8").replace("\\\n", " ")
    lines = [line.strip() for line in text.splitlines() if line.strip() and not line.startswith("#")]
    return [tuple(line.split(None, 1)) for line in lines]


def ignored(path, patterns):
    """Whether .dockerignore keeps a path, or a folder that it lies in, out of the image."""
    parts = pathlib.PurePosixPath(path).parts
    for pattern in patterns:
        anywhere = pattern.startswith("**/")
        for depth in range(1, len(parts) + 1):
            candidate = parts[depth - 1] if anywhere else "/".join(parts[:depth])
            same_depth = anywhere or depth == pattern.count("/") + 1
            if same_depth and fnmatch.fnmatchcase(candidate, pattern[3:] if anywhere else pattern):
                return True
    return False


class DockerfileTest(unittest.TestCase):
    def setUp(self):
        self.steps = read_steps()
        lines = (REPOSITORY / ".dockerignore").read_text(encoding="utf-8").splitlines()
        self.patterns = [line for line in lines if line and not line.startswith("#")]

    def arguments_of(self, instruction):
        found = [arguments for name, arguments in self.steps if name == instruction]
        self.assertEqual(len(found), 1, instruction)
        return found[0]

    def copy_as_docker_does(self, folder):
        """Copies the repository to a folder, but for what .dockerignore names."""
        def names_to_leave_out(directory, names):
            relative = os.path.relpath(directory, REPOSITORY)
            return [name for name in names
                    if name == ".git" or ignored(os.path.normpath(os.path.join(relative, name)), self.patterns)]
        shutil.copytree(REPOSITORY, folder, ignore=names_to_leave_out, symlinks=True)

    def test_it_is_debian_12_with_the_whole_repository(self):
        self.assertEqual(self.steps[0], ("FROM", "debian:12"))
        self.assertEqual(self.arguments_of("COPY"), f". {PLACE}")

    def test_only_what_is_made_here_is_left_out(self):
        for path in ("build", "build/CMakeCache.txt", "build-fuzz/x", "results/first/experiment.db", "output/x",
                     "src/devo_evo/__pycache__/archive.cpython-311.pyc"):
            self.assertTrue(ignored(path, self.patterns), path)
        for path in ("scripts/build", "run.sh", "src/experiment/build_info.cpp", "test/data/results.jsonl", ".git/HEAD"):
            self.assertFalse(ignored(path, self.patterns), path)
        if (REPOSITORY / ".git").exists():
            # Whoever runs the tests need not be who owns the files.
            tracked = subprocess.run(["git", "-c", f"safe.directory={REPOSITORY}", "ls-files"], cwd=REPOSITORY, check=True,
                                     capture_output=True, text=True).stdout.splitlines()
            self.assertEqual([path for path in tracked if ignored(path, self.patterns)], [])

    def test_its_command_runs_on_what_was_copied(self):
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)
            self.copy_as_docker_does(root / PLACE[1:])
            calls = root / "calls"
            commands = root / "commands"
            commands.mkdir()
            for command in ("apt-get", "cmake", "git", "chmod", "ln", "mkdir", "rm"):
                script = f"#!/bin/sh\necho {command} \"$@\" >> {calls}\n"
                if command == "mkdir":  # scripts/build needs its folder
                    script += "exec /bin/mkdir \"$@\"\n"
                (commands / command).write_text(script, encoding="utf-8")
                (commands / command).chmod(0o755)
            # Nothing is installed yet, and the installer is root, as in an image.
            (commands / "dpkg-query").write_text("#!/bin/sh\n", encoding="utf-8")
            (commands / "id").write_text("#!/bin/sh\necho 0\n", encoding="utf-8")
            for command in ("dpkg-query", "id"):
                (commands / command).chmod(0o755)
            script = self.arguments_of("RUN").replace(PLACE, f"{root}{PLACE}").replace(" /results", f" {root}/results")
            done = subprocess.run(["/bin/sh", "-ec", script], capture_output=True, text=True, check=False,
                                  env={"PATH": f"{commands}:/usr/bin:/bin", "HOME": name}, stdin=subprocess.DEVNULL)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            said = calls.read_text(encoding="utf-8")
            order = ["apt-get update", "install -y --no-install-recommends git", f"git config --system --add safe.directory {root}{PLACE}",
                     "libsqlitecpp-dev", f"cmake -G Ninja -S {root}{PLACE} -B {root}{PLACE}/build",
                     f"cmake --build {root}{PLACE}/build", f"chmod -R a+rwX {root}{PLACE}/build", "ln -s"]
            places = [said.find(part) for part in order]
            self.assertNotIn(-1, places, said)
            self.assertEqual(places, sorted(places), said)

    def test_whoever_runs_it_need_not_own_what_every_build_looks_at(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            folder.chmod(0o777)
            output = folder / "build_constants.cpp"
            for source in ("src/experiment/build_constants.cpp.in", "cmake/build_info.cmake"):
                shutil.copy(REPOSITORY / source, folder)
            command = ["cmake", "-D", f"SOURCE_DIR={name}", "-D", f"TEMPLATE={name}/build_constants.cpp.in",
                       "-D", f"OUTPUT={output}", "-D", "VERSION=1.2.3", "-D", "COMPILER=a; b", "-P", f"{name}/build_info.cmake"]
            subprocess.run(command, check=True)
            written = output.read_text(encoding="utf-8")
            self.assertIn('"1.2.3", "", "a; b"', written)
            output.chmod(0o666)
            before = output.stat().st_mtime_ns
            stranger = ["setpriv", "--reuid=12345", "--clear-groups"] if os.getuid() == 0 else []
            subprocess.run([*stranger, *command], check=True)
            self.assertEqual(output.stat().st_mtime_ns, before)

    def test_its_entry_point_takes_the_arguments_of_run_sh(self):
        command = json.loads(self.arguments_of("ENTRYPOINT"))
        self.assertEqual(command, [f"{PLACE}/run.sh"])
        script = REPOSITORY / command[0][len(PLACE) + 1:]
        self.assertTrue(os.access(script, os.X_OK))
        done = subprocess.run([script, "--help"], capture_output=True, text=True, check=True)
        self.assertIn("generations:=20", done.stdout)

    def test_results_go_where_the_documented_commands_mount_them(self):
        text = (REPOSITORY / "Dockerfile").read_text(encoding="utf-8")
        self.assertIn('-v "$PWD/results:/results"', text)
        self.assertIn("HOME=/results", self.arguments_of("ENV"))
        self.assertEqual(self.arguments_of("WORKDIR"), "/results")


if __name__ == "__main__":
    unittest.main()
