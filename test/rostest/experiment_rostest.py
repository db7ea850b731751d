#!/usr/bin/python3
"""Experiments by launch files: their results, their arguments, their end."""

import os
import signal
import sqlite3
import sys

import roslib.packages
import rospy
import rostest

from devo_evo_testing import SMALL, ExperimentTest, program, wait_until


class LaunchTest(ExperimentTest):

    def launch_experiment(self, **arguments):
        return self.launch('experiment.launch', **dict(SMALL, output=self.output, **arguments))

    def test_one_simulator_gives_the_digest_of_evolve(self):
        launched = self.launch_experiment(simulators=1)
        self.wait_for_success(launched)
        self.assertTrue(launched.said('finished\nResults:    %s/experiment.db' % self.output))
        self.assertTrue(launched.said('Digest:     ' + self.undisturbed_digest()))
        self.assertEqual(self.digest(), self.undisturbed_digest())

    def test_three_simulators_give_the_digest_of_evolve(self):
        launched = self.launch_experiment(simulators=3)
        self.wait_for_success(launched)
        self.assertEqual(launched.output().count(') joined'), 3)
        self.assertEqual(self.digest(), self.undisturbed_digest())
        archive = sqlite3.connect(self.output + '/experiment.db')
        (processor, host), = archive.execute('SELECT processor, host FROM starts').fetchall()
        simulated, = archive.execute('SELECT count(DISTINCT phenotype_hash) FROM individuals').fetchone()
        self.assertEqual(archive.execute('SELECT start, processor, evaluations FROM evaluators').fetchall(),
                         [(1, processor, simulated)], host)

    def test_simulators_can_be_added_by_a_launch_of_their_own(self):
        experiment = self.launch_experiment(simulators='none')
        wait_until(lambda: experiment.said('evolving in'), 'the experiment has begun')
        self.launch('simulators.launch', simulators=2)
        self.wait_for_success(experiment)
        self.assertEqual(self.digest(), self.undisturbed_digest())

    def test_every_argument_is_passed_on(self):
        arguments = dict(treatment='evo', profile='released_code', trials=1, generations=2, population=4,
                         seed=9223372036854775807, mutation_rate=0.125, lifetime=0.1, grid='2x3x2')
        launched = self.launch('experiment.launch', simulators=1, output=self.output, **arguments)
        self.wait_for_success(launched)
        self.assertEqual(self.digest(), self.undisturbed_digest(**arguments))

    def test_rigid_bodies_give_the_digest_of_evolve_with_two_simulators(self):
        config = os.path.join(self.folder, 'short.yaml')
        with open(config, 'w') as file:
            file.write('rigid_lifetime: 1\n')
        arguments = dict(body='rigid', trials=1, generations=4, population=4, seed=3, config=config)
        launched = self.launch('experiment.launch', simulators=2, output=self.output, **arguments)
        self.wait_for_success(launched)
        self.assertEqual(launched.output().count(') joined'), 2, launched.output())
        self.assertIn('came ', launched.output().split('Best robot: ')[1])
        self.assertEqual(self.digest(), self.digest_of_evolve(arguments))

    def test_parameters_of_the_other_body_stop_the_start(self):
        launched = self.launch('experiment.launch', simulators=1, output=self.output, body='rigid', grid='2x2x2')
        launched.wait()
        self.assertIn('grid is 2x2x2, but it is a parameter of soft bodies, and body is rigid', launched.output())
        self.assertFalse(os.path.exists(self.output))

    def test_a_farm_of_machines_gives_the_digest_of_evolve(self):
        """Two names of this machine, to which roslaunch needs no ssh."""
        launched = self.launch('farm.launch', machine_1='localhost', machine_2='127.0.0.1', simulators='none',
                               simulators_each=1, **dict(SMALL, generations=60, output=self.output))
        self.wait_for_success(launched)
        self.assertEqual(launched.output().count(') joined'), 2, launched.output())
        self.assertEqual(self.digest(), self.undisturbed_digest(generations=60))

    def test_a_job_of_slurm_brings_simulators(self):
        evolver = self.launch_experiment(simulators='none', generations=60)
        package = os.path.dirname(os.path.dirname(os.path.realpath(
            roslib.packages.find_resource('devo_evo', 'simulators.sbatch')[0])))
        setup = os.path.join(os.path.dirname(program('devo_evo')), '../../setup.bash')
        self.start('env', 'SLURM_JOB_ID=17', 'SLURM_CPUS_PER_TASK=2', 'DEVO_EVO=' + package, 'DEVO_EVO_SETUP=' + setup,
                   'DEVO_EVO_NS=' + self.namespace[1:], 'bash', os.path.join(package, 'launch/simulators.sbatch'),
                   namespace='/')
        self.wait_for_success(evolver)
        self.assertEqual(evolver.output().count(') joined'), 2, evolver.output())
        self.assertEqual(self.digest(), self.undisturbed_digest(generations=60))

    def test_wrong_arguments_stop_the_start_with_a_message(self):
        for argument, value, message in (
                ('population', '1', 'population is "1"; it must be a whole number within 2 to 10000'),
                ('treatment', 'devo', 'treatment is "devo"; it must be evo, evo_devo, evo_devo_body or'),
                ('simulators', 'many', 'simulators is "many"; it must be a whole number within 0 to'),
                ('output', 'results', 'output is "results"; it must be an absolute path')):
            launched = self.launch('experiment.launch', **dict({'output': self.output, 'simulators': 1},
                                                               **{argument: value}))
            launched.wait()
            self.assertTrue(launched.said(message), launched.output())

    def test_after_ctrl_c_it_goes_on_where_it_was(self):
        launched = self.launch_experiment(simulators=1, generations=30)
        wait_until(lambda: launched.said('body lengths; '), 'generations are reported')
        launched.signal(signal.SIGINT)
        launched.wait()
        self.assertTrue(launched.said('stopped\nResults:'), launched.output())
        self.assertNotEqual(self.digest(), self.undisturbed_digest(generations=30))
        again = self.launch_experiment(simulators=1, generations=30)
        self.wait_for_success(again)
        self.assertTrue(again.said(', resumed'))
        self.assertEqual(self.digest(), self.undisturbed_digest(generations=30))


if __name__ == '__main__':
    rospy.init_node('experiment_rostest', disable_signals=True)
    rostest.rosrun('devo_evo', 'experiment', LaunchTest, sys.argv)
