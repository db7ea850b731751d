"""Fig. S4: expected share of voxels that a mutation changes, by formula and counted on our own operator."""

import numpy as np
import pandas as pd

from .. import mutation_impact
from . import style

TITLE = "Mutational impact (Fig. S4)"
TRAITS = (1, 2, 4, 8)
COLOURS = (style.GREY, style.GREEN, style.ORANGE, style.BLUE)


def numbers(study):
    """Curves (profile, traits; 0: ever more, x: lambda, y: pi_vox) and counted points with their standard errors."""
    rates = np.linspace(0.0, 1.0, 97)
    profiles = [study.profile] if study.profile in ("paper", "released_code") else ["paper"]
    frames = []
    for profile in profiles:
        for n in TRAITS:
            frames.append(
                pd.DataFrame(
                    {
                        "series": "formula",
                        "profile": profile,
                        "traits": n,
                        "x": rates,
                        "y": mutation_impact.changed_voxel_share(n, rates, profile),
                    }
                )
            )
        frames.append(
            pd.DataFrame(
                {
                    "series": "formula",
                    "profile": profile,
                    "traits": 0,
                    "x": rates,
                    "y": mutation_impact.limiting_voxel_share(rates, profile),
                }
            )
        )
    counted = study.mutational_impact()
    counted = counted[counted["profile"].isin(profiles)]
    if len(counted):
        frames.append(
            pd.DataFrame(
                {
                    "series": "counted",
                    "profile": counted["profile"],
                    "traits": counted["traits"],
                    "x": counted["mutation_rate"],
                    "y": counted["voxels_changed_mean"] / mutation_impact.VOXELS,
                    "standard_error": counted["voxels_changed_sd"]
                    / np.sqrt(counted["reproductions"])
                    / mutation_impact.VOXELS,
                    "reproductions": counted["reproductions"],
                }
            )
        )
    return pd.concat(frames, ignore_index=True)


def draw(study):
    """The figure."""
    table = numbers(study)
    figure, axes = style.new_figure(7.5, 6)
    axis = axes[0, 0]
    for n, colour in zip((*TRAITS, 0), (*COLOURS, "0.2")):
        rows = table[(table["series"] == "formula") & (table["traits"] == n)]
        axis.plot(
            rows["x"],
            rows["y"],
            color=colour,
            linewidth=2,
            linestyle="--" if n == 0 else "-",
            label=r"$n\rightarrow\infty$" if n == 0 else f"n = {n}" + {2: " (Evo)", 4: " (Evo-Devo)"}.get(n, ""),
        )
    points = table[table["series"] == "counted"]
    for n, colour in zip(TRAITS, COLOURS):
        rows = points[points["traits"] == n]
        if len(rows):
            axis.errorbar(
                rows["x"],
                rows["y"],
                yerr=1.96 * rows["standard_error"],
                color=colour,
                fmt="o",
                markersize=6,
                markeredgecolor="0.2",
                capsize=3,
            )
    axis.set_xlabel(r"Mutation rate $\lambda$")
    axis.set_ylabel(r"Expected share of voxels mutated $\pi_{vox}$")
    axis.set_xlim(0, 1.02)
    axis.set_ylim(0, 1.02)
    axis.legend(loc="upper left")
    notes = [f"Profile {study.profile}. Lines: formula (docs/statistics.md), no trials needed."]
    if len(points):
        notes.append(
            f"Points: counted over {int(points['reproductions'].iloc[0])} reproductions each by the operator that "
            "evolution uses, with 95 % intervals."
        )
    else:
        notes.append("No reproductions were counted: run the study's part `impact`.")
    style.caption(figure, TITLE, notes)
    return style.Drawing("figS4", TITLE, figure, table, notes)
