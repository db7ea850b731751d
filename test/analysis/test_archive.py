#!/usr/bin/python3
"""Archives as frames: what is in them, odd ones, and robots simulated again to the same bits."""

import os
import pathlib
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import devo_evo  # noqa: E402
from synthetic import Experiment  # noqa: E402


class TemporaryFolderTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def archive(self, folder):
        archive = devo_evo.Archive(folder)
        self.addCleanup(archive.close)
        return archive


class FramesTest(TemporaryFolderTest):
    def setUp(self):
        super().setUp()
        experiment = Experiment(self.folder / "a", generations=3)
        experiment.add_trial(
            1, range(4), [1.0, 3.0, None, 2.0], body=[0.3, 0.5, 0.6, 0.1], control=[0.3, 0.3, 0.4, 0.4]
        )
        experiment.add_trial(2, range(4), [0.5, 0.6, 0.7, 0.8])
        self.output = experiment.close()

    def test_every_column_has_a_unit(self):
        archive = self.archive(self.output)
        for frame in (
            archive.trials(),
            archive.generations(),
            archive.individuals(),
            archive.survivors(),
            archive.lineages(),
            archive.run_champions(),
        ):
            self.assertEqual(set(frame.attrs["units"]), set(frame.columns))
        self.assertEqual(archive.individuals().attrs["units"]["fitness"], "body lengths")

    def test_trials_count_robots_and_invalid_ones(self):
        trials = self.archive(self.output).trials().set_index("trial")
        self.assertEqual(trials["individuals"].tolist(), [4, 4])
        self.assertEqual(trials["invalid"].tolist(), [1, 0])
        self.assertTrue(trials["finished"].all())

    def test_an_invalid_robot_has_no_fitness(self):
        individuals = self.archive(self.output).individuals(trial=1)
        self.assertEqual(individuals["valid"].tolist(), [True, True, False, True])
        np.testing.assert_array_equal(individuals["fitness"], [1.0, 3.0, np.nan, 2.0])
        self.assertEqual(len(self.archive(self.output).individuals(trial=1, valid_only=True)), 3)

    def test_the_run_champion_is_the_best_and_its_lineage_begins_with_the_founder(self):
        archive = self.archive(self.output)
        self.assertEqual(archive.run_champions()["id"].tolist(), [1, 3])
        lineage = archive.lineage(2)
        self.assertEqual(lineage["id"].tolist(), [0, 1, 2, 3])
        self.assertEqual(lineage["ancestor"].tolist(), [0, 1, 2, 3])
        self.assertTrue(np.isnan(lineage["parent"].iloc[0]))

    def test_elitism_is_asserted(self):
        with devo_evo.Archive(self.output) as archive:
            archive.check_elitism()
        database = sqlite3.connect(self.output / "experiment.db")
        database.execute("UPDATE individuals SET fitness = 9.0 WHERE trial = 2 AND id = 1")
        database.commit()
        database.close()
        with self.assertRaisesRegex(devo_evo.ArchiveError, "generation 1 of trial 2 has fitness 0.6, but 9.0"):
            self.archive(self.output).check_elitism()

    def test_while_it_is_written_it_shows_one_moment_until_it_is_refreshed(self):
        database = sqlite3.connect(self.output / "experiment.db")
        self.addCleanup(database.close)
        database.execute("PRAGMA journal_mode = WAL")
        archive = self.archive(self.output)
        database.execute("INSERT INTO generations VALUES (1, 4, 1, 3.0, 3.0)")
        database.commit()
        self.assertEqual(archive.trials()["generations"].tolist(), [3, 3])
        archive.refresh()
        self.assertEqual(archive.trials()["generations"].tolist(), [4, 3])

    def test_a_reader_keeps_nobody_from_resuming_and_notices_it(self):
        archive = self.archive(self.output)
        archive.trials()
        database = sqlite3.connect(self.output / "experiment.db", timeout=0.0)
        self.addCleanup(database.close)
        database.execute("INSERT INTO generations VALUES (1, 4, 1, 3.0, 3.0)")
        database.commit()
        with self.assertRaisesRegex(devo_evo.ArchiveError, "changed since it was opened"):
            archive.trials()
        archive.refresh()
        self.assertEqual(archive.trials()["generations"].tolist(), [4, 3])

    def test_what_a_writer_began_that_was_killed_is_undone(self):
        process = os.fork()
        if process == 0:
            database = sqlite3.connect(self.output / "experiment.db", isolation_level=None)
            database.execute("PRAGMA cache_size = 1")
            database.execute("BEGIN IMMEDIATE")
            database.execute("UPDATE individuals SET fitness = 99.0 WHERE valid")
            database.execute("CREATE TABLE large AS SELECT zeroblob(1000000)")  # does not fit into its memory
            os.kill(os.getpid(), signal.SIGKILL)
        os.waitpid(process, 0)
        self.assertTrue((self.output / "experiment.db-journal").exists())
        self.assertEqual(self.archive(self.output).run_champions()["fitness"].tolist(), [3.0, 0.8])

    def test_it_is_read_in_a_folder_that_must_not_be_written(self):
        self.output.chmod(0o500)
        self.addCleanup(self.output.chmod, 0o700)
        self.assertEqual(len(self.archive(self.output).trials()), 2)

    def test_unknown_individuals_and_columns_are_named(self):
        archive = self.archive(self.output)
        with self.assertRaisesRegex(devo_evo.InvalidInput, "has no individual 3/7"):
            archive.lineage(3, 7)
        with self.assertRaisesRegex(devo_evo.InvalidInput, "no column 'speed'"):
            archive.individuals(columns=("speed",))
        with self.assertRaisesRegex(devo_evo.InvalidInput, "does not keep the genome of 1/0"):
            archive.genomes([(1, 0)])


class OddArchivesTest(TemporaryFolderTest):
    def test_a_trial_that_is_behind_is_left_out_once_others_have_finished(self):
        experiment = Experiment(self.folder / "a", generations=3)
        experiment.add_trial(1, range(4), [1.0, 1.0, 1.0, 2.0])
        experiment.add_trial(2, range(2), [5.0, 6.0])
        horizon = self.archive(experiment.close()).horizon()
        self.assertEqual((horizon.generation, horizon.trials, horizon.left_out), (3, [1], {2: 1}))

    def test_before_any_trial_has_finished_all_are_compared_where_each_has_been(self):
        experiment = Experiment(self.folder / "a", generations=9)
        experiment.add_trial(1, range(4), [1.0, 1.0, 1.0, 2.0])
        experiment.add_trial(2, range(2), [5.0, 6.0])
        archive = self.archive(experiment.close())
        self.assertEqual((archive.horizon().generation, archive.horizon().trials), (1, [1, 2]))
        self.assertEqual(archive.run_champions()["fitness"].tolist(), [1.0, 6.0])

    def test_an_experiment_without_a_generation_is_empty(self):
        archive = self.archive(Experiment(self.folder / "a").close())
        self.assertEqual(archive.horizon().trials, [])
        self.assertTrue(archive.lineages().empty)
        self.assertTrue(archive.run_champions().empty)

    def test_what_is_no_archive_is_refused(self):
        with self.assertRaisesRegex(devo_evo.ArchiveError, "there is no archive"):
            devo_evo.Archive(self.folder)
        (self.folder / "experiment.db").write_bytes(b"")
        with self.assertRaisesRegex(devo_evo.ArchiveError, "nothing was committed"):
            devo_evo.Archive(self.folder)
        sqlite3.connect(self.folder / "recipes.db").execute("CREATE TABLE recipes (name TEXT)").connection.close()
        with self.assertRaisesRegex(devo_evo.ArchiveError, "of another program"):
            devo_evo.Archive(self.folder / "recipes.db")
        (self.folder / "experiment.db").write_bytes(b"no database " * 100)
        with self.assertRaisesRegex(devo_evo.ArchiveError, "not a database"):
            devo_evo.Archive(self.folder)

    def test_a_newer_version_is_refused(self):
        output = Experiment(self.folder / "a").close()
        database = sqlite3.connect(output / "experiment.db")
        database.execute("PRAGMA user_version = 99")
        database.close()
        with self.assertRaisesRegex(devo_evo.ArchiveError, "of version 99"):
            devo_evo.Archive(output)

    def test_text_where_a_number_belongs_is_refused(self):
        experiment = Experiment(self.folder / "a", generations=1)
        experiment.add_trial(1, range(2), [1.0, 2.0])
        experiment.database.execute("UPDATE individuals SET turns = 'many' WHERE id = 1")
        with self.assertRaisesRegex(devo_evo.ArchiveError, "in column turns, could not convert"):
            self.archive(experiment.close()).individuals()

    def test_a_genome_of_another_size_is_refused(self):
        experiment = Experiment(self.folder / "a")
        experiment.add_trial(1, range(1), [1.0])
        experiment.database.execute(
            "INSERT INTO genomes (trial, id, size_gene_initial, phase_initial) "
            "VALUES (1, 0, x'00', x'0000000000000000')"
        )
        archive = self.archive(experiment.close())
        with self.assertRaisesRegex(devo_evo.ArchiveError, "genome of 1/0"):
            archive.genomes([(1, 0)])

    def test_a_lineage_without_its_founder_is_refused(self):
        experiment = Experiment(self.folder / "a", generations=1)
        experiment.add_trial(1, range(2), [1.0, 2.0])
        experiment.database.execute("DELETE FROM individuals WHERE id = 0")
        with self.assertRaisesRegex(devo_evo.ArchiveError, "parent of 1/1 is missing"):
            self.archive(experiment.close()).lineage(1)


class EvaluationTest(TemporaryFolderTest):
    def setUp(self):
        super().setUp()
        subprocess.run(
            [
                os.environ["DEVO_EVO_TOOL"],
                "evolve",
                "--trials",
                "2",
                "--generations",
                "2",
                "--population",
                "4",
                "--lifetime",
                "0.1",
                "--output",
                str(self.folder / "run"),
            ],
            check=True,
            capture_output=True,
        )

    def test_robots_simulated_again_are_the_archives_to_the_last_bit(self):
        archive = self.archive(self.folder / "run")
        survivors = archive.survivors()
        again = devo_evo.evaluate_individuals(archive, zip(survivors["trial"], survivors["id"]))
        for (trial, number), row in again.iterrows():
            known = archive.individual(trial, number)
            for measure in ("fitness", "displacement_xy_voxels", "turns", "airborne_fraction"):
                self.assertEqual(row[measure], known[measure], f"{measure} of {trial}/{number}")
            self.assertEqual(row["state_hash"], known["state_hash"])

    def test_windows_of_genomes_are_the_archives(self):
        archive = self.archive(self.folder / "run")
        for trial, row in archive.run_champions().iterrows():
            (genome,) = archive.genomes([(trial, row["id"])])
            self.assertAlmostEqual(genome.morphology_window(), row["morphology_window"], places=12)
            self.assertAlmostEqual(genome.control_window(archive.profile), row["control_window"], places=12)

    def test_parameters_can_be_changed(self):
        archive = self.archive(self.folder / "run")
        robot = [(1, archive.run_champions().at[1, "id"])]
        self.assertNotEqual(
            devo_evo.evaluate_individuals(archive, robot, gravity=3.7)["state_hash"].iloc[0],
            devo_evo.evaluate_individuals(archive, robot)["state_hash"].iloc[0],
        )

    def test_a_robot_without_development_has_no_windows(self):
        archive = self.archive(self.folder / "run")
        (genome,) = archive.genomes([(1, archive.run_champions().at[1, "id"])])
        frozen = genome.without_development()
        self.assertEqual((frozen.morphology_window(), frozen.control_window()), (0.0, 0.0))
        np.testing.assert_array_equal(frozen.phase_final, genome.phase_initial)
        body = genome.without_development(control=False, stage=1.0)
        np.testing.assert_array_equal(body.size_gene_initial, genome.size_gene_final)
        self.assertEqual(body.control_window(), genome.control_window())

    def test_nobody_is_evaluated_without_robots(self):
        self.assertEqual(len(devo_evo.evaluate([])), 0)

    def test_mistakes_are_told_as_the_tool_tells_them(self):
        genome = devo_evo.Genome(*[np.zeros(48)] * 4)
        with self.assertRaisesRegex(devo_evo.InvalidInput, "lifetime"):
            devo_evo.evaluate([genome], {"lifetime": -1})
        with self.assertRaisesRegex(devo_evo.InvalidInput, "one number a voxel"):
            devo_evo.Genome(np.zeros(48), np.zeros(48), np.zeros(47), np.zeros(48))

    def test_a_running_experiment_can_be_read(self):
        shutil.rmtree(self.folder / "run")
        writer = subprocess.Popen(
            [
                os.environ["DEVO_EVO_TOOL"],
                "evolve",
                "--generations",
                "100000",
                "--population",
                "4",
                "--lifetime",
                "0.01",
                "--threads",
                "1",
                "--output",
                str(self.folder / "run"),
            ],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        self.addCleanup(writer.wait)
        self.addCleanup(writer.kill)
        archive = self.wait_for_generation(3)
        archive.check_elitism()
        generation = archive.horizon().generation
        self.assertGreaterEqual(generation, 3)
        self.assertEqual(len(archive.survivors()), 4)
        self.assertIsNone(writer.poll(), "the evolver had ended already")

    def wait_for_generation(self, generation):
        deadline = time.monotonic() + 60.0
        while time.monotonic() < deadline:
            try:
                archive = devo_evo.Archive(self.folder / "run")
                if archive.horizon().generation >= generation:
                    self.addCleanup(archive.close)
                    return archive
                archive.close()
            except devo_evo.ArchiveError:  # it does not exist yet
                pass
            time.sleep(0.05)
        return self.fail(f"generation {generation} was not reached")


if __name__ == "__main__":
    unittest.main()
