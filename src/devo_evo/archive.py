"""An experiment's archive (docs/archive.md) as pandas frames.

Every frame has its columns' units in `frame.attrs["units"]`; "" is for counts, names and hashes. Columns are named as
in the archive.
"""

import dataclasses
import pathlib
from typing import List, Optional

import numpy as np
import pandas as pd

from .caching import remembered
from .columns import (
    GENOME_COLUMNS,
    HASH_COLUMNS,
    INDIVIDUAL_COLUMNS,
    RIGID_GENOME_COLUMNS,
    RIGID_INDIVIDUAL_COLUMNS,
    RIGID_UNITS,
    UNITS,
)
from .database import Database
from .errors import ArchiveError, InvalidInput
from .genomes import Genome, RigidGenome

APPLICATION_ID = 0x6465766F  # "devo"
SCHEMA_VERSION = 1


@dataclasses.dataclass(frozen=True)
class Horizon:
    """Which generation of which trials is analysed."""

    generation: int  # the last that all of `trials` have finished
    trials: List[int]
    left_out: dict  # trial that is behind -> its last finished generation


class Archive:
    """The archive in an output folder, read only; also while an evolver writes to it.

    Everything read from one object belongs to one moment, that of its opening, until `refresh` is called.
    """

    def __init__(self, output):
        """output: the folder that an experiment wrote to, or its experiment.db. Raises ArchiveError."""
        path = pathlib.Path(output)
        self.path = path / "experiment.db" if path.is_dir() or path.suffix != ".db" else path
        if not self.path.is_file():
            raise ArchiveError(f"there is no archive {self.path}; name the output folder of an experiment")
        self._remembered = {}
        self._database = Database(self.path, APPLICATION_ID, SCHEMA_VERSION, "archive")
        self.parameters = dict(self._database.rows("SELECT name, value FROM parameters"))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """Lets go of the file."""
        self._database.close()

    def refresh(self):
        """Moves on to what the evolver has committed by now."""
        self._remembered.clear()
        self._database.refresh()
        self.parameters = dict(self._database.rows("SELECT name, value FROM parameters"))

    @property
    def output(self):
        """The folder that the archive lies in."""
        return self.path.parent

    @property
    def body(self):
        """The kind of body, "soft" or "rigid"; archives from before there were others are of soft ones."""
        return self.parameters.get("body", "soft")

    @property
    def individual_columns(self):
        """The columns of an individual that frames have by default: those of its kind of body."""
        return RIGID_INDIVIDUAL_COLUMNS if self.body == "rigid" else INDIVIDUAL_COLUMNS

    @property
    def treatment(self):
        """The treatment's name, such as "evo_devo"."""
        return self._parameter("treatment")

    @property
    def profile(self):
        """The name of the profile, "paper" or "released_code"."""
        return self._parameter("profile")

    @property
    def generations_asked_for(self):
        """Generations that the last start asked for."""
        return int(self._parameter("generations"))

    def sql(self, query, parameters=()):
        """The result of a query as a frame; docs/archive.md describes the tables."""
        return self._with_units(self._database.frame(query, parameters))

    def designs(self, above):
        """Each phenotype that was ever evaluated, once: control_window, morphology_window [1], fitness [body lengths],
        as far as its fitness exceeds `above` [body lengths]. Of a whole experiment of the paper, millions."""
        return self._with_units(
            self._database.numbers(
                "SELECT min(control_window) AS control_window, min(morphology_window) AS morphology_window, "
                "min(fitness) AS fitness FROM individuals WHERE valid AND fitness > ? GROUP BY phenotype_hash",
                (float(above),),
            )
        )

    def trials(self):
        """A row per trial: last finished generation, whether it is all that was asked for, robots, invalid ones."""
        counts = self.sql(
            "SELECT trial, count(*) AS individuals, sum(NOT valid) AS invalid FROM individuals GROUP BY trial"
        )
        return self._with_units(self._progress().merge(counts, on="trial", how="left"))

    @remembered
    def horizon(self):
        """What can be compared: the trials that finished, at the generation asked for; before any has, all of them at
        the last generation that each has reached."""
        trials = self._progress()
        if trials.empty:
            return Horizon(-1, [], {})
        finished = trials[trials["finished"]]
        if finished.empty:
            return Horizon(int(trials["generations"].min()), trials["trial"].tolist(), {})
        behind = trials[~trials["finished"]]
        return Horizon(
            self.generations_asked_for,
            finished["trial"].tolist(),
            dict(zip(behind["trial"].tolist(), behind["generations"].tolist())),
        )

    def generations(self, trial=None):
        """A row per finished generation of each trial: champion's id, best and median fitness of the survivors."""
        return self.sql(
            "SELECT trial, generation, champion, best_fitness, median_fitness FROM generations "
            "WHERE ?1 IS NULL OR trial = ?1 ORDER BY trial, generation",
            (_integer(trial),),
        )

    def individuals(self, trial=None, columns=None, valid_only=False):
        """A row per robot that ever lived. columns: among individual_columns and HASH_COLUMNS; all of the former."""
        return self._individuals(
            "(?1 IS NULL OR trial = ?1) AND (valid OR NOT ?2) ORDER BY trial, id",
            (_integer(trial), bool(valid_only)),
            self.individual_columns if columns is None else columns,
        )

    def individual(self, trial, number):
        """One robot as a series, hashes included. Raises InvalidInput if there is none."""
        frame = self._individuals(
            "trial = ? AND id = ?", (_integer(trial), _integer(number)), self.individual_columns + HASH_COLUMNS
        )
        if frame.empty:
            raise InvalidInput(f"archive {self.path} has no individual {trial}/{number}")
        return frame.iloc[0]

    def survivors(self, generation=None):
        """The populations after the selection of one generation (default: that of `horizon`), in ranking order."""
        generation = self.horizon().generation if generation is None else generation
        columns = ", ".join("i." + column for column in self.individual_columns if column not in ("trial", "id"))
        return self._typed(
            self.sql(
                f"SELECT s.trial, s.rank, s.id, {columns} FROM (SELECT DISTINCT trial FROM generations) AS t "
                "CROSS JOIN survivors AS s ON s.trial = t.trial "  # by trial: without reading those of all generations
                "JOIN individuals AS i ON i.trial = s.trial AND i.id = s.id WHERE s.generation = ? "
                "ORDER BY s.trial, s.rank",
                (_integer(generation),),
            )
        )

    def run_champions(self, generation=None):
        """The champion of each trial of `horizon` in one generation (default: that of `horizon`), indexed by trial."""
        horizon = self.horizon()
        generation = horizon.generation if generation is None else generation
        columns = ", ".join("i." + column for column in self.individual_columns if column != "trial")
        frame = self._typed(
            self.sql(
                f"SELECT g.trial, {columns} FROM generations AS g "
                "JOIN individuals AS i ON i.trial = g.trial AND i.id = g.champion "
                "WHERE g.generation = ? ORDER BY g.trial",
                (_integer(generation),),
            )
        )
        return self._with_units(frame[frame["trial"].isin(horizon.trials)].set_index("trial"))

    def lineage(self, trial, number=None):
        """A robot and its ancestors, oldest first, with `ancestor` counting from 0. Default: the run champion's."""
        if number is None:
            champions = self.run_champions()
            if trial not in champions.index:
                raise InvalidInput(f"archive {self.path} has no trial {trial} with a run champion")
            number = champions.at[trial, "id"]
        columns = ", ".join("i." + column for column in self.individual_columns)
        frame = self._typed(
            self.sql(
                "WITH RECURSIVE lineage (trial, id) AS (SELECT ?1, ?2 UNION SELECT i.trial, i.parent "
                "FROM individuals AS i JOIN lineage USING (trial, id) WHERE i.parent IS NOT NULL) "
                f"SELECT {columns} FROM lineage JOIN individuals AS i USING (trial, id) ORDER BY i.id",
                (_integer(trial), _integer(number)),
            )
        )
        if frame.empty:
            raise InvalidInput(f"archive {self.path} has no individual {trial}/{number}")
        if not np.isnan(frame["parent"].iloc[0]):
            raise ArchiveError(f"archive {self.path}: the parent of {trial}/{frame['id'].iloc[0]} is missing")
        frame.insert(0, "ancestor", np.arange(len(frame)))
        return self._with_units(frame)

    def lineages(self):
        """The lineages of all run champions, one below the other."""
        frames = [self.lineage(trial, number) for trial, number in self.run_champions()["id"].items()]
        return (
            self._with_units(pd.concat(frames, ignore_index=True))
            if frames
            else pd.DataFrame(columns=("ancestor",) + self.individual_columns)
        )

    def genomes(self, robots):
        """The genomes of individuals, pairs of trial and id; kept are those of the living and of their ancestors."""
        return [self._genome(_integer(trial), _integer(number)) for trial, number in robots]

    def check_elitism(self):
        """Asserts what selection promises: the best robot of a generation is the best of all that ever lived in its
        trial. Raises ArchiveError with the first offender."""
        born = self.sql("SELECT trial, generation, max(fitness) AS best FROM individuals GROUP BY trial, generation")
        born["best"] = born["best"].astype(float).fillna(-np.inf)
        born["best"] = born.groupby("trial")["best"].cummax()
        both = self.generations().merge(born, on=["trial", "generation"], how="left")
        both["best"] = both.groupby("trial")["best"].ffill()
        kept = both["best_fitness"].astype(float).fillna(-np.inf)
        wrong = both[kept != both["best"]]
        if not wrong.empty:
            row = wrong.iloc[0]
            raise ArchiveError(
                f"archive {self.path}: the champion of generation {int(row.generation)} of trial {int(row.trial)} "
                f"has fitness {row.best_fitness}, but {row.best} had been reached: selection lost its best"
            )

    def _progress(self):
        frame = self.sql("SELECT trial, max(generation) AS generations FROM generations GROUP BY trial")
        frame["finished"] = frame["generations"] >= self.generations_asked_for
        return frame

    def _parameter(self, name):
        if name not in self.parameters:
            raise ArchiveError(f"archive {self.path} does not name its {name}")
        return self.parameters[name]

    def _individuals(self, condition, parameters, columns):
        unknown = set(columns) - set(self.individual_columns) - set(HASH_COLUMNS)
        if unknown:
            raise InvalidInput(
                f"individuals have no column {sorted(unknown)[0]!r}; they have "
                + ", ".join(self.individual_columns + HASH_COLUMNS)
            )
        selected = ", ".join(
            f"lower(hex({column})) AS {column}" if column in HASH_COLUMNS else column for column in columns
        )
        return self._typed(self.sql(f"SELECT {selected} FROM individuals WHERE {condition}", parameters))

    def _genome(self, trial, number):
        columns = RIGID_GENOME_COLUMNS if self.body == "rigid" else GENOME_COLUMNS
        rows = list(
            self._database.rows(
                f"SELECT {', '.join(columns)} FROM genomes WHERE trial = ? AND id = ?", (trial, number)
            )
        )
        if not rows:
            raise InvalidInput(
                f"archive {self.path} does not keep the genome of {trial}/{number}: it keeps those of the "
                "living and of their ancestors (devo_evo export makes the others again)"
            )
        try:
            initial_body, final_body, initial_control, final_control, rate = [
                None if blob is None else np.frombuffer(blob, "<f8") for blob in rows[0]
            ]
            arrays = (
                initial_body,
                initial_body if final_body is None else final_body,
                initial_control,
                initial_control if final_control is None else final_control,
            )
            return RigidGenome(*arrays) if self.body == "rigid" else Genome(*arrays, rate)
        except (ValueError, TypeError) as error:
            raise ArchiveError(f"archive {self.path}: the genome of {trial}/{number} is damaged: {error}") from error

    def _typed(self, frame):
        """Where a column of numbers is NULL throughout, SQLite does not tell its type."""
        for column in frame:
            if column == "valid":
                frame[column] = frame[column].astype(bool)
            elif frame[column].dtype == object and column not in HASH_COLUMNS:
                try:
                    frame[column] = frame[column].astype(float)
                except (TypeError, ValueError) as error:
                    raise ArchiveError(f"the archive is damaged: in column {column}, {error}") from error
        if "parent" in frame:
            frame["parent"] = frame["parent"].astype(float)
        return self._with_units(frame)

    def _with_units(self, frame):
        units = RIGID_UNITS if self.body == "rigid" else UNITS
        frame.attrs["units"] = {column: units.get(column, "") for column in frame}
        return frame


def _integer(value: Optional[int]):
    return None if value is None else int(value)
