#!/usr/bin/python3
"""run.sh from outside: a small experiment, with its output where the caller wants it and an exit status that is true.

run.sh takes the build folder from BUILD_DIR; DEVO_EVO_TOOL is the path of the tool.
"""

import os
import pathlib
import signal
import socket
import subprocess
import tempfile
import time
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
SMALL = ["population:=4", "generations:=2", "lifetime:=0.2", "simulators:=1"]
ENDLESS = ["population:=4", "generations:=1000000", "lifetime:=0.2", "simulators:=1"]


def descendants(ancestor):
    """Process ids of all that a process has started, directly or not."""
    parents = {}
    for status in pathlib.Path("/proc").glob("[0-9]*/status"):
        try:
            fields = dict(line.split(":\t", 1) for line in status.read_text(errors="replace").splitlines() if ":\t" in line)
        except OSError:  # it has ended meanwhile
            continue
        parents[int(status.parent.name)] = int(fields["PPid"])
    found = {ancestor}
    while True:
        more = {process for process, parent in parents.items() if parent in found} | found
        if more == found:
            return found - {ancestor}
        found = more


def program_of(process):
    """Name of the program that a process runs; empty if it has ended."""
    try:
        return pathlib.Path(os.readlink(f"/proc/{process}/exe")).name
    except OSError:
        return ""


def listening_addresses(processes):
    """Addresses on which processes wait for connections, as /proc/net writes them: "0100007F" is 127.0.0.1."""
    sockets = set()
    for process in processes:
        try:
            sockets |= {os.readlink(link) for link in pathlib.Path(f"/proc/{process}/fd").iterdir()}
        except OSError:  # it has ended meanwhile
            continue
    lines = [line.split() for table in ("tcp", "tcp6")
             for line in pathlib.Path("/proc/net", table).read_text(encoding="ascii").splitlines()[1:]]
    listening = "0A"
    return [words[1].split(":")[0] for words in lines if words[3] == listening and f"socket:[{words[9]}]" in sockets]


class RunTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()
        self.here = self.folder / "a folder"
        self.here.mkdir()
        # Another python3 stands first, one that cannot do anything; the home folder cannot be written to.
        stranger = self.folder / "bin/python3"
        stranger.parent.mkdir()
        stranger.write_text("#!/bin/sh\necho this is the wrong python3 >&2; exit 66\n", encoding="utf-8")
        stranger.chmod(0o755)
        self.environment = dict(os.environ, PATH=f"{stranger.parent}:/usr/sbin:/usr/bin:/sbin:/bin",
                                HOME="/nonexistent", LC_ALL="C", ROS_MASTER_URI="http://nowhere.invalid:1")

    def start(self, *arguments):
        process = subprocess.Popen([REPOSITORY / "run.sh", *arguments], cwd=self.here, env=self.environment,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   text=True, start_new_session=True)
        self.addCleanup(process.stdout.close)
        return process

    def run_script(self, *arguments):
        process = self.start(*arguments)
        output, _ = process.communicate(timeout=120)
        return process.returncode, output

    def digest(self, *arguments):
        tool = os.environ["DEVO_EVO_TOOL"]
        return subprocess.run([tool, *arguments], check=True, capture_output=True, text=True).stdout.split()[-1]

    def await_file(self, path):
        deadline = time.monotonic() + 60
        while not path.exists():
            self.assertLess(time.monotonic(), deadline, f"{path} was not written")
            time.sleep(0.05)

    def test_runs_and_says_where_results_are(self):
        status, output = self.run_script(*SMALL, "output:=the results")
        self.assertEqual(status, 0, output)
        self.assertIn(str(self.here / "the results/experiment.db"), output)
        self.assertEqual(sorted(path.name for path in self.here.iterdir()), ["the results"])

    def test_the_same_command_again_has_nothing_to_do(self):
        first = self.run_script(*SMALL, "output:=results")
        digest = self.digest("digest", self.here / "results")
        second = self.run_script(*SMALL, "output:=results")
        self.assertEqual((first[0], second[0]), (0, 0), first[1] + second[1])
        self.assertEqual(self.digest("digest", self.here / "results"), digest)

    def test_wrong_values_fail_and_are_named(self):
        for argument, name in (("seed:=-1", "seed"), ("grid:=4x4", "grid"), ("config:=none.yaml", "none.yaml")):
            status, output = self.run_script(*SMALL, "output:=results", argument)
            self.assertNotEqual(status, 0, output)
            self.assertIn(name, output)

    def test_an_output_that_cannot_be_written_fails(self):
        (self.here / "file").write_text("", encoding="utf-8")
        status, output = self.run_script(*SMALL, "output:=file/results")
        self.assertNotEqual(status, 0, output)
        self.assertIn(str(self.here / "file/results"), output)

    def test_a_master_of_somebody_else_is_left_alone(self):
        with socket.socket() as master:
            master.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            try:
                master.bind(("127.0.0.1", 11311))
                master.listen()
            except OSError:
                pass  # somebody has it indeed
            status, output = self.run_script(*SMALL, "output:=results")
        self.assertEqual(status, 0, output)
        self.assertRegex(output, r"port 11311 is in use; .* export ROS_MASTER_URI=http://localhost:113\d\d")

    def test_a_signal_stops_everything(self):
        for number, expected in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            process = self.start(*ENDLESS, f"output:=results {number}")
            self.await_file(self.here / f"results {number}/experiment.db")
            started = descendants(process.pid)
            process.send_signal(number)
            output, _ = process.communicate(timeout=60)
            self.assertEqual(process.returncode, expected, output)
            self.assertEqual([program_of(child) for child in started if program_of(child)], [])

    def test_other_machines_cannot_connect(self):
        process = self.start(*ENDLESS, "output:=results")
        self.await_file(self.here / "results/experiment.db")
        addresses = listening_addresses(descendants(process.pid))
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertGreater(len(addresses), 4, "those of the master, of roslaunch, and two of each node")
        built_with_sanitizer = not list(pathlib.Path(os.environ["BUILD_DIR"]).glob("devel/lib/libdevo_evo_loopback.so"))
        if not built_with_sanitizer:
            self.assertEqual(set(addresses), {"0100007F"})

    def test_an_evolver_that_is_killed_is_a_failure(self):
        process = self.start(*ENDLESS, "output:=results")
        self.await_file(self.here / "results/experiment.db")
        evolvers = [child for child in descendants(process.pid) if program_of(child) == "evolver"]
        self.assertEqual(len(evolvers), 1)
        os.kill(evolvers[0], signal.SIGKILL)
        output, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1, output)


if __name__ == "__main__":
    unittest.main()
