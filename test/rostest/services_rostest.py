#!/usr/bin/python3
"""What an evolver publishes, and what can be asked of it."""

import math
import sys
import time

import rospy
import rostest
from devo_evo.msg import EvolvedRobot, GenerationSummary, VelocityTelemetry
from devo_evo.srv import GetIndividual, GetIndividualRequest, GetLineage
from diagnostic_msgs.msg import DiagnosticArray
from std_srvs.srv import Trigger

from devo_evo_testing import SMALL, VOXEL_ARRAYS, ExperimentTest, array_sizes, wait_until

ENDLESS = 1000000
CHAMPION = GetIndividualRequest.CHAMPION


class ServicesTest(ExperimentTest):

    def call(self, service, kind, *arguments):
        name = self.namespace + '/' + service
        rospy.wait_for_service(name, 30.0)
        return rospy.ServiceProxy(name, kind)(*arguments)

    def start_endless(self):
        """An experiment that runs until it is stopped, with what it reports."""
        generations = self.listen(self.namespace + '/generation', GenerationSummary)
        evolver = self.start_evolver(generations=ENDLESS)
        self.start_simulator()
        wait_until(lambda: len(generations) >= 6, 'generations are reported')
        return evolver, generations

    def test_every_generation_is_reported(self):
        generations = self.listen(self.namespace + '/generation', GenerationSummary)
        velocities = self.listen(self.namespace + '/velocity', VelocityTelemetry)
        evolver = self.start_evolver()
        wait_until(lambda: evolver.said('evolving in'), 'it has begun')
        time.sleep(0.5)  # until subscriptions stand
        self.start_simulator()
        self.wait_for_success(evolver)
        for trial in (1, 2):
            reports = [report for report in generations if report.trial == trial]
            self.assertEqual([report.generation for report in reports], list(range(SMALL['generations'] + 1)))
            bests = [report.best_fitness for report in reports]
            self.assertEqual(bests, sorted(bests))
            self.assertEqual(reports[0].newcomers, SMALL['population'])
            self.assertEqual(reports[1].newcomers, SMALL['population'] + 1)
        self.assertEqual({report.trials for report in generations}, {SMALL['trials']})
        self.assertEqual({report.generations for report in generations}, {SMALL['generations']})
        self.assertEqual(len(velocities), sum(report.evaluations for report in generations))
        self.assertEqual(len({(velocity.trial, velocity.id) for velocity in velocities}), len(velocities))

    def test_a_latecomer_is_told_the_champion_and_the_best(self):
        self.start_endless()
        champion = rospy.wait_for_message(self.namespace + '/champion', EvolvedRobot, 30.0)
        best = rospy.wait_for_message(self.namespace + '/best', EvolvedRobot, 30.0)
        self.assertEqual(champion.treatment, 'evo_devo')
        self.assertEqual(champion.genome.body, 'soft')
        self.assertEqual(array_sizes(champion.genome), VOXEL_ARRAYS)
        self.assertEqual(len(champion.genome.mutation_rate), 48)
        self.assertTrue(best.evaluation.valid)
        self.assertTrue(best.morphology_window > 0.0 and best.control_window > 0.0)

    def test_the_champion_is_told_anew_after_a_resume(self):
        self.start_simulator()
        self.wait_for_success(self.start_evolver())
        self.processes[0].stop()
        bests = self.listen(self.namespace + '/best', EvolvedRobot)
        evolver = self.start_evolver(generations=10)
        wait_until(lambda: bests, 'the best robot so far is published')
        self.assertTrue(evolver.running())
        self.assertTrue(bests[0].evaluation.valid)

    def test_pause_lets_generations_finish_and_resume_goes_on(self):
        _, generations = self.start_endless()
        diagnostics = self.listen('/diagnostics', DiagnosticArray)
        self.assertTrue(self.call('pause', Trigger).success)

        def at_rest():
            return any([status.message for status in array.status] == ['paused', 'idle'] for array in diagnostics
                       if array.status[0].name.startswith(self.namespace + '/'))
        wait_until(at_rest, 'generations that ran are finished')
        time.sleep(0.2)  # until the last report has come
        paused_at = len(generations)
        time.sleep(1.0)
        self.assertEqual(len(generations), paused_at)
        self.assertTrue(self.call('resume', Trigger).success)
        wait_until(lambda: len(generations) > paused_at, 'it goes on')

    def test_stop_finishes_generations_and_ends(self):
        evolver, _ = self.start_endless()
        self.assertTrue(self.call('stop', Trigger).success)
        self.wait_for_success(evolver)
        self.assertTrue(evolver.said('stopped\nResults:'), evolver.output())
        self.assertEqual(len(self.digest()), 64)

    def test_individuals_and_lineages_can_be_read_while_it_runs(self):
        self.start_endless()
        champion = self.call('individual', GetIndividual, 2, CHAMPION)
        self.assertTrue(champion.success, champion.message)
        self.assertEqual(champion.individual.trial, 2)
        again = self.call('individual', GetIndividual, 2, champion.individual.id)
        self.assertEqual(str(again.individual), str(champion.individual))  # equal also where there is no number
        self.assertEqual(array_sizes(again.individual.genome), VOXEL_ARRAYS)
        self.assertFalse(math.isnan(again.individual.evaluation.fitness))

        lineage = self.call('lineage', GetLineage, 2, champion.individual.id)
        self.assertTrue(lineage.success, lineage.message)
        self.assertEqual(lineage.individuals[0].parent, EvolvedRobot.NO_PARENT)
        self.assertEqual(str(lineage.individuals[-1]), str(champion.individual))
        for parent, child in zip(lineage.individuals, lineage.individuals[1:]):
            self.assertEqual(child.parent, parent.id)

    def test_individuals_that_are_not_there_are_said_not_to_be(self):
        self.start_endless()
        for trial, individual in ((1, 99999999), (99, 1), (0, CHAMPION), (-5, -7), (1, -2)):
            for service, kind in (('individual', GetIndividual), ('lineage', GetLineage)):
                answer = self.call(service, kind, trial, individual)
                self.assertFalse(answer.success)
                self.assertNotEqual(answer.message, '')


if __name__ == '__main__':
    rospy.init_node('services_rostest', disable_signals=True)
    rostest.rosrun('devo_evo', 'services', ServicesTest, sys.argv)
