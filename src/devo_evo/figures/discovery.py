"""Fig. 6: when in life the ancestors of rolling run champions began to roll."""

import numpy as np
import pandas as pd

from ..statistics import median_curve, median_interval
from . import style

TITLE = "Late onset discoveries (Fig. 6)"
FAST = 30.0  # [body lengths]
# How rolling over is told; the first is the released code's.
MEASURES = {
    "fell_over": "fell_over_since_birth_s",
    "first_top_contact": "first_top_contact_since_birth_s",
    "turns": None,
}


def onset(ancestors, lifetime, measure="fell_over"):
    """Time before rolling [s] of each row; the lifetime if it never happened.

    `turns`: the whole life of a robot that makes less than one turn, and else the first lifetime / turns of it, as if
    it had turned evenly.
    """
    if measure == "turns":
        turns = np.maximum(np.abs(ancestors["turns"].astype(float)), 1.0)
        return lifetime / turns
    return ancestors[MEASURES[measure]].astype(float).fillna(lifetime).clip(upper=lifetime)


def lineages(study, measure="fell_over"):
    """Ancestors of fast Evo-Devo run champions: trial, position, x (0: the first ancestor that rolls), time [s]."""
    frame = study.ancestors()
    frame = frame[(frame["part"] == "main") & (frame["treatment"] == "evo_devo")].sort_values(["trial", "position"])
    archive = study.main("evo_devo")
    if frame.empty or archive is None:
        return pd.DataFrame(columns=["trial", "position", "x", "time"])
    frame = frame[frame["trial"].isin(archive.horizon().trials)]
    champions = frame.groupby("trial").tail(1).set_index("trial")["fitness"]
    frame = frame[frame["trial"].map(champions >= FAST)].copy()
    lifetime = float(archive.parameters["lifetime"])
    frame["time"] = onset(frame, lifetime, measure)
    rolling = frame[frame["time"] < lifetime].groupby("trial")["position"].min()
    frame = frame[frame["trial"].isin(rolling.index)]
    frame["x"] = frame["position"] - frame["trial"].map(rolling)
    return frame[["trial", "position", "x", "time"]]


def first_and_champion(frame):
    """Times [s] of the first ancestor that rolls and of the run champion: a frame indexed by trial."""
    return pd.DataFrame(
        {
            "first": frame[frame["x"] == 0].set_index("trial")["time"],
            "champion": frame.groupby("trial").tail(1).set_index("trial")["time"],
        }
    )


def numbers(study):
    """Panel A: x (descendants after the first ancestor that rolls), median, low, high [s], lineages (never padded).
    Panel B: series `first`, `champion`."""
    frames = []
    for measure in MEASURES:
        frame = lineages(study, measure)
        if frame.empty:
            continue
        table = frame.pivot(index="trial", columns="x", values="time")
        table = table[[x for x in table.columns if x >= 0]]
        median, low, high = median_curve(table.to_numpy())
        frames.append(
            pd.DataFrame(
                {
                    "panel": "A",
                    "measure": measure,
                    "series": "lineages",
                    "x": table.columns,
                    "median": median,
                    "low": low,
                    "high": high,
                    "lineages": table.count().to_numpy(),
                }
            )
        )
        for series, values in first_and_champion(frame).items():
            interval = median_interval(values, resamples=1000)
            frames.append(
                pd.DataFrame(
                    [
                        {
                            "panel": "B",
                            "measure": measure,
                            "series": series,
                            "median": interval.estimate,
                            "low": interval.low,
                            "high": interval.high,
                            "lineages": len(values),
                        }
                    ]
                )
            )
    columns = ["panel", "measure", "series", "x", "median", "low", "high", "lineages"]
    return pd.concat(frames, ignore_index=True)[columns] if frames else pd.DataFrame(columns=columns)


def draw(study):
    """The figure."""
    table = numbers(study)
    figure, axes = style.new_figure(12, 4.4, 1, 2, gridspec_kw={"width_ratios": [1.7, 1], "wspace": 0.36})
    curves, bars = axes[0]
    archive = study.main("evo_devo")
    lifetime = float(archive.parameters["lifetime"]) if archive is not None else 10.0
    rows = table[(table["panel"] == "A") & (table["measure"] == "fell_over")]
    if rows.empty:
        style.no_data(curves, "no Evo-Devo run champion of at least 30 body lengths has an ancestor that rolled over")
    else:
        style.band(curves, rows, style.ORANGE, "more of the top than of the rest touches the floor")
        for measure, line, label in (
            ("first_top_contact", ":", "first touch of the top"),
            ("turns", "-.", "first turn, if turning evenly"),
        ):
            others = table[(table["panel"] == "A") & (table["measure"] == measure)]
            curves.plot(others["x"], others["median"], color="0.45", linestyle=line, label=label)
        curves.legend(loc="upper right", fontsize=10)
        counts = curves.twinx()
        counts.plot(rows["x"], rows["lineages"], color="0.7", linewidth=1, drawstyle="steps-mid")
        counts.set_ylabel("lineages (n)", color="0.6", fontsize=10)
        counts.set_ylim(0, max(rows["lineages"]) * 4)
        counts.tick_params(colors="0.6", labelsize=8)
        counts.yaxis.get_major_locator().set_params(integer=True, nbins=5)
        counts.spines["right"].set_visible(True)
    curves.xaxis.get_major_locator().set_params(integer=True)
    curves.set_xlabel("Descendant, from the first ancestor that rolls")
    for place, (series, label) in enumerate((("first", "First to roll"), ("champion", "Run champion"))):
        row = table[(table["panel"] == "B") & (table["measure"] == "fell_over") & (table["series"] == series)]
        if len(row):
            row = row.iloc[0]
            bars.bar(place, row["median"], 0.65, color=style.BAR_COLOURS[place + 1])
            bars.errorbar(
                place,
                row["median"],
                color=style.ERROR_BAR,
                capsize=6,
                linewidth=2,
                yerr=[[row["median"] - row["low"]], [row["high"] - row["median"]]],
            )
    if not (table["panel"] == "B").any():
        style.no_data(bars, "no data")
    bars.set_xticks([0, 1], ["First to roll", "Run champion"])
    bars.set_xlim(-0.6, 1.6)
    for letter, panel in zip("AB", (curves, bars)):
        panel.set_ylim(-0.025 * lifetime, 1.025 * lifetime)
        panel.set_ylabel("Time before rolling [s]")
        style.panel_letter(panel, letter)
    notes = study.notes("evo_devo")
    notes.append(
        "Lineages of Evo-Devo run champions of at least 30 body lengths, aligned at the first ancestor that rolls; "
        "n falls where shorter lineages have ended. Medians with 95 % percentile bootstrap intervals."
    )
    style.caption(figure, TITLE, notes)
    return style.Drawing("fig6", TITLE, figure, table, notes)
