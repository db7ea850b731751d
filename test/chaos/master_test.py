#!/usr/bin/python3
"""A master that was started separately is killed during a run, and comes back knowing nobody."""

import unittest

import laboratory
from laboratory import Laboratory, wait_until

PARAMETERS = {'lifetime': 0.5, 'population': 8, 'generations': 2000, 'trials': 2, 'seed': 6}


class MasterTest(unittest.TestCase):

    def test_what_runs_goes_on_and_what_is_new_joins_when_it_is_back(self):
        with Laboratory() as lab:
            evolver = lab.start_evolver(output=lab.path('output'), **PARAMETERS)
            first = lab.home.start_simulator(instruction_set='scalar')
            wait_until(lambda: evolver.said('body lengths; '), 'a generation is finished')

            lab.master.kill()
            for node in (evolver, first):
                wait_until(lambda: node.said('the ROS master at %s does not answer' % lab.master_uri), 'it is noticed')
                self.assertTrue(node.said('start it again: roscore -p %d' % lab.master_port))
            late = lab.home.start_simulator(instruction_set='scalar')
            lines = evolver.output().count('body lengths; ')
            wait_until(lambda: evolver.output().count('body lengths; ') > lines + 1, 'evolution goes on without it')
            self.assertFalse(evolver.said('lost '), evolver.output())
            wait_until(lambda: late.said('Failed to contact master'), 'the new simulator says what it lacks')

            lab.start_master()
            for node in (evolver, first):
                wait_until(lambda: node.said('for long; registered with it again'), 'it registers again')
            wait_until(lambda: evolver.output().count(') joined') == 2, 'the new simulator has joined')
            self.assertFalse(evolver.said('lost '), evolver.output())
            self.expect_known(lab)
            third = lab.home.start_simulator(instruction_set='scalar')
            wait_until(lambda: evolver.output().count(') joined') == 3, 'simulators that start now join as ever')
            self.assertTrue(first.running() and late.running() and third.running())

    def expect_known(self, lab):
        """The new master knows the evolver as the old one did."""
        publishers, subscribers, services = lab.ask_master('getSystemState')
        name = '/laboratory/evolver'
        topics = {topic for topic, nodes in publishers if name in nodes}
        self.assertLessEqual({'/laboratory/' + topic for topic in ('generation', 'champion', 'best')} | {'/diagnostics'},
                             topics)
        self.assertIn(name, dict(subscribers)['/laboratory/simulators'])
        offered = {service for service, nodes in services if name in nodes}
        self.assertLessEqual({'/laboratory/' + service for service in ('pause', 'resume', 'stop', 'individual', 'lineage')},
                             offered)


if __name__ == '__main__':
    unittest.main()
