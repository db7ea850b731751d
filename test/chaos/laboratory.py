"""Hosts, networks and processes for tests of the farm that rosunit cannot do: several machines, links that are cut, a
master that dies. Every host is a network namespace of its own, with a wire to a switch."""

import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
import xmlrpc.client

SKIPPED = 77  # exit status that ctest takes for "not run"

INSIDE = 'DEVO_EVO_LABORATORY'  # set once this process lives in a network namespace of its own
NETWORK = '10.77.0.'


def program(name):
    """Path of one of our programs."""
    build = os.environ.get('BUILD_DIR', os.path.join(os.path.dirname(__file__), '..', '..', 'build'))
    return os.path.join(build, 'devel/lib/devo_evo', name)


def enter_namespace():
    """Starts this script again in a network namespace of its own, as root or as a user who may. Returns why that is
    impossible; '' if it has been done."""
    if os.environ.get(INSIDE):
        return ''
    command = ['unshare', '--net', '--uts'] if os.geteuid() == 0 else ['unshare', '--user', '--map-root-user', '--net', '--uts']
    trial = 'ip link add switch0 type bridge && ip link add wire1 type veth peer name wire2 && ip link set wire1 master switch0'
    try:
        probe = subprocess.run([*command, 'sh', '-c', trial], capture_output=True, text=True, check=False)
    except FileNotFoundError as error:
        return str(error)
    if probe.returncode != 0:
        return 'network namespaces cannot be made here: ' + (probe.stderr.strip() or 'unknown reason')
    os.environ[INSIDE] = '1'
    sys.stdout.flush()
    os.execvp(command[0], [*command, sys.executable, *sys.argv])
    raise AssertionError('not reached')


def wait_until(condition, what, timeout=60.0):
    """Polls until the condition holds, and returns its value; fails with `what` otherwise."""
    end = time.monotonic() + timeout
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.02)
    raise AssertionError('timed out waiting until ' + what)


class Node:
    """A program on a host, with what it says."""

    def __init__(self, name, command, environment, folder):
        self.name = name
        self.log = tempfile.NamedTemporaryFile(dir=folder, prefix=name + '.', suffix='.log', delete=False)
        self.process = subprocess.Popen(command, env=environment, stdin=subprocess.DEVNULL, stdout=self.log,
                                        stderr=subprocess.STDOUT)
        self.stopped = False

    def output(self):
        with open(self.log.name, encoding='utf-8', errors='replace') as log:
            return log.read()

    def said(self, text):
        return text in self.output()

    def running(self):
        return self.process.poll() is None

    def send(self, number):
        if self.running():
            self.process.send_signal(number)
            self.stopped = number == signal.SIGSTOP

    def kill(self):
        self.send(signal.SIGKILL)
        self.process.wait()

    def wait(self, timeout=120.0):
        return self.process.wait(timeout)

    def close(self):
        """Ends it, gently if it lets us."""
        if self.running():
            self.send(signal.SIGCONT)
            self.process.terminate()
            try:
                self.process.wait(20.0)
            except subprocess.TimeoutExpired:
                self.kill()
        self.log.close()


class Host:
    """A machine with one wire, or this one (without a wire) where there are no namespaces."""

    def __init__(self, laboratory, name, address, holder=None):
        self.laboratory = laboratory
        self.name = name
        self.address = address
        self.holder = holder  # the process that keeps its namespaces
        self.port = 'port-' + name

    def command(self, arguments):
        if self.holder is None:
            return list(arguments)
        return ['nsenter', '--target', str(self.holder.pid), '--net', '--uts', '--', *arguments]

    def start(self, name, *arguments):
        environment = dict(os.environ, ROS_MASTER_URI=self.laboratory.master_uri, ROS_IP=self.address,
                           ROS_HOME=self.laboratory.folder, ROSCONSOLE_FORMAT='[${severity}] ${message}')
        environment.pop('ROS_HOSTNAME', None)
        node = Node(name, self.command(arguments), environment, self.laboratory.folder)
        self.laboratory.nodes.append(node)
        return node

    def start_simulator(self, **parameters):
        parameters = dict({'announcement_period': 0.2}, **parameters)
        return self.start('simulator', program('simulator'), '__ns:=laboratory',
                          *['_%s:=%s' % parameter for parameter in parameters.items()])

    def link_down(self):
        """The plug is pulled: the host itself knows."""
        self.run('ip', 'link', 'set', 'eth0', 'down')

    def link_up(self):
        self.run('ip', 'link', 'set', 'eth0', 'up')

    def drop_packets(self):
        """The wire leads nowhere: nobody is told."""
        subprocess.run(['ip', 'link', 'set', self.port, 'nomaster'], check=True)

    def pass_packets(self):
        subprocess.run(['ip', 'link', 'set', self.port, 'master', 'switch0'], check=True)

    def run(self, *arguments):
        subprocess.run(self.command(arguments), check=True)


class Laboratory:
    """An evolver's host with a ROS master, and others around it."""

    def __init__(self):
        self.temporary = tempfile.TemporaryDirectory(prefix='devo_evo_laboratory.')
        self.folder = self.temporary.name
        self.nodes = []
        self.hosts = []
        self.networked = bool(os.environ.get(INSIDE))
        self.address = NETWORK + '1' if self.networked else '127.0.0.1'
        if self.networked:
            for command in ('ip link set lo up', 'ip link add switch0 type bridge', 'ip link set switch0 up',
                            'ip address add %s/24 dev switch0' % self.address, 'hostname evolverhost'):
                subprocess.run(command.split(), check=True)
        with socket.socket() as probe:
            probe.bind((self.address, 0))
            self.master_port = probe.getsockname()[1]
        self.master_uri = 'http://%s:%d' % (self.address, self.master_port)
        self.home = Host(self, 'evolverhost', self.address)
        self.master = None
        self.start_master()

    def __enter__(self):
        return self

    def __exit__(self, *exception):
        for node in reversed(self.nodes):
            node.close()
        for host in self.hosts:
            if host.holder:
                host.holder.kill()
                host.holder.wait()
        if self.networked:
            subprocess.run(['ip', 'link', 'delete', 'switch0'], check=True)
        if exception[0] is not None:
            for node in self.nodes:
                print('---- %s ----\n%s' % (node.name, node.output()))
        self.temporary.cleanup()

    def start_master(self):
        self.master = self.home.start('rosmaster', 'rosmaster', '--core', '-p', str(self.master_port))

        def answers():
            try:
                return self.ask_master('getPid')
            except OSError:
                return None
        wait_until(answers, 'the master answers')

    def ask_master(self, method):
        with xmlrpc.client.ServerProxy(self.master_uri) as master:
            return getattr(master, method)('/laboratory')[2]

    def add_host(self, name):
        """Another machine; without namespaces, another name for this one."""
        holder = None
        address = self.address
        if self.networked:
            holder = subprocess.Popen(['unshare', '--net', '--uts', 'sleep', 'infinity'])
            own = os.readlink('/proc/self/ns/net')
            wait_until(lambda: os.readlink('/proc/%d/ns/net' % holder.pid) != own, 'the namespace is there')
            address = NETWORK + str(len(self.hosts) + 2)
        host = Host(self, name, address, holder)
        self.hosts.append(host)
        if holder:
            for command in ('ip link add %s type veth peer name eth0 netns %d' % (host.port, holder.pid),
                            'ip link set %s master switch0' % host.port, 'ip link set %s up' % host.port):
                subprocess.run(command.split(), check=True)
            for command in ('hostname ' + name, 'ip link set lo up', 'ip address add %s/24 dev eth0' % address,
                            'ip link set eth0 up'):
                host.run(*command.split())
        return host

    def start_evolver(self, **parameters):
        return self.home.start('evolver', program('evolver'), '__ns:=laboratory', '__name:=evolver',
                               *['_%s:=%s' % parameter for parameter in parameters.items()])

    def path(self, name):
        return os.path.join(self.folder, name)


def digest(output):
    return subprocess.check_output([program('devo_evo'), 'digest', output], text=True).strip()


def undisturbed_digest(laboratory, parameters):
    """What `devo_evo evolve` makes of the same parameters."""
    output = laboratory.path('undisturbed')
    options = [part for name, value in parameters.items() for part in ('--' + name, str(value))]
    subprocess.run([program('devo_evo'), 'evolve', '--simulators', '2', '--output', output, *options],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return digest(output)
