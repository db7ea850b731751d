"""How much a mutation changes, at a fixed mutation rate lambda: the paper's Supplementary Methods and Fig. S4.

n traits are each selected with probability p = 1/n. If none is, the profile `paper` picks one, and `released_code`
draws again until one is (a zero-truncated binomial). In a selected trait, each of K voxels mutates with probability
lambda. docs/statistics.md derives the formulas.
"""

import math

import numpy as np

VOXELS = 48  # K
LAMBDAS = tuple(k / 48 for k in (1, 2, 4, 8, 16, 24, 32, 48))


def selected_traits(n, profile="paper"):
    """P(S = s) of the number S of selected traits, s from 0 to n."""
    p = 1.0 / n
    chances = np.array([math.comb(n, s) * p**s * (1.0 - p) ** (n - s) for s in range(n + 1)])
    if profile == "paper":
        chances[1] += chances[0]
    else:
        chances /= 1.0 - chances[0]
    chances[0] = 0.0
    return chances


def expected_traits(n, profile="paper"):
    """E(S): 1 + (1 - p)^n, or 1 / (1 - (1 - p)^n)."""
    none = (1.0 - 1.0 / n) ** n
    return 1.0 + none if profile == "paper" else 1.0 / (1.0 - none)


def changed_genes(n, rate, profile="paper", voxels=VOXELS):
    """delta_gene: expected number of changed numbers in the genome, lambda K E(S)."""
    return rate * voxels * expected_traits(n, profile)


def changed_gene_share(n, rate, profile="paper"):
    """pi_gene: expected share of the genome's numbers that change, lambda E(S) / n."""
    return rate * expected_traits(n, profile) / n


def changed_voxel_share(n, rate, profile="paper"):
    """pi_vox: expected share of voxels that change in any trait."""
    rate = np.asarray(rate, dtype=float)
    none = (1.0 - 1.0 / n) ** n
    unchanged = (1.0 - rate / n) ** n  # E[(1 - lambda)^S], before anything is done about S = 0
    if profile == "paper":
        return 1.0 - unchanged + rate * none
    if n == 1:
        return rate + 0.0
    return 1.0 - (unchanged - none) / (1.0 - none)


def changed_voxels(n, rate, profile="paper", voxels=VOXELS):
    """delta_vox: expected number of changed voxels."""
    return voxels * changed_voxel_share(n, rate, profile)


def limiting_voxel_share(rate, profile="paper"):
    """pi_vox for ever more traits."""
    rate = np.asarray(rate, dtype=float)
    if profile == "paper":
        return 1.0 - np.exp(-rate) + rate / math.e
    return 1.0 - (np.exp(-rate) - 1.0 / math.e) / (1.0 - 1.0 / math.e)
