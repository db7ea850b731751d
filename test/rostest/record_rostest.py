#!/usr/bin/python3
"""Recordings hold everything that was published, and are closed properly however the experiment ends."""

import glob
import os
import signal
import sqlite3
import sys
import threading
import time

import rosbag
import rospy
import rostest
from devo_evo.msg import VelocityTelemetry

from devo_evo_testing import SMALL, VOXEL_ARRAYS, ExperimentTest, array_sizes, program, wait_until


class Rest:
    """Whether a process has hardly used the processor for the last second."""

    def __init__(self, pid):
        self.path = '/proc/%d/stat' % pid
        self.since, self.ticks = time.monotonic(), self.used()

    def used(self):
        """Its processor time so far, in ticks of 10 ms."""
        with open(self.path) as stat:
            fields = stat.read().rpartition(')')[2].split()
        return int(fields[11]) + int(fields[12])

    def __call__(self):
        if self.used() > self.ticks + 5:
            self.since, self.ticks = time.monotonic(), self.used()
        return time.monotonic() > self.since + 1.0


class RecordTest(ExperimentTest):

    def record_experiment(self, **arguments):
        return self.launch('experiment.launch', **dict(SMALL, output=self.output, simulators=2, record='true',
                                                       **arguments))

    def read(self, bag):
        """Messages of a bag by the last part of their topic."""
        messages = {}
        with rosbag.Bag(bag) as content:
            for topic, message, _ in content.read_messages():
                messages.setdefault(topic.replace(self.namespace + '/', ''), []).append(message)
        return messages

    def query(self, text):
        with sqlite3.connect('file:%s/experiment.db?mode=ro' % self.output, uri=True) as archive:
            return archive.execute(text).fetchall()

    def assert_holds_all_generations(self, messages):
        recorded = sorted((report.trial, report.generation, report.best_fitness, report.champion)
                          for report in messages['generation'])
        archived = sorted(self.query('SELECT trial, generation, best_fitness, champion FROM generations'))
        self.assertEqual(recorded, archived)
        champions = {(robot.trial, robot.generation): robot for robot in messages['champion']}
        self.assertEqual(sorted(champions), [(trial, generation) for trial, generation, _, _ in archived])
        for trial, generation, fitness, champion in archived:
            robot = champions[trial, generation]
            self.assertEqual((robot.id, robot.evaluation.fitness), (champion, fitness))
            self.assertEqual(array_sizes(robot.genome), VOXEL_ARRAYS)

    def test_a_recording_holds_what_the_archive_holds(self):
        launched = self.record_experiment()
        self.wait_for_success(launched)
        bag = self.output + '/run-1.bag'
        self.assertEqual(glob.glob(self.output + '/*.bag*'), [bag], launched.output())
        messages = self.read(bag)
        self.assert_holds_all_generations(messages)
        velocities = {(telemetry.trial, telemetry.id) for telemetry in messages['velocity']}
        evaluated = sum(report.evaluations for report in messages['generation'])
        self.assertGreaterEqual(len(messages['velocity']), evaluated)  # some are evaluated twice
        self.assertEqual(len(velocities), evaluated)
        settings = dict(zip(messages['settings'][0].names, messages['settings'][0].values))
        self.assertEqual((settings['body'], float(settings['lifetime'])), ('soft', SMALL['lifetime']))
        fitnesses = [robot.evaluation.fitness for robot in messages['best']]
        self.assertEqual(fitnesses, sorted(set(fitnesses)))
        self.assertEqual(fitnesses[-1], self.query('SELECT max(best_fitness) FROM generations')[0][0])
        self.assertTrue(messages['/diagnostics'])

    def test_the_robot_shown_is_recorded(self):
        launched = self.record_experiment(generations=1000000)
        time.sleep(0.1)
        wait_until(lambda: launched.said('showing 1/') or launched.said('showing 2/'), 'a robot is shown')
        time.sleep(1.0)
        launched.signal(signal.SIGINT)
        launched.wait()
        messages = self.read(self.output + '/run-1.bag')
        self.assertTrue(messages['player/floor'])
        stamps = {state.header.stamp for state in messages['player/state']}
        pictures = [array for array in messages['player/robot'] if array.markers[0].ns == 'body']
        self.assertTrue(pictures)
        self.assertTrue(all(array.markers[0].header.stamp in stamps for array in pictures))
        frames = {transform.child_frame_id for message in messages['/tf'] for transform in message.transforms}
        self.assertTrue({'player/robot', 'player/follow'} <= frames, frames)

    def test_ctrl_c_closes_the_bag_and_the_next_run_begins_another(self):
        for number in (1, 2):
            launched = self.record_experiment(generations=1000000)
            wait_until(lambda: launched.said('body lengths; '), 'generations are reported')
            time.sleep(0.5)
            launched.signal(signal.SIGINT)
            launched.wait()
            bag = '%s/run-%d.bag' % (self.output, number)
            self.assertTrue(launched.said('messages to ' + bag), launched.output())
            if number == 1:
                self.assert_holds_all_generations(self.read(bag))
        self.assertEqual(len(glob.glob(self.output + '/*.bag*')), 2)

    def start_recorder(self):
        rospy.set_param(self.namespace + '/recorder', {'output': self.output})
        return self.start(program('recorder'))

    def test_no_message_is_dropped_under_load(self):
        """20,000 messages as fast as they can be sent, while the recorder stands still for a while."""
        recorder = self.start_recorder()
        # Without a queue of rospy's, since what is left in it when the publisher goes is never sent.
        publisher = rospy.Publisher(self.namespace + '/velocity', VelocityTelemetry, queue_size=None)
        wait_until(lambda: publisher.get_num_connections() == 1, 'the recorder listens')
        count = 20000
        telemetry = VelocityTelemetry(window_end=[0.5 * i for i in range(20)], velocity=[0.1] * 20)
        for number in range(count):
            if number == 1000:
                recorder.signal(signal.SIGSTOP)
                awakening = threading.Timer(2.0, recorder.signal, [signal.SIGCONT])  # publish() may have to wait for it
                awakening.start()
            telemetry.id = number
            publisher.publish(telemetry)
        awakening.join()
        # When a publisher leaves the master, roscpp does not read what it had sent.
        wait_until(Rest(recorder.process.pid), 'the recorder has read everything')
        publisher.unregister()
        recorder.signal(signal.SIGINT)
        self.assertEqual(recorder.wait(), 0, recorder.output())
        messages = self.read(self.output + '/run-1.bag')
        self.assertEqual([message.id for message in messages['velocity']], list(range(count)))

    def test_a_full_disk_ends_the_recording_with_a_message(self):
        rospy.set_param(self.namespace + '/recorder', {'output': self.output})
        recorder = self.start('/bin/bash', '-c', 'ulimit -f 200; trap "" XFSZ; exec ' + program('recorder'))
        publisher = rospy.Publisher(self.namespace + '/velocity', VelocityTelemetry, queue_size=0)
        wait_until(lambda: publisher.get_num_connections() == 1, 'the recorder listens')
        while recorder.running():
            publisher.publish(VelocityTelemetry(simulator=os.urandom(30000).hex()))
            time.sleep(0.001)
        self.assertEqual(recorder.wait(), 1, recorder.output())
        self.assertTrue(recorder.said('cannot go on recording to ' + self.output + '/run-1.bag.active'), recorder.output())

    def test_a_recorder_that_is_waited_for_and_does_not_come_is_an_error(self):
        evolver = self.start_evolver(record=True)
        self.assertEqual(evolver.wait(), 1, evolver.output())
        self.assertTrue(evolver.said('nobody has subscribed to %s/generation' % self.namespace), evolver.output())


if __name__ == '__main__':
    rospy.init_node('record_rostest', disable_signals=True)
    rostest.rosrun('devo_evo', 'record', RecordTest, sys.argv)
