"""Small archives with known contents, made from the tool's own empty archive."""

import functools
import hashlib
import os
import pathlib
import sqlite3
import subprocess
import tempfile

import numpy as np

VOXELS = 48


@functools.lru_cache(maxsize=None)
def _empty_archive(body="soft"):
    """The bytes of an archive that the tool made, to be filled with something else."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(
            [
                os.environ["DEVO_EVO_TOOL"],
                "evolve",
                "--trials",
                "1",
                "--generations",
                "0",
                "--population",
                "2",
                "--body",
                body,
                "--lifetime" if body == "soft" else "--rigid_lifetime",
                "0.001",
                "--threads",
                "1",
                "--output",
                folder,
            ],
            check=True,
            capture_output=True,
        )
        return (pathlib.Path(folder) / "experiment.db").read_bytes()


def blob(values):
    """As the archive keeps arrays."""
    values = np.asarray(values, dtype="<f8")
    return values.tobytes()


def phenotype(*words):
    """A phenotype hash for something."""
    return hashlib.sha256(repr(words).encode()).digest()[:16]


class Experiment:
    """An archive in which each trial is one line of descent: every newcomer is the child of the last one."""

    BODY = "soft"

    def __init__(self, folder, treatment="evo_devo", **parameters):
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        path = self.folder / "experiment.db"
        path.write_bytes(_empty_archive(self.BODY))
        self.database = sqlite3.connect(path)
        for table in ("individuals", "genomes", "generations", "survivors"):
            self.database.execute(f"DELETE FROM {table}")
        for name, value in {
            "treatment": treatment,
            "generations": 10,
            "lifetime" if self.BODY == "soft" else "rigid_lifetime": 10,
            "population": 30,
            **parameters,
        }.items():
            self.database.execute("INSERT OR REPLACE INTO parameters VALUES (?, ?, '')", (name, str(value)))

    def add_trial(self, trial, generations, fitness, body=None, control=None, turns=None):
        """Newcomers born in `generations`, with fitness [body lengths] (None: invalid) and windows [1]."""
        best, champion = None, 0
        for number, generation in enumerate(generations):
            value = fitness[number]
            self.add_robot(
                trial,
                number,
                number - 1 if number else None,
                generation,
                value,
                body[number] if body is not None else 0.0,
                control[number] if control is not None else 0.0,
                turns[number] if turns is not None else 0.0,
            )
            if value is not None and (best is None or value >= best):
                best, champion = value, number
            self.add_survivors(trial, generation, champion, best)
        return champion

    def add_robot(self, trial, number, parent, generation, fitness, body=0.0, control=0.0, turns=0.0):
        """One individual."""
        valid = fitness is not None
        self.database.execute(
            "INSERT INTO individuals (trial, id, parent, generation, age, valid, fitness, displacement_y_voxels, "
            "turns, morphology_window, control_window, state_hash, phenotype_hash, genome_hash) "
            "VALUES (?, ?, ?, ?, 0, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
            (
                trial,
                number,
                parent,
                int(generation),
                int(valid),
                _float(fitness),
                None if not valid else 4.0 * fitness,
                _float(turns) if valid else None,
                float(body),
                float(control),
                bytes(8) if valid else None,
                phenotype(str(self.folder), trial, number),
                bytes(16),
            ),
        )

    def add_survivors(self, trial, generation, champion, best):
        """One generation, with its champion alone as a survivor."""
        self.database.execute(
            "INSERT INTO generations VALUES (?, ?, ?, ?, ?)", (trial, int(generation), champion, best, best)
        )
        self.database.execute("INSERT INTO survivors VALUES (?, ?, 1, ?)", (trial, int(generation), champion))

    def add_genome(self, trial, number, genome):
        """The genome of an individual."""
        self.database.execute(
            "INSERT INTO genomes (trial, id, parent, size_gene_initial, size_gene_final, phase_initial, phase_final, "
            "mutation_rate) VALUES (?, ?, NULL, ?, ?, ?, ?, NULL)",
            (
                trial,
                number,
                *(
                    blob(getattr(genome, name))
                    for name in ("size_gene_initial", "size_gene_final", "phase_initial", "phase_final")
                ),
            ),
        )

    def close(self):
        """Commits. Returns the folder."""
        self.database.commit()
        self.database.close()
        return self.folder


class RigidExperiment(Experiment):
    """The same of quadrupeds."""

    BODY = "rigid"

    def add_quadruped(self, trial, number, parent, generation, **values):
        """One individual. values: of columns; what is not given is 0, or NULL for times."""
        columns = {
            "fitness": 0.0025,
            "descent": 1.0,
            "sideways": 0.0,
            "turns": 0.0,
            "morphology_window": 0.0,
            "control_window": 0.0,
            "first_roll_since_birth_s": None,
            **values,
        }
        names = list(columns)
        self.database.execute(
            f"INSERT INTO individuals (trial, id, parent, generation, age, valid, {', '.join(names)}, state_hash, "
            f"phenotype_hash, genome_hash) VALUES (?, ?, ?, ?, 0, 1, {', '.join('?' * len(names))}, ?, ?, ?)",
            (
                trial,
                number,
                parent,
                int(generation),
                *(_float(columns[name]) for name in names),
                bytes(8),
                phenotype(str(self.folder), trial, number),
                bytes(16),
            ),
        )


def _float(value):
    return None if value is None else float(value)
