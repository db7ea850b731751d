"""Robots simulated from Python.

The tool simulates them (`devo_evo evaluate`, JSON lines in and out) on all cores. JSON numbers are written with as many
digits as it takes to read the same number back on both sides, so results are those of the archive to the last bit. One
process does thousands of robots, against whose simulation its start counts for nothing; and no extension module has to
match this Python.
"""

import dataclasses
import json

import pandas as pd

from . import columns
from .columns import MEASURES, RIGID_MEASURES
from .errors import InvalidInput
from .genomes import RigidGenome
from .tool import run_tool

BODY_PARAMETERS = (
    "grid",
    "lifetime",
    "voxel_size",
    "density",
    "youngs_modulus",
    "poissons_ratio",
    "static_friction",
    "dynamic_friction",
    "gravity",
    "bond_damping",
    "contact_damping",
    "global_damping",
    "time_step_fraction",
    "actuation_frequency",
    "actuation_amplitude",
    "self_collision",
    "sideways_bend_test",
)

UNITS = {"velocity_body_lengths_per_s": "body lengths/s", **columns.UNITS}


def evaluate(genomes, parameters=None, threads=None):
    """Simulates robots. Returns a frame with one row for each, in their order: the measures of docs/tool.md.

    genomes: of `Genome`, or all of `RigidGenome`.
    parameters: of body and physics by name (docs/parameters.md), as in `Archive.parameters`; others are let pass.
    threads: of the tool; None: one a core.
    """
    genomes = list(genomes)
    rigid = any(isinstance(genome, RigidGenome) for genome in genomes)
    measures = RIGID_MEASURES if rigid else MEASURES
    units = {**UNITS, **columns.RIGID_UNITS} if rigid else UNITS
    lines = [json.dumps({"id": number, **_arrays(genome)}) for number, genome in enumerate(genomes)]
    options = ["--body", "rigid"] if rigid else []
    for name, value in (parameters or {}).items():
        if name.startswith("rigid_") and name != "rigid_mutation_sigma" if rigid else name in BODY_PARAMETERS:
            options += [f"--{name}", _as_text(value)]
    if threads is not None:
        options += ["--threads", str(threads)]
    if not genomes:
        return pd.DataFrame(columns=["valid", *MEASURES, "velocity_body_lengths_per_s", "state_hash"])
    results = [json.loads(line) for line in run_tool(["evaluate", "-", *options], "\n".join(lines) + "\n").splitlines()]
    if len(results) != len(genomes):
        raise InvalidInput(f"{len(results)} evaluations came back for {len(genomes)} robots")
    frame = pd.DataFrame(results).drop(columns=["id", "verdict"], errors="ignore")
    for column in measures:
        frame[column] = frame[column].astype(float)
    frame.attrs["units"] = {column: units[column] for column in frame}
    return frame


def evaluate_individuals(archive, robots, threads=None, **changes):
    """Simulates individuals of an archive again, under its own parameters but for `changes`, such as gravity=3.7.

    robots: pairs of trial and id. Returns a frame as `evaluate`, indexed by trial and id.
    """
    robots = [(int(trial), int(number)) for trial, number in robots]
    frame = evaluate(archive.genomes(robots), {**archive.parameters, **changes}, threads)
    frame.index = pd.MultiIndex.from_tuples(robots, names=["trial", "id"])
    return frame


def _arrays(genome):
    """The arrays of a genome as the tool reads them."""
    if isinstance(genome, RigidGenome):
        return {field.name: getattr(genome, field.name).tolist() for field in dataclasses.fields(genome)}
    return {
        "size_gene_initial": genome.size_gene_initial.tolist(),
        "size_gene_final": genome.size_gene_final.tolist(),
        "phase_initial_cycles": genome.phase_initial.tolist(),
        "phase_final_cycles": genome.phase_final.tolist(),
    }


def _as_text(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    return value if isinstance(value, str) else repr(value)
