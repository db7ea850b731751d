#!/usr/bin/python3
"""Whatever dies, comes late or lies: the same digest."""

import signal
import sys
import threading

import rospy
import rostest
from devo_evo.msg import BodyEngine, RobotEvaluation, SimulatorAnnouncement
from devo_evo.srv import EvaluateGenomes, EvaluateGenomesResponse
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus

from devo_evo_testing import ExperimentTest, wait_until


class FakeSimulator:
    """Announces itself as a simulator, and answers what it likes."""

    def __init__(self, name, fingerprint, answer):
        self.name = name
        self.requests = []
        self.answer = answer
        self.service = rospy.Service(name + '/evaluate', EvaluateGenomes, self.evaluate)
        self.announcement = SimulatorAnnouncement(
            name=name, service=name + '/evaluate', host='elsewhere', pid=1, version='0.0.0', instruction_set='scalar',
            engines=[BodyEngine(body='soft', fingerprint=fingerprint)], lanes=4, period=0.1)
        self.publisher = rospy.Publisher(name.rsplit('/', 1)[0] + '/simulators', SimulatorAnnouncement, queue_size=1)
        self.stopped = threading.Event()
        self.thread = threading.Thread(target=self.announce)
        self.thread.start()

    def announce(self):
        while not self.stopped.wait(0.1):
            self.publisher.publish(self.announcement)

    def evaluate(self, request):
        self.requests.append(request)
        return EvaluateGenomesResponse(evaluations=self.answer(request), error='')

    def stop(self):
        self.stopped.set()
        self.thread.join()
        self.service.shutdown()
        self.publisher.unregister()


def soft_fingerprint(announcement):
    return {engine.body: engine.fingerprint for engine in announcement.engines}['soft']


def nonsense(request):
    """A robot that never was."""
    return [RobotEvaluation(trial=9, id=9, valid=True, fitness=1e9) for _ in request.genomes]


class FaultsTest(ExperimentTest):

    def fake_simulator(self, name, fingerprint, answer):
        fake = FakeSimulator(self.namespace + '/' + name, fingerprint, answer)
        self.addCleanup(fake.stop)
        return fake

    def first_announcement(self):
        heard = self.listen(self.namespace + '/simulators', SimulatorAnnouncement)
        return wait_until(lambda: heard, 'a simulator announces itself')[0]

    def test_a_simulator_is_killed_in_mid_batch_and_another_joins_late(self):
        evolver = self.start_evolver(lifetime=1.0, generations=2)
        victim = self.start_simulator(instruction_set='scalar')
        wait_until(lambda: evolver.said('body lengths; '), 'a generation is finished')
        victim.signal(signal.SIGKILL)
        wait_until(lambda: evolver.said(': the connection failed; its batch of 1 goes to others'), 'its loss is noticed')
        self.start_simulator()
        self.wait_for_success(evolver)
        self.assertEqual(self.digest(), self.undisturbed_digest(lifetime=1.0, generations=2))

    def test_a_simulator_that_stands_still_is_given_up_and_taken_in_again(self):
        evolver = self.start_evolver(lifetime=1.0, generations=2)
        sleeper = self.start_simulator(instruction_set='scalar')
        wait_until(lambda: evolver.said('body lengths; '), 'a generation is finished')
        sleeper.signal(signal.SIGSTOP)
        wait_until(lambda: evolver.said(': no sign of life for 5 s; its batch of 1 goes to others'), 'it is given up')
        sleeper.signal(signal.SIGCONT)
        wait_until(lambda: evolver.said(' is back'), 'it is taken in again')
        self.wait_for_success(evolver)
        self.assertEqual(self.digest(), self.undisturbed_digest(lifetime=1.0, generations=2))

    def test_a_simulator_that_takes_too_long_is_given_up(self):
        evolver = self.start_evolver(batch_timeout=1.0)
        honest = self.start_simulator()
        hang = threading.Event()
        self.addCleanup(hang.set)
        self.fake_simulator('slow', soft_fingerprint(self.first_announcement()),
                            lambda request: nonsense(request) if not request.genomes or hang.wait(60.0) else [])
        honest.signal(signal.SIGSTOP)
        wait_until(lambda: evolver.said('/slow (host elsewhere, process 1, scalar): no answer within 1 s'),
                   'it is given up')
        honest.signal(signal.SIGCONT)
        self.wait_for_success(evolver)
        self.assertEqual(self.digest(), self.undisturbed_digest())

    def test_another_engine_is_refused(self):
        diagnostics = self.listen('/diagnostics', DiagnosticArray)
        evolver = self.start_evolver()
        stranger = self.fake_simulator('stranger', 1, nonsense)
        wait_until(lambda: stranger.requests, 'the stranger is told')

        def refusal():
            return [status for array in diagnostics for status in array.status
                    if status.name.endswith('/stranger') and status.level == DiagnosticStatus.ERROR]
        message = wait_until(refusal, 'diagnostics tell of it')[0].message
        fingerprint = '%016x' % stranger.requests[0].engine_fingerprint
        self.assertIn('refused: its engine fingerprint for soft bodies is 0000000000000001, that of this evolver is ' + fingerprint, message)
        self.start_simulator()
        self.wait_for_success(evolver)
        self.assertEqual([len(request.genomes) for request in stranger.requests], [0])
        self.assertEqual(evolver.output().count('[ERROR] refused '), 1, evolver.output())
        self.assertEqual(self.digest(), self.undisturbed_digest())

    def test_nonsense_is_not_believed(self):
        evolver = self.start_evolver()
        honest = self.start_simulator()
        fingerprint = soft_fingerprint(self.first_announcement())
        honest.signal(signal.SIGSTOP)
        liar = self.fake_simulator('liar', fingerprint, nonsense)
        wait_until(lambda: evolver.said('/liar (host elsewhere, process 1, scalar): an evaluation of 9/9 where that of'),
                   'the lie is noticed')
        honest.signal(signal.SIGCONT)
        self.wait_for_success(evolver)
        self.assertTrue(any(request.genomes for request in liar.requests))
        self.assertEqual(self.digest(), self.undisturbed_digest())

    def test_a_wrong_evaluation_is_found_and_its_simulator_quarantined(self):
        evolver = self.start_evolver(checked_fraction=1.0, generations=20)
        honest = self.start_simulator()
        truth = self.first_announcement()

        def wrong(request):
            """As a simulator with a broken memory might answer: a bit differs, and everything looks right."""
            if not request.genomes:
                return []
            answer = rospy.ServiceProxy(truth.service, EvaluateGenomes)(request)
            for evaluation in answer.evaluations:
                evaluation.state_hash ^= 1
            return answer.evaluations
        diagnostics = self.listen('/diagnostics', DiagnosticArray)
        liar = self.fake_simulator('liar', soft_fingerprint(truth), wrong)
        wait_until(lambda: evolver.said('[ERROR] quarantined %s/liar (host elsewhere, process 1, scalar): its evaluation of '
                                        'robot ' % self.namespace), 'the lie is noticed')
        self.assertTrue(evolver.said('Look at the memory and the processor of host elsewhere'))
        told = wait_until(lambda: [request.quarantine for request in liar.requests if request.quarantine], 'it is told')
        self.assertRegex(told[0], 'its evaluation of robot .* has state hash .*, that of the evolver has state hash ')
        self.wait_for_success(evolver)
        self.assertTrue(honest.running())
        self.assertIn('/liar (host elsewhere, ', evolver.output().split('Simulators: ')[1], 'the summary at the end')
        self.assertEqual(self.digest(), self.undisturbed_digest(generations=20))
        levels = {status.level for array in diagnostics for status in array.status if status.name.endswith('/liar')}
        self.assertIn(DiagnosticStatus.ERROR, levels)

    def test_a_slow_simulators_work_is_done_by_others(self):
        evolver = self.start_evolver(generations=60)
        self.start_simulator()
        truth = self.first_announcement()
        hang = threading.Event()
        self.addCleanup(hang.set)
        self.fake_simulator('slow', soft_fingerprint(truth),
                            lambda request: nonsense(request) if not request.genomes or hang.wait(60.0) else [])
        wait_until(lambda: evolver.said('late: %s/slow (host elsewhere, process 1, scalar): no answer for ' % self.namespace),
                   'it is found late')
        self.wait_for_success(evolver)
        self.assertEqual(self.digest(), self.undisturbed_digest(generations=60))

    def test_a_killed_evolver_goes_on_where_it_was(self):
        self.start_simulator()
        first = self.start_evolver(generations=30)
        wait_until(lambda: first.said('body lengths; '), 'generations are reported')
        first.signal(signal.SIGKILL)
        first.wait()
        second = self.start_evolver(generations=30)
        self.wait_for_success(second)
        self.assertTrue(second.said(', resumed'))
        self.assertEqual(self.digest(), self.undisturbed_digest(generations=30))

    def test_a_second_evolver_on_the_same_output_is_refused(self):
        first = self.start_evolver()
        wait_until(lambda: first.said('evolving in'), 'the first has begun')
        self.namespace += '/second'
        second = self.start_evolver()
        self.assertNotEqual(second.wait(), 0)
        self.assertTrue(second.said('[FATAL]'), second.output())
        self.assertTrue(first.running())

    def test_without_simulators_the_evolver_waits_and_says_so(self):
        evolver = self.start_evolver()
        wait_until(lambda: evolver.said('waiting: no simulator has announced itself on %s/simulators' % self.namespace),
                   'it says so')
        self.assertTrue(evolver.running())
        evolver.signal(signal.SIGTERM)
        self.wait_for_success(evolver)

    def test_bad_parameters_stop_the_evolver(self):
        for name, value, message in (
                ('seeed', 1, 'there is no parameter "seeed"; the closest is seed'),
                ('lifetime', 'long', 'lifetime is "long"; it must be a number within 0.001 to 1000 s'),
                ('population', 100000, 'population is 100000; it must be a whole number within 2 to 10000')):
            evolver = self.start_evolver(**{name: value})
            self.assertEqual(evolver.wait(), 1)
            self.assertTrue(evolver.said(message), evolver.output())


if __name__ == '__main__':
    rospy.init_node('faults_rostest', disable_signals=True)
    rostest.rosrun('devo_evo', 'faults', FaultsTest, sys.argv)
