#!/usr/bin/python3
"""A whole study by its launch file: every experiment, and the same results as without ROS."""

import os
import signal
import sqlite3
import subprocess
import sys

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus

from devo_evo_testing import ExperimentTest, program, wait_until

# Every part, with little robots and short lives.
TINY = {'grid': '2x2x2', 'lifetime': 0.1, 'population': 4, 'trials': 2, 'generations': 3, 'baseline_trials': 1,
        'baseline_generations': 1, 'sweep_trials': 1, 'sweep_generations': 1, 'sweep_48ths': '48',
        'rigid_trials': 1, 'rigid_generations': 1, 'walks': 1,
        'walk_steps': 4, 'neutral_lineages': 2, 'impact_reproductions': 20, 'friction_factors': 0.5,
        'gravity_factors': 2, 'amplitude_factors': 0.5, 'slopes': 0.1}

ARMS = ('main/evo', 'main/evo_devo', 'baselines/evo-neutral', 'baselines/evo-random_search',
        'baselines/evo_devo-neutral', 'baselines/evo_devo-random_search', 'sweep/evo-48_48', 'sweep/evo_devo-48_48',
        'rigid/evo', 'rigid/evo_devo')
TABLES = ('champions', 'worlds', 'variants', 'walk_steps', 'ancestors', 'neutral_lineages', 'traces', 'robustness',
          'mutational_impact', '(SELECT world, phenotype_hash, valid, fitness, state_hash, velocities FROM evaluations)')


def content(study):
    """All that was simulated and decided, but not when and where."""
    archive = sqlite3.connect('file:%s/study.db?mode=ro' % study, uri=True)
    rows = {table: sorted(archive.execute('SELECT * FROM ' + table), key=repr) for table in TABLES}
    archive.close()
    digests = [subprocess.check_output([program('devo_evo'), 'digest', os.path.join(study, arm)]) for arm in ARMS]
    return rows, digests


class StudyTest(ExperimentTest):

    def launch_study(self, **arguments):
        return self.launch('study.launch', **{**TINY, 'output': self.output, 'simulators': 2, **arguments})

    def study_without_ros(self):
        output = os.path.join(self.folder, 'without_ros')
        options = [part for name, value in TINY.items() for part in ('--' + name, str(value))]
        subprocess.run([program('devo_evo'), 'study', '--output', output] + options, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return output

    def test_every_experiment_gives_what_it_gives_without_ros(self):
        interrupted = self.launch_study()
        wait_until(lambda: interrupted.said('removed: done'), 'a part is done')
        interrupted.signal(signal.SIGINT)
        interrupted.wait()
        self.assertTrue(interrupted.said('stopped\nStudy: ' + self.output), interrupted.output())
        diagnostics = self.listen('/diagnostics', DiagnosticArray)
        again = self.launch_study(scale='quick')
        self.wait_for_success(again)
        self.assertTrue(again.said('finished\nStudy: ' + self.output), again.output())
        self.assertTrue(again.said('evaluations/s, measured on this machine with 2 workers'))
        told = [status for array in diagnostics for status in array.status if status.name.endswith('/study: study')]
        self.assertIn({'key': 'output', 'value': self.output},
                      [{'key': entry.key, 'value': entry.value} for status in told for entry in status.values])
        self.assertTrue(all(status.message.startswith(('beginning', 'running ', 'waiting ')) for status in told))
        self.assertEqual(content(self.output), content(self.study_without_ros()))

    def test_wrong_arguments_stop_the_start_with_a_message(self):
        for argument, value, message in (
                ('scale', 'huge', 'scale is "huge"; it must be quick, overnight or paper'),
                ('walks', '0', 'walks is "0"; it must be a whole number within 1 to'),
                ('only', 'robustness', 'run the part main first')):
            launched = self.launch('study.launch', **{'output': self.output, 'simulators': 1, argument: value})
            launched.wait()
            self.assertTrue(launched.said(message), launched.output())

    def test_waits_for_simulators_and_says_so(self):
        diagnostics = self.listen('/diagnostics', DiagnosticArray)
        waiting = self.launch_study(simulators='none')
        wait_until(lambda: waiting.said('waiting: no simulator has announced itself'), 'it complains')
        wait_until(lambda: any(status.message == 'waiting for a simulator' and status.level == DiagnosticStatus.WARN
                               for array in diagnostics for status in array.status), 'diagnostics warn')
        waiting.signal(signal.SIGINT)
        waiting.wait()
        self.assertTrue(waiting.said('stopped\nStudy:'), waiting.output())


if __name__ == '__main__':
    rospy.init_node('study_rostest', disable_signals=True)
    rostest.rosrun('devo_evo', 'study', StudyTest, sys.argv)
