#!/usr/bin/python3
"""From an archive to a bag of a lineage, to markers, rviz and pictures: the launch files, without a display but for rviz."""

import glob
import os
import sqlite3
import subprocess
import sys

import rosbag
import rospy
import rostest
from sensor_msgs.msg import Image
from std_msgs.msg import String
from visualization_msgs.msg import MarkerArray

from devo_evo_testing import ExperimentTest, VirtualDisplay, program, rviz_complaints, wait_until

SMALL_PICTURES = {'width': 320, 'height': 180, 'rate': 10}


class LineageTest(ExperimentTest):

    def setUp(self):
        super().setUp()
        for name in ('DISPLAY', 'WAYLAND_DISPLAY', 'XAUTHORITY'):
            os.environ.pop(name, None)
        self.bag = self.output + '/lineage.bag'

    def tearDown(self):
        super().tearDown()
        if rospy.has_param('/use_sim_time'):  # replay.launch sets it for all
            rospy.delete_param('/use_sim_time')

    def record_lineage(self, **arguments):
        """Runs lineage.launch to its end. Returns what it said."""
        launched = self.launch('lineage.launch', **dict({'output': self.output, 'pause': 0.1}, **arguments))
        launched.wait()
        return launched.output()

    def query(self, text):
        with sqlite3.connect('file:%s/experiment.db?mode=ro' % self.output, uri=True) as archive:
            return archive.execute(text).fetchall()

    def assert_refused(self, said, message):
        self.assertIn('[FATAL]', said)
        self.assertIn(message, said)

    def test_a_lineage_is_recorded_and_replayed_without_a_display(self):
        self.evolve(generations=8)
        said = self.record_lineage()
        self.assertIn('the lineage is in ' + self.bag, said)
        with rosbag.Bag(self.bag) as bag:
            lives = [message for _, message, _ in bag.read_messages(['/lineage/individual'])]
        fitnesses = dict(self.query('SELECT id, fitness FROM individuals WHERE trial = 1'))
        self.assertEqual(lives[0].parent, -1)
        self.assertEqual([life.evaluation.fitness for life in lives], [fitnesses[life.id] for life in lives])

        robots = self.listen('/lineage/robot', MarkerArray)
        floors = self.listen('/lineage/floor', MarkerArray)
        replay = self.launch('replay.launch', bag=self.bag, rviz='false')
        wait_until(lambda: robots and floors, 'the bag is played')
        body = next(marker for marker in robots[0].markers if marker.ns == 'body')
        self.assertEqual(len(body.points), 80 * 6)  # outer faces of 4 x 4 x 3 voxels, two triangles each
        replay.wait()

    def test_rviz_shows_a_lineage(self):
        self.evolve(lifetime=5, generations=0)
        self.record_lineage()
        with VirtualDisplay() as display:
            replay = self.launch('replay.launch', bag=self.bag, loop='true')
            display.wait_for_robot('400x300+590+250')
            said = replay.output()
        self.assertEqual(rviz_complaints(said), [])

    def test_a_bag_without_our_topics_is_played_and_shows_nothing(self):
        os.makedirs(self.output)
        with rosbag.Bag(self.bag, 'w') as bag:
            bag.write('/chatter', String('hello'), rospy.Time(1))
        heard = self.listen('/chatter', String)
        replay = self.launch('replay.launch', bag=self.bag, rviz='false')
        wait_until(lambda: heard, 'the bag is played')
        replay.wait()
        refused = subprocess.run([program('devo_evo'), 'render', self.bag, '--out', self.folder + '/x.mp4'],
                                 capture_output=True, text=True, check=False)
        self.assertEqual(refused.returncode, 2)
        self.assertIn('shows no robot', refused.stderr)

    def test_a_lineage_can_be_recorded_while_the_experiment_runs(self):
        self.launch('experiment.launch', lifetime=0.2, population=6, generations=1000000, seed=3, output=self.output,
                    simulators=1)
        wait_until(lambda: os.path.exists(self.output + '/experiment.db') and
                   self.query('SELECT 1 FROM sqlite_master WHERE name = "generations"') and
                   self.query('SELECT COUNT(*) FROM generations')[0][0] > 5, 'there are generations')
        said = self.record_lineage(count=2)
        self.assertIn('the lineage is in ' + self.bag, said)

    def test_what_cannot_be_recorded_is_said(self):
        self.evolve()
        self.assert_refused(self.record_lineage(trial='7'), 'no finished generation of trial 7')
        self.assert_refused(self.record_lineage(trial='1/4711'), '4711')
        self.assert_refused(self.record_lineage(trial='first'), 'first')
        self.assert_refused(self.record_lineage(count='-1'), 'count is "-1"')
        self.assert_refused(self.record_lineage(output=self.folder), self.folder + '/experiment.db')
        self.assert_refused(self.record_lineage(output='results'), 'it must be an absolute path')
        with open(self.folder + '/file', 'w', encoding='utf-8'):
            pass
        self.assert_refused(self.record_lineage(bag=self.folder + '/file/l.bag'), self.folder + '/file')
        self.assertEqual(glob.glob(self.output + '/*.bag*'), [])

    def test_an_empty_lineage_is_said(self):
        self.evolve()
        with sqlite3.connect(self.output + '/experiment.db') as archive:  # as before the first generation ends
            archive.executescript('DELETE FROM survivors; DELETE FROM generations; DELETE FROM individuals;')
        self.assert_refused(self.record_lineage(), 'there is no lineage: no trial has a valid champion yet')

    def watch_with_renderer(self, **arguments):
        self.launch('watch.launch', rviz='false', output=self.output, individual='1/0')
        return self.launch('renderer.launch', **dict(SMALL_PICTURES, **arguments))

    def test_the_renderer_draws_what_a_player_shows(self):
        self.evolve(lifetime=3)
        images = self.listen('renderer/image', Image)
        self.watch_with_renderer()
        wait_until(lambda: len(images) > 2, 'there are pictures')
        image = images[-1]
        self.assertEqual((image.width, image.height, image.step, image.encoding), (320, 180, 960, 'bgr8'))
        pixels = list(zip(image.data[0::3], image.data[1::3], image.data[2::3]))
        self.assertEqual(len(pixels), 320 * 180)
        coloured = [pixel for pixel in pixels if max(pixel) - min(pixel) > 80]
        bright = [pixel for pixel in pixels if min(pixel) > 180]
        self.assertGreater(len(coloured), 500)  # the robot
        self.assertGreater(len(bright), 20000)  # floor and sky
        self.assertNotEqual(images[0].data, images[-1].data)

    def test_the_renderer_draws_a_bag_that_is_played(self):
        self.evolve(lifetime=3, generations=0)
        self.record_lineage()
        images = self.listen('renderer/image', Image)
        self.launch('renderer.launch', shown='/lineage', **SMALL_PICTURES)
        self.launch('replay.launch', bag=self.bag, rviz='false', loop='true')
        wait_until(lambda: len(images) > 2, 'there are pictures')
        self.assertGreater(len(set(images[-1].data)), 50)

    def test_the_renderer_films_what_it_draws(self):
        self.evolve(lifetime=3)
        film = self.folder + '/film.mp4'
        images = self.listen('renderer/image', Image)
        renderer = self.watch_with_renderer(film=film)
        wait_until(lambda: len(images) > 5, 'there are pictures')
        renderer.stop()
        self.assertTrue(os.path.getsize(film) > 1000, renderer.output())

    def start_renderer(self, path, **parameters):
        rospy.set_param(self.namespace + '/renderer', dict(SMALL_PICTURES, **parameters))
        return self.start('/usr/bin/env', 'PATH=' + path, program('renderer'), 'robot:=player/robot',
                          'floor:=player/floor')

    def test_a_renderer_without_ffmpeg_makes_png_files_only(self):
        renderer = self.start_renderer('/nonexistent', film=self.folder + '/film.mp4')
        self.assertEqual(renderer.wait(), 1, renderer.output())
        self.assertTrue(renderer.said('apt-get install ffmpeg'), renderer.output())
        self.evolve()
        self.launch('watch.launch', rviz='false', output=self.output, individual='1/0')
        self.start_renderer('/nonexistent', film=self.folder + '/pictures/')
        wait_until(lambda: os.path.exists(self.folder + '/pictures/00002.png'), 'there are pictures')

    def test_a_renderer_says_what_is_wrong(self):
        for name, value, message in (('film', '/proc/nothing/film.mp4', '/proc/nothing'), ('film', 'film.mp4', 'absolute path'),
                                     ('width', '0', 'width'), ('rate', 'fast', 'rate')):
            renderer = self.start_renderer(os.environ['PATH'], **{name: value})
            self.assertEqual(renderer.wait(), 1, renderer.output())
            self.assertTrue(renderer.said('[FATAL]') and renderer.said(message), renderer.output())


if __name__ == '__main__':
    rospy.init_node('lineage_rostest', disable_signals=True)
    rostest.rosrun('devo_evo', 'lineage', LineageTest, sys.argv)
