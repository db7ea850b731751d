"""A study's folder (docs/study.md) as pandas frames: its arms' archives, and what was simulated for analyses.

The folder of a single experiment is taken as a study of one arm, so that its figures can be drawn, too.
"""

import pathlib

import numpy as np
import pandas as pd

from .archive import Archive
from .caching import remembered
from .database import Database
from .errors import ArchiveError, NotBegun

APPLICATION_ID = 0x6465766F + 1
VERSION = 1
LABELS = {
    "evo": "Evo",
    "evo_devo": "Evo-Devo",
    "evo_devo_body": "Evo-Devo body",
    "evo_devo_control": "Evo-Devo control",
}
_EVALUATION = (
    "valid, fitness, displacement_y_voxels, displacement_xy_voxels, first_top_contact_since_birth_s, "
    "fell_over_since_birth_s, turns, airborne_fraction"
)


def open_study(output):
    """The study, or the single experiment, in a folder. Raises ArchiveError if there is neither."""
    return Study(output)


class Study:
    """A study as it was when it was opened; read only, also while it goes on."""

    def __init__(self, output):
        self.output = pathlib.Path(output)
        self._archives = {}
        self._remembered = {}
        self._tables = None
        path = self.output / "study.db"
        if path.is_file():
            self._tables = Database(path, APPLICATION_ID, VERSION, "study")
            self.arms = self._tables.frame("SELECT arm, part, treatment, profile, mutation_rate, selection FROM arms")
            self.parameters = dict(self._tables.rows("SELECT name, value FROM parameters"))
        elif (self.output / "experiment.db").is_file():
            archive = Archive(self.output)
            self._archives["."] = archive
            self.parameters = archive.parameters
            selection = archive.parameters.get("selection", "afpo")
            mutation_rate = archive.parameters.get("mutation_rate", "self_adaptive")  # rigid bodies have none
            part = "other"
            if selection == "afpo" and mutation_rate == "self_adaptive":
                part = "rigid" if archive.body == "rigid" else "main"
            self.arms = pd.DataFrame(
                [
                    {
                        "arm": ".",
                        "part": part,
                        "treatment": archive.treatment,
                        "profile": archive.parameters.get("profile", ""),
                        "mutation_rate": mutation_rate,
                        "selection": selection,
                    }
                ]
            )
        else:
            raise ArchiveError(
                f"there is neither study.db nor experiment.db in {self.output}; name the folder that a "
                "study or an experiment wrote to"
            )

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """Lets go of all files."""
        for archive in self._archives.values():
            if archive is not None:
                archive.close()
        if self._tables is not None:
            self._tables.close()

    @property
    def is_study(self):
        """Whether it is more than a single experiment."""
        return self._tables is not None

    @property
    def profile(self):
        """The name of the profile, "paper" or "released_code"."""
        return self.parameters.get("profile", "")

    def archive(self, arm):
        """The archive of an arm; None if it has not begun."""
        if arm not in self._archives:
            self._archives[arm] = _begun(self.output / arm)
        return self._archives[arm]

    def main(self, treatment):
        """The archive of the main experiment of a treatment, with at least one finished generation; or None."""
        return self._found(self.arms[(self.arms["part"] == "main") & (self.arms["treatment"] == treatment)])

    def rigid(self, treatment):
        """The same of rigid bodies."""
        return self._found(self.arms[(self.arms["part"] == "rigid") & (self.arms["treatment"] == treatment)])

    def main_arms(self):
        """Archives beside each other in Fig. 3A: {"evo": ..., "evo_devo": ..., "evo random search": ..., ...}."""
        result = {}
        for row in self.arms[self.arms["part"].isin(["main", "partial", "baselines"])].itertuples():
            archive = self._usable(row.arm)
            if archive is not None:
                name = row.treatment if row.selection == "afpo" else f"{row.treatment} {row.selection}"
                result[name] = archive
        return result

    def sweep(self):
        """{(treatment, lambda): archive} of the mutation-rate sweep."""
        result = {}
        for row in self.arms[self.arms["part"] == "sweep"].itertuples():
            archive = self._usable(row.arm)
            if archive is not None:
                result[row.treatment, float(row.mutation_rate)] = archive
        return result

    @remembered
    def variants(self):
        """Copies of run champions with frozen development: treatment, trial, id, moment, scope, and their measures."""
        return self._view("champion_variants", "trial, id, moment, scope")

    @remembered
    def removed(self):
        """Evo-Devo run champions frozen at birth in body and control, indexed by trial; None if there are none."""
        variants = self.variants()
        rows = variants[
            (variants["part"] == "main")
            & (variants["treatment"] == "evo_devo")
            & (variants["moment"] == "birth")
            & (variants["scope"] == "both")
        ]
        archive = self.main("evo_devo")
        if archive is None or rows.empty:
            return None
        rows = rows.set_index("trial")
        return rows[rows.index.isin(archive.horizon().trials)]

    @remembered
    def walks(self):
        """Steps of random walks: treatment, trial, id, space, robot, operator, walk, step, fitness, and `relative`:
        fitness [1] in units of that at step 0."""
        frame = self._view("champion_walks", "trial, id, space, robot, operator, walk, step, voxels_changed")
        keys = ["arm", "trial", "space", "robot", "operator", "walk"]
        starts = frame[frame["step"] == 0].set_index(keys)["fitness"].rename("start")
        frame = frame.join(starts[~starts.index.duplicated()], on=keys)
        frame["relative"] = np.where(frame["start"] > 0, frame["fitness"] / frame["start"], np.nan)
        return frame

    @remembered
    def ancestors(self):
        """Lineages of run champions, simulated again: treatment, trial, champion, position (0: founder), measures,
        windows, and how the step from the parent moved initial and final values."""
        return self._view(
            "champion_ancestors",
            "trial, champion, position, id, generation, morphology_window, control_window, "
            "body_initial_towards_final, body_final_towards_initial, control_initial_towards_final, "
            "control_final_towards_initial",
        )

    @remembered
    def neutral_lineages(self, treatment="evo_devo"):
        """{trial: {"morphology_window": replicate x position, "control_window": the same}} of the main experiment."""
        if not self.is_study or not self._tables.has("neutral_lineages"):
            return {}
        result = {}
        rows = self._tables.rows(
            "SELECT n.trial, n.morphology_windows, n.control_windows FROM neutral_lineages AS n "
            "JOIN arms AS a USING (arm) "
            "JOIN champions AS c ON c.arm = n.arm AND c.trial = n.trial AND c.id = n.champion "
            "WHERE a.part = 'main' AND a.treatment = ? ORDER BY n.trial, n.replicate",
            (treatment,),
        )
        for trial, morphology, control in rows:
            windows = result.setdefault(trial, {"morphology_window": [], "control_window": []})
            windows["morphology_window"].append(np.frombuffer(morphology, "<f8"))
            windows["control_window"].append(np.frombuffer(control, "<f8"))
        return {
            trial: {name: np.array(courses) for name, courses in windows.items()} for trial, windows in result.items()
        }

    @remembered
    def traces(self):
        """Velocity over life: treatment, trial, robot (champion, frozen_at_birth), `velocities` (arrays of means over
        0.5 s [body lengths/s])."""
        frame = self._view("champion_traces", "trial, id, robot", "fitness, velocities")
        frame["velocities"] = [None if blob is None else np.frombuffer(blob, "<f8") for blob in frame["velocities"]]
        return frame

    @remembered
    def robustness(self):
        """Lives of run champions in other worlds: treatment, trial, name, quantity, value, fitness, `relative` [1]."""
        frame = self._view("champion_robustness", "trial, id, name, quantity, value")
        at_home = frame[frame["quantity"] == "none"].set_index(["arm", "trial"])["fitness"].rename("home")
        frame = frame.join(at_home[~at_home.index.duplicated()], on=["arm", "trial"])
        frame["relative"] = np.where(frame["home"] > 0, frame["fitness"] / frame["home"], np.nan)
        return frame

    @remembered
    def mutational_impact(self):
        """What mutation changes by our own operator: treatment, profile, traits, mutation_rate, means, deviations."""
        columns = [
            "treatment",
            "profile",
            "traits",
            "mutation_rate",
            "reproductions",
            "voxels_changed_mean",
            "voxels_changed_sd",
            "genes_changed_mean",
            "genes_changed_sd",
        ]
        if not self.is_study or not self._tables.has("mutational_impact"):
            return pd.DataFrame(columns=columns)
        return self._tables.frame(
            f"SELECT {', '.join(columns)} FROM mutational_impact ORDER BY profile, traits, mutation_rate"
        )

    def notes(self, *treatments):
        """Sentences for a figure: profile, and how many trials and generations there are of each treatment."""
        parts = []
        for treatment in treatments:
            archive = self.main(treatment)
            label = LABELS.get(treatment, treatment)
            if archive is None:
                parts.append(f"{label}: no finished generation.")
                continue
            horizon = archive.horizon()
            text = (
                f"{label}: {counted(len(horizon.trials), 'trial')}, {counted(horizon.generation, 'generation')}, "
                f"population {archive.parameters['population']}, lifetime {archive.parameters['lifetime']} s"
            )
            if horizon.generation < archive.generations_asked_for:
                text += f" (of {archive.generations_asked_for}; still running)"
            if horizon.left_out:
                text += "; unfinished and left out: " + ", ".join(
                    f"trial {trial} at generation {last}" for trial, last in horizon.left_out.items()
                )
            parts.append(text + ".")
        return [f"Profile {self.profile}. " + " ".join(parts)]

    def _found(self, rows):
        for arm in rows["arm"]:
            archive = self._usable(arm)
            if archive is not None:
                return archive
        return None

    def _usable(self, arm):
        archive = self.archive(arm)
        return archive if archive is not None and archive.horizon().trials else None

    def _view(self, name, columns, measures=_EVALUATION):
        everything = ", ".join(f"v.{column.strip()}" for column in f"{columns}, {measures}".split(","))
        header = ["arm", "part", "treatment"] + [column.strip() for column in f"{columns}, {measures}".split(",")]
        if not self.is_study or not self._tables.has(name):
            return pd.DataFrame(columns=header)
        frame = self._tables.frame(
            f"SELECT v.arm, a.part, a.treatment, {everything} FROM {name} AS v JOIN arms AS a USING (arm)"
        )
        for column in ("fitness", "turns", "fell_over_since_birth_s", "first_top_contact_since_birth_s"):
            if column in frame:
                frame[column] = frame[column].astype(float)
        return frame


def _begun(folder):
    """The archive in a folder; None if there is none, or nothing in it yet."""
    if not (folder / "experiment.db").is_file():
        return None
    try:
        return Archive(folder)
    except NotBegun:
        return None


def counted(number, noun):
    """For example "1 trial" or "2 trials"."""
    return f"{number} {noun}" + ("" if number == 1 else "s")
