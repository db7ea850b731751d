#!/usr/bin/python3
"""Three hosts: one is cut off in mid-call, the packets of one are dropped, one joins late. The same digest."""

import re
import sys
import time
import unittest

import laboratory
from laboratory import Laboratory, wait_until

PARAMETERS = {'lifetime': 1.0, 'population': 8, 'generations': 12, 'trials': 2, 'seed': 5}
LOST = r'lost /laboratory/simulator_%s\S* \(host %s, .*goes to others'


class HostsTest(unittest.TestCase):

    def test_hosts_that_are_cut_off_are_given_up_and_taken_in_again(self):
        with Laboratory() as lab:
            cut, dropping, late = lab.add_host('cut'), lab.add_host('dropping'), lab.add_host('late')
            evolver = lab.start_evolver(output=lab.path('output'), **PARAMETERS)
            simulators = [host.start_simulator(instruction_set='scalar') for host in (cut, dropping)]
            wait_until(lambda: evolver.output().count(') joined') == 2, 'both simulators have joined')
            wait_until(lambda: evolver.said('body lengths; '), 'a generation is finished')

            cut.link_down()
            dropping.drop_packets()
            begin = time.monotonic()
            for host in (cut, dropping):
                wait_until(lambda: re.search(LOST % (host.name, host.name), evolver.output()),
                           'host %s is given up' % host.name, timeout=15.0)
            self.assertLess(time.monotonic() - begin, 8.0, 'silence for 5 s, and the time to notice')
            self.assertTrue(evolver.running())

            late.start_simulator(instruction_set='scalar')
            wait_until(lambda: evolver.said('(host late, '), 'another host joins')
            cut.link_up()
            dropping.pass_packets()
            for host in (cut, dropping):
                wait_until(lambda: re.search(r'\(host %s, .* is back' % host.name, evolver.output())
                           or not evolver.running(), 'host %s is taken in again' % host.name)
            self.assertEqual(evolver.wait(), 0)
            self.assertTrue(all(simulator.running() for simulator in simulators))
            for host in (cut, dropping, late):
                self.assertRegex(evolver.output(), r'host %s: \d+ at work, \d+ evaluations' % host.name)
            self.assertEqual(laboratory.digest(lab.path('output')), laboratory.undisturbed_digest(lab, PARAMETERS))


if __name__ == '__main__':
    obstacle = laboratory.enter_namespace()
    if obstacle:
        print('skipped: ' + obstacle)
        sys.exit(laboratory.SKIPPED)
    unittest.main()
