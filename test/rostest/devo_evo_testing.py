"""What the tests of whole experiments share: starting nodes, waiting for what they do, comparing digests."""

import collections
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import roslib.packages
import rospy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), '../chaos'))
from laboratory import wait_until  # noqa: E402, F401: tests take it from here

# Short lives in a small experiment: a run takes a second or two.
SMALL = {'lifetime': 0.2, 'population': 6, 'generations': 5, 'trials': 2, 'seed': 3}

# The arrays of the genomes of soft robots of 4x4x3 voxels.
VOXEL_ARRAYS = [(name, 48) for name in ('size_gene_initial', 'size_gene_final', 'phase_initial', 'phase_final')]


def array_sizes(genome):
    """Names and sizes of the arrays of a RobotGenome, in their order."""
    return [(array.name, len(array.values)) for array in genome.arrays]


def program(name):
    """Path of one of our programs."""
    return roslib.packages.find_node('devo_evo', name)[0]


class Process:
    """A program that runs beside the test, with what it says."""

    def __init__(self, arguments, folder, namespace):
        self.name = os.path.basename(arguments[0])
        self.log = tempfile.NamedTemporaryFile(dir=folder, prefix=self.name + '.', suffix='.log', delete=False)
        environment = dict(os.environ, ROS_NAMESPACE=namespace, ROSCONSOLE_FORMAT='[${severity}] ${message}')
        self.process = subprocess.Popen(
            arguments, env=environment, stdin=subprocess.DEVNULL, stdout=self.log, stderr=subprocess.STDOUT)

    def said(self, text):
        """Whether the text is in what it has said so far."""
        return text in self.output()

    def output(self):
        with open(self.log.name, encoding='utf-8', errors='replace') as log:
            return log.read()

    def running(self):
        return self.process.poll() is None

    def signal(self, number):
        self.process.send_signal(number)

    def wait(self, timeout=60.0):
        """Its exit status."""
        try:
            return self.process.wait(timeout)
        except subprocess.TimeoutExpired:
            raise AssertionError('%s does not end' % self.name) from None

    def stop(self):
        if self.running():
            self.process.send_signal(signal.SIGCONT)
            self.process.terminate()
            try:
                self.process.wait(20.0)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
        self.log.close()


# Lines that rviz says on any Debian, whatever it shows.
RVIZ_SAYS_ANYWAY = ('no such package media_export', 'error while executing command')


def rviz_complaints(output):
    """Lines of errors and warnings."""
    return [line for line in output.splitlines()
            if ('rror' in line or 'ARN' in line or 'xception' in line)
            and not any(known in line for known in RVIZ_SAYS_ANYWAY)]


class VirtualDisplay:
    """An X server without a screen; DISPLAY names it meanwhile. Its number is that of this process: if servers looked for a
    free one, one that ends could take the socket away from another that begins."""

    ROBOT = '400x300+230+250'  # where rviz shows the robot that its camera follows

    def __enter__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(['Xvfb', ':%d' % (100 + os.getpid() % 50000), '-displayfd', str(write),
                                        '-screen', '0', '1280x800x24', '-nolisten', 'tcp'],
                                       pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as number:
            self.name = ':' + number.readline().strip()
        self.before = {name: os.environ.get(name) for name in ('DISPLAY', 'LIBGL_ALWAYS_SOFTWARE')}
        os.environ.update(DISPLAY=self.name, LIBGL_ALWAYS_SOFTWARE='1')
        return self

    def __exit__(self, *_):
        for name, value in self.before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value
        self.server.terminate()
        self.server.wait()

    def pixels(self, area):
        """Red, green and blue of every pixel within an area, written like 400x300+440+250."""
        data = subprocess.run(['import', '-window', 'root', '-crop', area, '-depth', '8', 'rgb:-'], check=True,
                              capture_output=True).stdout
        return list(zip(data[0::3], data[1::3], data[2::3]))

    def colours(self, area):
        """How many pixels of each bright, saturated colour there are in an area."""
        return collections.Counter(pixel for pixel in self.pixels(area) if max(pixel) - min(pixel) > 100)

    def wait_for_robot(self, area=ROBOT):
        """Until rviz shows one."""
        def seen():
            colours = self.colours(area)
            return len(colours) >= 3 and sum(colours.values()) > 500
        wait_until(seen, 'the robot is seen', 120.0)

    @staticmethod
    def click(x, y):
        subprocess.run(['xdotool', 'mousemove', str(x), str(y), 'click', '1'], check=True)


class ExperimentTest(unittest.TestCase):
    """Every test has a namespace and folders of its own."""

    digests = {}  # of undisturbed experiments, by parameters

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix='devo_evo_test_')
        self.output = os.path.join(self.folder, 'output')
        self.namespace = '/' + self._testMethodName
        self.processes = []

    def tearDown(self):
        for process in reversed(self.processes):
            process.stop()
        outcome = self._outcome.result if hasattr(self._outcome, 'result') else self._outcome
        if any(test is self for test, _ in outcome.failures + outcome.errors):
            for process in self.processes:
                print('---- %s ----\n%s' % (process.name, process.output()))
        shutil.rmtree(self.folder, ignore_errors=True)

    def start(self, *arguments, namespace=None):
        self.processes.append(Process(list(arguments), self.folder, namespace or self.namespace))
        return self.processes[-1]

    def evolve(self, **parameters):
        """An archive of short lives in the output folder."""
        options = dict({'lifetime': 0.5, 'population': 4, 'generations': 1, 'trials': 1}, **parameters)
        subprocess.run([program('devo_evo'), 'evolve', '--output', self.output] +
                       [part for name, value in options.items() for part in ('--' + name, str(value))],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def listen(self, topic, message):
        heard = []
        subscriber = rospy.Subscriber(topic if topic.startswith('/') else self.namespace + '/' + topic, message, heard.append)
        self.addCleanup(subscriber.unregister)
        return heard

    def start_evolver(self, **parameters):
        name = self.namespace + '/evolver'
        if rospy.has_param(name):
            rospy.delete_param(name)
        rospy.set_param(name, dict(SMALL, output=self.output, **parameters))
        return self.start(program('evolver'))

    def start_simulator(self, **parameters):
        shared = self.namespace + '/simulators_%d' % len(self.processes)
        rospy.set_param(shared, dict({'announcement_period': 0.1}, **parameters))
        return self.start(program('simulator'), '--parameters', shared)

    def launch(self, file, **arguments):
        return self.start('roslaunch', '--no-summary', '--disable-title', 'devo_evo', file, 'ns:=' + self.namespace[1:],
                          *['%s:=%s' % argument for argument in arguments.items()], namespace='/')

    def wait_for_success(self, process):
        status = process.wait()
        self.assertEqual(status, 0, process.output())

    def digest(self):
        return subprocess.check_output([program('devo_evo'), 'digest', self.output], text=True).strip()

    def undisturbed_digest(self, **parameters):
        """What `devo_evo evolve` makes of a small experiment with these parameters."""
        return self.digest_of_evolve(dict(SMALL, **parameters))

    def digest_of_evolve(self, parameters):
        """What `devo_evo evolve` makes of these parameters."""
        key = tuple(sorted(parameters.items()))
        if key not in self.digests:
            output = os.path.join(self.folder, 'undisturbed')
            options = [part for name, value in parameters.items() for part in ('--' + name, str(value))]
            subprocess.run([program('devo_evo'), 'evolve', '--simulators', '2', '--output', output] + options,
                           check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            self.digests[key] = subprocess.check_output(
                [program('devo_evo'), 'digest', output], text=True).strip()
        return self.digests[key]
