"""Genomes as NumPy arrays, and the developmental windows of the paper (Methods, "Developmental windows")."""

import dataclasses
from typing import Optional

import numpy as np

from .errors import InvalidInput

PHASE_LIMIT = {"paper": 0.25, "released_code": 1.0}  # by profile [cycles]


@dataclasses.dataclass(frozen=True)
class Genome:
    """What is inherited: one number per voxel in each array, voxel (x, y, z) at x + grid_x (y + grid_y z).

    size_gene_initial, size_gene_final: size genes at birth and at the end of life [1, -1 to 1]
    phase_initial, phase_final: phases of actuation [cycles]
    mutation_rate: where rates evolve [1, 0 to 1]; else None
    """

    size_gene_initial: np.ndarray
    size_gene_final: np.ndarray
    phase_initial: np.ndarray
    phase_final: np.ndarray
    mutation_rate: Optional[np.ndarray] = None

    def __post_init__(self):
        shape = np.shape(self.size_gene_initial)
        for field in dataclasses.fields(self):
            values = getattr(self, field.name)
            if values is None and field.name == "mutation_rate":
                continue
            array = np.array(values, dtype=np.float64)
            if array.ndim != 1 or array.shape != shape:
                raise InvalidInput(f"{field.name} has the shape {array.shape}; it must be {shape}, one number a voxel")
            array.setflags(write=False)
            object.__setattr__(self, field.name, array)

    def morphology_window(self):
        """W_L: share of all possible change of size that the robot uses [1, 0 to 1] (paper, Eq. 5)."""
        return _window(self.size_gene_initial, self.size_gene_final, 1.0)

    def control_window(self, profile="paper"):
        """W_Phi: share of all possible change of phase that the robot uses [1, 0 to 1] (paper, Eq. 6)."""
        return _window(self.phase_initial, self.phase_final, PHASE_LIMIT[profile])

    def without_development(self, body=True, control=True, stage=0.0):
        """The same robot frozen as it is at `stage` of its life (0: birth, 1: death), in body, control or both."""
        size, phase = self.at(stage)
        changes = {}
        if body:
            changes.update(size_gene_initial=size, size_gene_final=size)
        if control:
            changes.update(phase_initial=phase, phase_final=phase)
        return dataclasses.replace(self, **changes)

    def at(self, stage):
        """Size genes [1] and phases [cycles] at `stage` of life, 0 (birth) to 1 (death): both develop linearly."""
        if not 0.0 <= stage <= 1.0:
            raise InvalidInput(f"stage is {stage}; it must lie within 0 (birth) to 1 (death)")
        if stage == 1.0:
            return self.size_gene_final, self.phase_final
        return (
            self.size_gene_initial + stage * (self.size_gene_final - self.size_gene_initial),
            self.phase_initial + stage * (self.phase_final - self.phase_initial),
        )


@dataclasses.dataclass(frozen=True)
class RigidGenome:
    """What a rigid quadruped inherits.

    leg_length_initial, leg_length_final: one number per leg, front left, front right, hind left, hind right [1, 0 to 1]
    weight_initial, weight_final: of generator g to leg l at 2 l + g [1, -1 to 1]
    """

    leg_length_initial: np.ndarray
    leg_length_final: np.ndarray
    weight_initial: np.ndarray
    weight_final: np.ndarray

    def __post_init__(self):
        for field in dataclasses.fields(self):
            array = np.array(getattr(self, field.name), dtype=np.float64)
            shape = (4,) if field.name.startswith("leg") else (8,)
            if array.shape != shape:
                raise InvalidInput(f"{field.name} has the shape {array.shape}; it must be {shape}")
            array.setflags(write=False)
            object.__setattr__(self, field.name, array)

    def morphology_window(self):
        """W_L: share of all possible change of leg length that the robot uses [1, 0 to 1]."""
        return _window(self.leg_length_initial, self.leg_length_final, 0.5)

    def control_window(self):
        """W_Phi: share of all possible change of weights that the robot uses [1, 0 to 1]."""
        return _window(self.weight_initial, self.weight_final, 1.0)


def _window(initial, final, limit):
    return float(np.mean(np.abs(final - initial)) / (2.0 * limit))
