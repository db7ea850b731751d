"""Claims about what mutation changes: Fig. S4 and the tables of the Supplementary Methods."""

import numpy as np
from scipy import stats

from .. import mutation_impact as impact
from .base import Claim, Outcome, missing

FAMILY = "impact"
# As printed, for n = 2 and n = 4 at the eight rates of the sweep [voxels].
PAPER_TABLE = {
    2: (1.25, 2.48, 4.92, 9.67, 18.67, 27.0, 34.67, 48.0),
    4: (1.3, 2.6, 5.14, 10.05, 19.17, 27.46, 34.98, 48.0),
}
DIGITS = {2: (2, 2, 2, 2, 2, 0, 2, 0), 4: (1, 1, 2, 2, 2, 2, 2, 0)}
LEVEL = 0.001  # of the whole comparison of counts with the formula


def _voxel_table(_):
    wrong = [
        (n, rate)
        for n in PAPER_TABLE
        for rate, printed, digits in zip(impact.LAMBDAS, PAPER_TABLE[n], DIGITS[n])
        if abs(float(impact.changed_voxels(n, rate)) - printed) > 0.5 * 10.0**-digits + 0.005
    ]
    values = ", ".join(f"{float(impact.changed_voxels(4, rate)):.2f}" for rate in impact.LAMBDAS)
    return Outcome(
        ours=f"n = 4: {values}; {16 - len(wrong)} of 16 entries agree as printed",
        supported=not wrong,
        refuted=bool(wrong),
        trials=16,
        generations=0,
    )


def _gene_numbers(_):
    two, four = impact.changed_genes(2, 1.0), impact.changed_genes(4, 1.0)
    shares = impact.changed_gene_share(2, 1.0), impact.changed_gene_share(4, 1.0)
    agrees = two == 60.0 and abs(shares[0] - 0.625) < 1e-12 and abs(shares[1] - 0.3291) < 5e-5 and four == 63.1875
    return Outcome(
        ours=f"{two:g} λ, {four:g} λ; {shares[0]:g} λ, {shares[1]:.4f} λ (63.8175 is a misprint: it contradicts "
        "0.3291)",
        supported=agrees,
        refuted=not agrees,
        trials=4,
        generations=0,
    )


def deviations(counted):
    """How far counts lie from the formula, in standard errors: a frame with z_voxels and z_genes."""
    rows = counted.copy()
    errors = np.sqrt(rows["reproductions"].astype(float))
    for kind, formula in (("voxels", impact.changed_voxels), ("genes", impact.changed_genes)):
        expected = np.array(
            [float(formula(int(row.traits), float(row.mutation_rate), row.profile)) for row in rows.itertuples()]
        )
        difference = rows[f"{kind}_changed_mean"].to_numpy(dtype=float) - expected
        error = rows[f"{kind}_changed_sd"].to_numpy(dtype=float) / errors
        exact = (error == 0) & (abs(difference) < 1e-9)
        rows[f"z_{kind}"] = np.where(exact, 0.0, difference / np.where(error > 0, error, 1e-300))
    return rows


def _operator(study):
    counted = study.mutational_impact()
    counted = counted[(counted["mutation_rate"] < 1.0 + 1e-12)] if len(counted) else counted
    if counted.empty:
        return missing("reproductions counted on the operator")
    z = deviations(counted)[["z_voxels", "z_genes"]].to_numpy().ravel()
    p = min(1.0, len(z) * 2.0 * float(stats.norm.sf(np.max(np.abs(z)))))
    agrees = p > LEVEL
    return Outcome(
        ours=f"{len(z)} means over {int(counted['reproductions'].iloc[0])} reproductions, the farthest "
        f"{np.max(np.abs(z)):.1f} standard errors from its formula (Bonferroni p = {p:.2g})",
        supported=agrees,
        refuted=not agrees,
        trials=len(z),
        generations=0,
    )


CLAIMS = [
    Claim(
        "impact-voxels",
        FAMILY,
        "Mutations of Evo and Evo-Devo change about as many voxels.",
        "S4, Suppl. table",
        "1.25 … 48 (n = 2), 1.3 … 48 (n = 4)",
        "does not depend on trials",
        "δ_vox by formula, profile paper",
        "exact, as printed",
        _voxel_table,
        generations=0,
    ),
    Claim(
        "impact-genes",
        FAMILY,
        "Expected number and share of changed genes.",
        "Suppl. Methods",
        "60 λ, 63.8175 λ; 0.625 λ, 0.3291 λ",
        "does not depend on trials",
        "δ_gene and π_gene by formula, profile paper",
        "exact",
        _gene_numbers,
        generations=0,
    ),
    Claim(
        "impact-operator",
        FAMILY,
        "Our operator changes as much as the formulas say.",
        "S4",
        "by derivation",
        "does not depend on trials",
        "mean voxels and genes changed over many reproductions",
        f"z-tests against the formula; agreement unless Bonferroni p is below {LEVEL:g}",
        _operator,
        generations=0,
    ),
]
