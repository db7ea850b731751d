#!/usr/bin/python3
"""Watching robots: the launch files, rviz on a virtual display, and what stands in the way."""

import math
import os
import subprocess
import sys

import numpy
import rospkg
import rospy
import rostest
from devo_evo.msg import PlayerState
from visualization_msgs.msg import MarkerArray

from devo_evo_testing import ExperimentTest, VirtualDisplay, rviz_complaints, wait_until

PACKAGE = rospkg.RosPack().get_path('devo_evo')
ROBOT = VirtualDisplay.ROBOT


class WatchTest(ExperimentTest):

    def watch(self, **arguments):
        return self.launch('watch.launch', **dict({'rviz': 'false'}, **arguments))

    def test_one_individual_is_shown_without_evolution(self):
        self.evolve()
        states = self.listen('player/state', PlayerState)
        watch = self.watch(output=self.output, individual='1/3', colour='phase', speed=0.5)
        wait_until(lambda: states, 'the robot is shown')
        self.assertEqual((states[0].individual, states[0].record), ('1/3', PlayerState.AGREES))
        self.assertEqual((states[0].colour, states[0].speed), ('phase', 0.5))
        self.assertTrue(watch.said('showing 1/3, evo_devo'), watch.output())
        self.assertTrue(watch.said(', as recorded'), watch.output())

    def test_two_individuals_are_shown_side_by_side(self):
        self.evolve()
        first = self.listen('player/robot', MarkerArray)
        second = self.listen('player_2/robot', MarkerArray)
        self.watch(output=self.output, individual='1/0', beside='1/1', loop_pause=0)

        def voxels(messages):
            return [marker for array in messages for marker in array.markers if marker.ns == 'parts']
        wait_until(lambda: voxels(first) and voxels(second), 'both are shown')
        for marker, low, high in ((voxels(first)[0], -0.04, 0.08), (voxels(second)[0], -0.28, -0.16)):
            self.assertEqual(len(marker.points), 48)
            self.assertTrue(all(low < point.x < high for point in marker.points))

    def test_a_robot_of_a_file_is_shown(self):
        states = self.listen('player/state', PlayerState)
        self.watch(genome_file=PACKAGE + '/test/data/genomes.jsonl', individual='golden-001')
        wait_until(lambda: states, 'the robot is shown')
        self.assertEqual((states[0].individual, states[0].record), ('golden-001', PlayerState.NOT_RECORDED))

    def test_a_quadruped_is_shown_on_its_slope_with_its_light(self):
        robots = self.listen('player/robot', MarkerArray)
        floors = self.listen('player/floor', MarkerArray)
        self.watch(genome_file=PACKAGE + '/config/quadrupeds.jsonl', individual='walker',
                   config=PACKAGE + '/config/rigid.yaml')
        wait_until(lambda: robots and any(array.markers[0].points for array in robots)
                   and any(marker.ns == 'light' for array in floors for marker in array.markers), 'robot and floor are shown')
        shown = next(array for array in robots if array.markers[0].points)
        bodies = {marker.id: marker for marker in shown.markers if marker.ns == 'body'}
        self.assertEqual(sorted(bodies), [0, 1, 2, 3, 4])
        (parts,) = [marker for marker in shown.markers if marker.ns == 'parts']
        centers = [numpy.array([point.x, point.y, point.z]) for point in parts.points]
        reach = [max(numpy.linalg.norm(numpy.array([point.x, point.y, point.z]) - centers[part])
                     for point in bodies[part].points) for part in range(5)]
        self.assertAlmostEqual(reach[0], 0.25, delta=1e-4)  # abdomen: the radius of the sphere
        for leg in range(1, 5):  # half of a rod's length, 0.04 m + 0.3 m
            self.assertAlmostEqual(reach[leg], 0.17, delta=1e-4)
            right, front = (1 if leg % 2 == 0 else -1), (1 if leg <= 2 else -1)
            self.assertGreater(right * (centers[leg][0] - centers[0][0]), 0.05)
            self.assertGreater(front * (centers[leg][1] - centers[0][1]), 0.0)

        def front_left_leg():
            return [marker.points[1] for array in robots for marker in array.markers if marker.ns == 'parts']
        start = front_left_leg()[0]
        wait_until(lambda: math.dist((start.x, start.y, start.z), (front_left_leg()[-1].x, front_left_leg()[-1].y,
                                                                   front_left_leg()[-1].z)) > 0.05, 'it walks')

        slope = math.radians(3.0)
        scene = {marker.ns: marker for array in floors for marker in array.markers}
        for point in scene['floor'].points:
            self.assertAlmostEqual(point.y * math.sin(slope) + point.z * math.cos(slope), 0.0, delta=1e-4)
        light = scene['light'].pose.position
        self.assertAlmostEqual(light.y, 30.0 * math.cos(slope) + math.sin(slope), delta=1e-3)
        self.assertAlmostEqual(light.z, -30.0 * math.sin(slope) + math.cos(slope), delta=1e-3)
        self.assertGreater(scene['light'].scale.x, 0.1)

    def test_what_cannot_be_shown_ends_with_a_message(self):
        self.evolve()
        for arguments, message in (
                ({'output': self.output, 'individual': '1/4711'}, '4711'),
                ({'output': self.output, 'individual': '1-5'}, 'individual is "1-5"; it must be best'),
                ({'output': self.folder}, self.folder + '/experiment.db'),
                ({'output': 'results'}, 'output is "results"; it must be an absolute path'),
                ({'genome_file': self.folder + '/none.jsonl'}, 'none.jsonl: it cannot be read'),
                ({'output': self.output, 'colour': 'pink'}, 'colour is "pink"; it must be resting_length')):
            watch = self.watch(**arguments)
            watch.wait()
            self.assertTrue(watch.said('[FATAL]') and watch.said(message), watch.output())

    def test_without_rviz_or_display_it_is_said_what_is_missing(self):
        show = os.path.join(PACKAGE, 'scripts/show_rviz')
        for environment, message in (
                ({'PATH': '/nonexistent', 'DISPLAY': ':1'}, 'rviz is not installed'),
                ({'PATH': '/usr/bin:/bin'}, 'rviz needs a display')):
            result = subprocess.run(['/bin/bash', show, 'some.rviz'], env=environment, capture_output=True, text=True,
                                    check=False)
            self.assertEqual(result.returncode, 1)
            self.assertIn(message, result.stderr)

    def test_rviz_shows_robots_and_follows_them(self):
        self.evolve(lifetime=3)
        with VirtualDisplay() as display:
            watch = self.launch('watch.launch', output=self.output, individual='1/0', beside='1/1')
            display.wait_for_robot()
            first = display.pixels(ROBOT)
            wait_until(lambda: display.pixels(ROBOT) != first, 'it moves')
            said = watch.output()  # before the display ends, and rviz with a complaint
        self.assertEqual(rviz_complaints(said), [])

    def test_the_panel_in_rviz_leads_the_player(self):
        self.evolve(lifetime=1, generations=20)
        states = self.listen('player/state', PlayerState)
        with VirtualDisplay() as display:
            watch = self.launch('watch.launch', output=self.output)
            display.wait_for_robot()
            wait_until(lambda: len(display.colours('410x170+860+150')) > 20, 'the plot is drawn')
            champion = states[-1].individual
            display.click(912, 230)  # at the left end of the plot
            wait_until(lambda: states[-1].individual != champion, 'an ancestor is shown')
            founder = states[-1]
            self.assertEqual(founder.record, PlayerState.AGREES)
            self.assertEqual(founder.age, 0)
            pause_button = iter(range(690, 770, 10))  # below the slider; how far depends on the lines above it

            def paused():
                if not states[-1].paused:
                    display.click(908, next(pause_button))
                    rospy.sleep(0.5)
                return states[-1].paused
            wait_until(paused, 'it is paused')
            self.assertEqual(states[-1].individual, founder.individual)
            said = watch.output()
        self.assertEqual(rviz_complaints(said), [])

    def test_an_experiment_can_be_watched_and_plotted_while_it_runs(self):
        states = self.listen('player/state', PlayerState)
        self.launch('experiment.launch', lifetime=0.2, population=6, generations=1000000, seed=3, output=self.output,
                    simulators=1, record='true')  # which shows the best robot, too
        wait_until(lambda: len({state.individual for state in states}) > 1, 'a better robot is shown')
        self.assertTrue(all(state.record == PlayerState.AGREES for state in states))
        fitnesses = [state.fitness for state in states]
        self.assertEqual(fitnesses, sorted(fitnesses))
        for topic, fields in (('generation', ('best_fitness', 'median_fitness', 'champion_morphology_window',
                                              'champion_control_window')),
                              ('player/state', ('velocity', 'displacement', 'height')),
                              ('velocity', ('mean_velocity',))):
            for field in fields:
                name = '%s/%s/%s' % (self.namespace, topic, field)
                plot = subprocess.run(['rostopic', 'echo', '-p', '-n1', name], capture_output=True, text=True,
                                      timeout=60, check=True).stdout.splitlines()
                self.assertEqual(len(plot), 2, plot)
                float(plot[1].split(',')[1])


if __name__ == '__main__':
    rospy.init_node('watch_rostest', disable_signals=True)
    rostest.rosrun('devo_evo', 'watch', WatchTest, sys.argv)
