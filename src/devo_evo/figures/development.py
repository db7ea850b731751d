"""Fig. S2: what develops in the two treatments (a schematic), and how fast robots are over their life."""

import numpy as np
import pandas as pd

from . import style

TITLE = "Development and velocity over life (Fig. S2)"
WINDOW_S = 0.5  # velocities are means over this time [s]
CYCLES_HZ = 1.4  # of the schematic, slowed down so that cycles can be seen
SCHEMATIC = ("Global temperature", "Phase offset", "Resting length", "Current length")
FAST = 30.0  # [body lengths]


def schematic(treatment, time):
    """The four upper rows, in arbitrary units, over `time` in shares of a life."""
    develops = treatment == "evo_devo"
    wave = 2.0 * np.pi * CYCLES_HZ * 10.0 * time
    resting = 2.0 + (5.0 * time if develops else 0.0 * time)
    shift = np.pi / 2.0 - (np.pi * time if develops else 0.0 * time)
    return {
        "Global temperature": 5.0 + 0.5 * np.sin(wave),
        "Phase offset": 7.0 - (5.0 * time if develops else 0.0 * time),
        "Resting length": resting,
        "Current length": resting + 0.5 * np.sin(wave + shift),
    }


def chosen(traces, treatment):
    """Trials whose velocity is drawn, fixed before any data: the median fast run champion and the median slow one."""
    champions = traces[
        (traces["treatment"] == treatment) & (traces["robot"] == "champion") & (traces["part"] == "main")
    ].dropna(subset=["velocities"])
    result = {}
    for kind, rows in (
        ("fast", champions[champions["fitness"] >= FAST]),
        ("slow", champions[champions["fitness"] < FAST]),
    ):
        if len(rows):
            result[kind] = int(rows.sort_values(["fitness", "trial"])["trial"].iloc[(len(rows) - 1) // 2])
    return result


def numbers(study):
    """Schematic rows (row, treatment, x in shares of life, y) and velocities (x [s], y [body lengths/s])."""
    time = np.linspace(0.0, 1.0, 401)
    frames = [
        pd.DataFrame({"row": row, "treatment": treatment, "series": "schematic", "x": time, "y": values})
        for treatment in ("evo", "evo_devo")
        for row, values in schematic(treatment, time).items()
    ]
    traces = study.traces()
    for treatment in ("evo", "evo_devo"):
        for kind, trial in chosen(traces, treatment).items():
            for robot in ("champion", "frozen_at_birth"):
                rows = traces[
                    (traces["treatment"] == treatment)
                    & (traces["trial"] == trial)
                    & (traces["robot"] == robot)
                    & (traces["part"] == "main")
                ]
                velocities = rows["velocities"].dropna()
                if len(velocities) and not (treatment == "evo" and robot == "frozen_at_birth"):
                    values = velocities.iloc[0]
                    frames.append(
                        pd.DataFrame(
                            {
                                "row": "Velocity",
                                "treatment": treatment,
                                "series": f"{kind} {robot}",
                                "trial": trial,
                                "x": WINDOW_S * (np.arange(len(values)) + 0.5),
                                "y": values,
                            }
                        )
                    )
    return pd.concat(frames, ignore_index=True)


def draw(study):
    """The figure."""
    table = numbers(study)
    figure, axes = style.new_figure(9, 12.5, 5, 2, gridspec_kw={"hspace": 0.28, "wspace": 0.18})
    velocities = table[table["row"] == "Velocity"]
    highest = float(velocities["y"].max()) if len(velocities) else 1.0
    lowest = float(velocities["y"].min()) if len(velocities) else 0.0
    for column, (treatment, colour) in enumerate((("evo", style.GREEN), ("evo_devo", style.ORANGE))):
        for row, name in enumerate(SCHEMATIC):
            axis = axes[row, column]
            part = table[(table["row"] == name) & (table["treatment"] == treatment)]
            axis.plot(part["x"], part["y"], color=colour, linewidth=2)
            axis.set_ylim(0, 10)
            axis.set_xlim(0, 1.05)
            axis.set_xticks([])
            axis.set_yticks(*_ticks(name, treatment))
            axis.text(1.06, 0, "t", fontsize=12)
        _draw_velocities(axes[4, column], velocities[velocities["treatment"] == treatment], colour)
        axes[4, column].set_ylim(min(0.0, 1.1 * lowest), max(1.2, 1.15 * highest))
        axes[4, column].set_xlabel("Lifetime [s]")
        axes[0, column].set_title(style.TREATMENT_LABEL[treatment], fontsize=15)
    for row, name in enumerate((*SCHEMATIC, "Velocity\n[body lengths/s]")):
        axes[row, 0].set_ylabel(name, fontsize=12)
    for letter, axis in zip("ABCDEFGHIJ", axes.T.flat):
        axis.text(0.02, 1.02, letter, transform=axis.transAxes, fontsize=16, family="DejaVu Sans")
    notes = study.notes("evo", "evo_devo")
    notes.append(
        f"Rows 1 to 4: schematic, actuation slowed down to {CYCLES_HZ} Hz. Velocity: displacement along +y over "
        f"{WINDOW_S} s of the median fast run champion (at least 30 body lengths) and of the median slow one (\u2217); "
        "dotted: the same robot frozen at birth."
    )
    style.caption(figure, TITLE, notes)
    return style.Drawing("figS2", TITLE, figure, table, notes)


def _ticks(name, treatment):
    if name == "Phase offset":
        return ([7], [r"$\phi_k$"]) if treatment == "evo" else ([7, 2], [r"$\phi_k$", r"$\phi^*_k$"])
    if name in ("Resting length", "Current length"):
        return ([2], [r"$\ell_k$"]) if treatment == "evo" else ([2, 7], [r"$\ell_k$", r"$\ell^*_k$"])
    return ([], [])


def _draw_velocities(axes, rows, colour):
    if rows.empty:
        style.no_data(axes, "no velocity traces")
        axes.set_xticks([])
        axes.set_yticks([])
        return
    axes.axhline(1.0, color=style.GREY, linestyle="--", linewidth=1)
    for series, part in rows.groupby("series", sort=True):
        kind, robot = series.split(" ", 1)
        axes.plot(
            part["x"],
            part["y"],
            color=colour,
            linewidth=2.2 if kind == "fast" else 1.4,
            linestyle="-" if robot == "champion" else ":",
            marker="o" if len(part) == 1 else None,
        )
        if robot == "champion":
            label = f"run {int(part['trial'].iloc[0])}" + ("" if kind == "fast" else "\u2217")
            axes.annotate(
                label, (part["x"].iloc[-1], part["y"].iloc[-1]), fontsize=9, xytext=(2, 3), textcoords="offset points"
            )
    axes.set_xlim(0, 1.12 * float(rows["x"].max()))
