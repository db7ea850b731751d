#!/usr/bin/python3
"""Archives of rigid bodies as frames, and their robots simulated again from Python."""

import os
import subprocess
import tempfile
import unittest

import numpy as np

import devo_evo


class RigidArchiveTest(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="devo_evo_test_")
        subprocess.run(
            [os.environ["DEVO_EVO_TOOL"], "evolve", "--output", cls.folder.name, "--body", "rigid",
             "--rigid_lifetime", "0.5", "--population", "4", "--generations", "2"],
            check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.archive = devo_evo.Archive(cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        cls.archive.close()
        cls.folder.cleanup()

    def test_frames_have_the_columns_and_units_of_the_body(self):
        self.assertEqual(self.archive.body, "rigid")
        frame = self.archive.individuals()
        self.assertEqual(len(frame), 4 + 2 * 5)
        self.assertNotIn("displacement_y_voxels", frame)
        self.assertTrue(frame["leg_contact"].between(0.0, 1.0).all())
        units = frame.attrs["units"]
        self.assertEqual((units["fitness"], units["descent"]), ("1/m^2", "m"))
        self.assertEqual(self.archive.generations().attrs["units"]["best_fitness"], "1/m^2")

    def test_windows_follow_from_genomes(self):
        champion = self.archive.run_champions().iloc[0]
        (genome,) = self.archive.genomes([(1, champion["id"])])
        self.assertIsInstance(genome, devo_evo.RigidGenome)
        self.assertAlmostEqual(genome.morphology_window(), champion["morphology_window"], places=14)
        self.assertAlmostEqual(genome.control_window(), champion["control_window"], places=14)
        self.assertEqual(len(self.archive.lineage(1)), self.archive.lineage(1)["ancestor"].iloc[-1] + 1)

    def test_robots_live_again_to_the_last_bit(self):
        robots = [(1, number) for number in self.archive.survivors()["id"]]
        again = devo_evo.evaluate_individuals(self.archive, robots)
        for trial, number in robots:
            archived = self.archive.individual(trial, number)
            self.assertEqual(again.at[(trial, number), "state_hash"], archived["state_hash"])
            self.assertEqual(again.at[(trial, number), "fitness"], archived["fitness"])
            self.assertTrue(np.isclose(again.at[(trial, number), "descent"], archived["descent"], rtol=0, atol=0))

    def test_arrays_of_another_size_are_refused(self):
        with self.assertRaisesRegex(devo_evo.InvalidInput, r"weight_final has the shape \(4,\); it must be \(8,\)"):
            devo_evo.RigidGenome([0] * 4, [0] * 4, [0] * 8, [0] * 4)


if __name__ == "__main__":
    unittest.main()
