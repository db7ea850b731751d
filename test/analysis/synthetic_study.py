"""A whole study in which every claim holds, or its opposite does."""

import pathlib
import sqlite3
import struct

import numpy as np

from devo_evo import mutation_impact
from synthetic import Experiment, blob

# The tables and views of docs/study.md, as far as the analysis reads them.
STUDY_TABLES = """
CREATE TABLE parameters (name TEXT PRIMARY KEY, value TEXT, unit TEXT);
CREATE TABLE arms (arm TEXT PRIMARY KEY, part TEXT, treatment TEXT, profile TEXT, mutation_rate TEXT, selection TEXT,
  trials INTEGER, generations INTEGER);
CREATE TABLE champions (arm TEXT, trial INTEGER, id INTEGER, generation INTEGER, fitness REAL);
CREATE TABLE champion_variants (arm, trial, id, moment, scope, %(measures)s);
CREATE TABLE champion_walks (arm, trial, id, space, robot, operator, walk, step, voxels_changed, %(measures)s);
CREATE TABLE champion_ancestors (arm, trial, champion, position, id, generation, morphology_window, control_window,
  body_initial_towards_final, body_final_towards_initial, control_initial_towards_final, control_final_towards_initial,
  %(measures)s);
CREATE TABLE champion_traces (arm, trial, id, robot, velocities, %(measures)s);
CREATE TABLE champion_robustness (arm, trial, id, name, quantity, value, %(measures)s);
CREATE TABLE neutral_lineages (arm, trial, champion, replicate, morphology_windows, control_windows);
CREATE TABLE mutational_impact (treatment, profile, traits, mutation_rate, reproductions, voxels_changed_mean,
  voxels_changed_sd, genes_changed_mean, genes_changed_sd);
PRAGMA application_id = 1684371056;
PRAGMA user_version = 1;
""" % {
    "measures": "valid, fitness REAL, displacement_y_voxels, displacement_xy_voxels, first_top_contact_since_birth_s, "
    "fell_over_since_birth_s, turns, airborne_fraction"
}
assert struct.unpack(">I", b"devo")[0] + 1 == 1684371056

# What happens in a study whose every claim holds, and in one in which the opposite of each does.
AS_CLAIMED = {
    "fast_evo": 6,
    "fast_devo": 25,
    "slow": (6.0, 12.0),
    "fast_evo_fitness": 55.0,
    "fast_devo_fitness": 56.0,
    "reach_evo": (4000, 9500),
    "reach_devo": (800, 4000),
    "removed_loss": 1.0,
    "body_peak": 0.55,
    "body_last": 0.03,
    "slow_body_last": 0.45,
    "control_last": 0.44,
    "neutral_peak": 0.44,
    "elite_body": 0.02,
    "elite_control": 0.36,
    "left": {
        ("control", "evo"): 0.05,
        ("control", "fast"): 0.9,
        ("control", "slow"): 0.1,
        ("body", "evo"): 0.05,
        ("body", "fast"): 0.1,
        ("body", "slow"): 0.1,
    },
    "left_removed": 0.9,
    "roll_first": 9.5,
    "roll_last": 0.1,
    "one_roll": 1.0,
    "progenesis": 0.3,
    "neoteny": 0.1,
    "sweep_devo": (500, 3000),
    "sweep_evo": (5000, 9000),
    "sweep_1": ((5000, 5400), (5000, 5400)),
    "sweep_fast": {"low": 4, "high": 30},
    "sweep_evo_fast": 28,
    "sweep_fitness_evo_1": 40.0,
    "sweep_slow": {"low": (12.0, 15.0), "high": (5.0, 8.0)},
    "robust": {"evo": 0.4, "evo_devo": 0.8},
    "impact": 1.0,
}
OPPOSITE = {
    "fast_evo": 30,
    "fast_devo": 15,
    "slow": (20.0, 26.0),
    "fast_evo_fitness": 60.0,
    "fast_devo_fitness": 33.0,
    "reach_evo": (300, 900),
    "reach_devo": (6000, 9000),
    "removed_loss": 15.0,
    "body_peak": 0.5,
    "body_last": 0.5,
    "slow_body_last": 0.02,
    "control_last": 0.1,
    "neutral_peak": 0.65,
    "elite_body": 0.6,
    "elite_control": 0.7,
    "left": {
        ("control", "evo"): 0.9,
        ("control", "fast"): 0.1,
        ("control", "slow"): 0.8,
        ("body", "evo"): 0.9,
        ("body", "fast"): 0.9,
        ("body", "slow"): 0.9,
    },
    "left_removed": 0.9,
    "roll_first": 1.0,
    "roll_last": 8.0,
    "one_roll": 10.0,
    "progenesis": 0.1,
    "neoteny": 0.3,
    "sweep_devo": (5000, 9000),
    "sweep_evo": (500, 3000),
    "sweep_1": ((1000, 2000), (8000, 9000)),
    "sweep_fast": {"low": 25, "high": 5},
    "sweep_evo_fast": 25,
    "sweep_fitness_evo_1": 70.0,
    "sweep_slow": {"low": (5.0, 8.0), "high": (12.0, 15.0)},
    "robust": {"evo": 0.8, "evo_devo": 0.4},
    "impact": 1.1,
}

POSITIONS = 40  # members of a lineage
ROLLS_FROM = 15  # position of the first ancestor that rolls
GENERATIONS = 10000


class SyntheticStudy:
    """A study with all parts, in which everything goes as `story` tells (AS_CLAIMED, OPPOSITE)."""

    def __init__(self, folder, story, trials=30, generations=GENERATIONS, seed=1, walk_steps=8, sweep_trials=30):
        self.folder, self.story, self.trials, self.generations = pathlib.Path(folder), story, trials, generations
        self.walk_steps, self.sweep_trials = walk_steps, sweep_trials
        self.random = np.random.default_rng(seed)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.database = sqlite3.connect(self.folder / "study.db")
        self.database.executescript(STUDY_TABLES)
        self.database.execute("INSERT INTO parameters VALUES ('profile', 'paper', '')")
        self._main("evo")
        self._main("evo_devo")
        self._sweep()
        self._impact()
        self.database.commit()
        self.database.close()

    def _add_arm(self, arm, part, treatment, rate="self_adaptive"):
        self.database.execute(
            "INSERT INTO arms VALUES (?, ?, ?, 'paper', ?, 'afpo', ?, ?)",
            (arm, part, treatment, rate, self.trials, self.generations),
        )

    def _near(self, value, spread=0.02):
        return float(value + spread * self.random.standard_normal())

    def _main(self, treatment):
        story, arm = self.story, f"main/{treatment}"
        self._add_arm(arm, "main", treatment)
        experiment = Experiment(self.folder / arm, treatment, generations=self.generations)
        times = np.linspace(0, self.generations, POSITIONS).round().astype(int)
        devo = treatment == "evo_devo"
        fast_count = round(story["fast_devo" if devo else "fast_evo"] * self.trials / 30)
        for trial in range(1, self.trials + 1):
            fast = trial <= fast_count
            end = (
                self._near(story["fast_devo_fitness" if devo else "fast_evo_fitness"], 1.5)
                if fast
                else float(self.random.uniform(*story["slow"]))
            )
            reach = self.random.uniform(*story["reach_devo" if devo else "reach_evo"]) * self.generations / GENERATIONS
            fitness = [
                end * (0.9 + 0.1 * time / self.generations)
                if fast and time >= reach
                else min(end, 8.0) * (0.1 + 0.9 * time / self.generations)
                for time in times
            ]
            fitness[-1] = end
            body, control = self._windows(fast)
            champion = experiment.add_trial(trial, times, fitness, body if devo else None, control if devo else None)
            if devo:
                self._designs(experiment, trial, end)
            self.database.execute(
                "INSERT INTO champions VALUES (?, ?, ?, ?, ?)", (arm, trial, champion, self.generations, end)
            )
            self._analyses(arm, treatment, trial, champion, end, fast, body, control)
        experiment.close()

    def _windows(self, fast):
        story = self.story
        last = story["body_last"] if fast else story["slow_body_last"]
        peak = max(story["body_peak"], last) if fast else max(0.33, last)
        body = np.interp(np.arange(POSITIONS), [0, ROLLS_FROM, POSITIONS - 1], [0.33, peak, last])
        control = np.interp(np.arange(POSITIONS), [0, POSITIONS - 1], [0.33, story["control_last"]])
        noise = self.random.uniform(0.0, 0.01, (2, POSITIONS))
        return body + noise[0], control + noise[1]

    def _designs(self, experiment, trial, end):
        """Designs beside the lineage, the fastest with the story's windows."""
        for number in range(60):
            elite = number < 3
            experiment.add_robot(
                trial,
                1000 + number,
                None,
                0,
                None if number == 59 else end * 0.999 - number * 1e-3 if elite else -0.5 + number * 0.01,
                self._near(self.story["elite_body"] if elite else 0.35, 0.01),
                self._near(self.story["elite_control"] if elite else 0.36, 0.01),
            )
        # Born in generation 0, they would have been its champions: they are born in the last one instead.
        experiment.database.execute(
            "UPDATE individuals SET generation = ? WHERE trial = ? AND id >= 1000", (self.generations, trial)
        )

    def _analyses(self, arm, treatment, trial, champion, end, fast, body, control):
        story, devo = self.story, treatment == "evo_devo"
        kind = ("fast" if fast else "slow") if devo else "evo"
        if devo:
            self._insert(
                "champion_variants",
                (arm, trial, champion, "birth", "both"),
                end - story["removed_loss"] + self.random.uniform(-0.5, 0.5),
            )
            self._ancestors(arm, trial, champion, end, fast, body, control)
            self._neutral(arm, trial, champion)
        robots = [("champion", story["left"].__getitem__)]
        if devo:
            robots.append(("removed", lambda _: story["left_removed"]))
        for space in ("control", "body"):
            for robot, left in robots:
                self._walks((arm, trial, champion, space, robot), end, left((space, kind)))
        for robot, level in (("champion", end), ("frozen_at_birth", 0.8 * end)):
            velocities = level / 10.0 * (1.0 + 0.2 * np.sin(np.arange(20)))
            self._insert("champion_traces", (arm, trial, champion, robot, blob(velocities)), level)
        for quantity, values in {
            "none": [None],
            "friction": [0.5, 2.0],
            "gravity": [0.5, 2.0],
            "slope": [-0.1, 0.1],
            "actuation_amplitude": [0.5, 1.5],
        }.items():
            for value in values:
                share = 1.0 if value is None else self._near(story["robust"][treatment])
                self._insert(
                    "champion_robustness", (arm, trial, champion, f"{quantity}={value}", quantity, value), end * share
                )

    def _ancestors(self, arm, trial, champion, end, fast, body, control):
        story = self.story
        later = POSITIONS - 1 - ROLLS_FROM
        for position in range(POSITIONS):
            since = position - ROLLS_FROM
            rolls = fast and since >= 0
            time = np.interp(since, [0, later], [story["roll_first"], story["roll_last"]]) if rolls else None
            turns = 1.0 + 10.0 * since if rolls else 0.1
            fitness = 5.0 if since < 0 else 5.0 + story["one_roll"] + since * 0.1
            if position == POSITIONS - 1:
                fitness = end
            moved = (
                (None,) * 4
                if position == 0
                else (story["progenesis"] / later, story["neoteny"] / later, 0.0, self._near(0.0, 0.001))
            )
            self._insert(
                "champion_ancestors",
                (
                    arm,
                    trial,
                    champion,
                    position,
                    position,
                    position,
                    float(body[position]),
                    float(control[position]),
                    *moved,
                ),
                self._near(fitness, 0.01),
                None if time is None else self._near(time, 0.05),
                turns,
            )

    def _neutral(self, arm, trial, champion):
        for replicate in range(1, 31):
            noise = np.cumsum(self.random.normal(0.0, 0.004, (2, POSITIONS)), axis=1)
            noise[:, 0] = 0.0
            middle = np.interp(
                np.arange(POSITIONS), [0, POSITIONS // 2, POSITIONS - 1], [0.33, self.story["neutral_peak"], 0.42]
            )
            rising = np.interp(np.arange(POSITIONS), [0, POSITIONS - 1], [0.33, 0.44])
            self.database.execute(
                "INSERT INTO neutral_lineages VALUES (?, ?, ?, ?, ?, ?)",
                (arm, trial, champion, replicate, blob(middle + noise[0]), blob(rising + noise[1])),
            )

    def _walks(self, key, end, left):
        for walk in (1, 2, 3):
            for step in range(self.walk_steps + 1):
                share = 1.0 if step == 0 else max(0.0, self._near(left))
                self._insert("champion_walks", (*key, "redrawn_rates", walk, step, 0 if step == 0 else 24), end * share)

    def _sweep(self):
        story = self.story
        for rate in mutation_impact.LAMBDAS:
            for treatment in ("evo", "evo_devo"):
                arm = f"sweep/{treatment}-{round(48 * rate)}_48"
                self._add_arm(arm, "sweep", treatment, repr(rate))
                experiment = Experiment(self.folder / arm, treatment, generations=self.generations, mutation_rate=rate)
                level = "low" if rate <= 1 / 6 else "high"
                fast_count = story["sweep_fast"][level] if treatment == "evo_devo" else story["sweep_evo_fast"]
                if rate < 0.16:
                    fast_count = story["sweep_fast"]["low"]
                reach = (
                    story["sweep_1"][treatment == "evo_devo"]
                    if rate == 1.0
                    else story["sweep_evo" if treatment == "evo" else "sweep_devo"]
                )
                # At 1/6, one of the low rates, the claim about time needs fast trials.
                if abs(rate - 1 / 6) < 1e-9:
                    fast_count = 28
                times = np.unique(np.linspace(0, self.generations, 101).round().astype(int))
                for trial in range(1, self.sweep_trials + 1):
                    fast = trial <= fast_count * self.sweep_trials / 30
                    high = story["sweep_fitness_evo_1"] if (treatment, rate) == ("evo", 1.0) else 60.0
                    end = self._near(high, 1.0) if fast else float(self.random.uniform(*story["sweep_slow"][level]))
                    when = self.random.uniform(*reach) * self.generations / GENERATIONS
                    experiment.add_trial(
                        trial, times, [end if (time >= when or time == times[-1]) else min(end, 3.0) for time in times]
                    )
                experiment.close()

    def _impact(self):
        for traits, treatment in ((2, "evo"), (4, "evo_devo")):
            for rate in mutation_impact.LAMBDAS:
                factor = self.story["impact"] if rate < 1.0 else 1.0
                self.database.execute(
                    "INSERT INTO mutational_impact VALUES (?, 'paper', ?, ?, 100000, ?, ?, ?, ?)",
                    (
                        treatment,
                        traits,
                        rate,
                        factor * float(mutation_impact.changed_voxels(traits, rate)),
                        2.0,
                        factor * float(mutation_impact.changed_genes(traits, rate)),
                        3.0,
                    ),
                )

    def _insert(self, table, key, fitness, fell_over=None, turns=0.0):
        values = (
            *key,
            1,
            float(fitness),
            4.0 * float(fitness),
            4.0 * abs(float(fitness)),
            fell_over,
            fell_over,
            float(turns),
            0.1,
        )
        self.database.execute(f"INSERT INTO {table} VALUES ({', '.join('?' * len(values))})", values)
