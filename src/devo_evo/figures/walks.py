"""Fig. 5: what is left of run champions after ever more random mutations of their control or their body."""

from matplotlib import ticker
import numpy as np
import pandas as pd

from ..statistics import clustered_median_curve
from . import style

TITLE = "Sensitivity to morphological and control mutations (Fig. 5)"
FAST = 30.0  # [body lengths]
LEVEL = 0.99  # of the bands, as in the paper
POINTS = 120  # of a curve, evenly spread over the logarithm of the steps
OPERATOR = "redrawn_rates"  # the paper's walks
# Panel: space; then series: which champions, label, colour.
BOTH = (("evo", "Evo", style.GREEN), ("evo_devo", "Evo-Devo", style.ORANGE))
SPLIT = (("fast", "Evo-Devo Fast", style.PINK), ("slow", "Evo-Devo Slow", style.LIME))
PANELS = {"A": ("control", BOTH), "B": ("control", SPLIT), "C": ("body", BOTH), "D": ("body", SPLIT)}
X_LABEL = {"control": "Random steps in control space", "body": "Random steps in morpho space"}


def usable(study):
    """Walks of the paper's kind from run champions of the main experiment that move forwards."""
    walks = study.walks()
    return walks[
        (walks["part"] == "main")
        & (walks["robot"] == "champion")
        & (walks["operator"] == OPERATOR)
        & (walks["start"] > 0)
    ]


def select(walks, space, series):
    """The walks of one series of a panel."""
    rows = walks[walks["space"] == space]
    if series in ("evo", "evo_devo"):
        return rows[rows["treatment"] == series]
    rows = rows[rows["treatment"] == "evo_devo"]
    return rows[rows["start"] >= FAST] if series == "fast" else rows[rows["start"] < FAST]


def curve(walks):
    """Median relative fitness of each step over all walks, with its band over champions, as far as all walks go; a step
    that failed counts as 0.

    Returns a frame: x (step), median, low, high, champions, walks.
    """
    relative = walks["relative"].astype(float).fillna(0.0)
    table = walks.assign(relative=relative).pivot(index=["trial", "walk"], columns="step", values="relative")
    table = table.dropna(axis="columns")
    steps = table.columns.to_numpy()
    shown = steps[np.unique(np.round(np.geomspace(1, len(steps), POINTS)).astype(int) - 1)]
    trials = table.index.get_level_values("trial").to_numpy()
    median, low, high = clustered_median_curve(table[shown].to_numpy(), trials, LEVEL, resamples=2000)
    return pd.DataFrame(
        {
            "x": shown,
            "median": median,
            "low": low,
            "high": high,
            "champions": len(np.unique(trials)),
            "walks": len(table),
        }
    )


def numbers(study):
    """All panels: panel, space, series, x (step), median, low, high (relative fitness [1]), champions, walks."""
    walks = usable(study)
    frames = [
        curve(rows).assign(panel=panel, space=space, series=series)
        for panel, (space, parts) in PANELS.items()
        for series, _, _ in parts
        for rows in [select(walks, space, series)]
        if len(rows)
    ]
    columns = ["panel", "space", "series", "x", "median", "low", "high", "champions", "walks"]
    return pd.concat(frames, ignore_index=True)[columns] if frames else pd.DataFrame(columns=columns)


def draw(study):
    """The figure."""
    table = numbers(study)
    figure, axes = style.new_figure(14, 8, 2, 2, gridspec_kw={"wspace": 0.2, "hspace": 0.32})
    last = table["x"].max() if len(table) else 1000
    for axis, (panel, (space, parts)) in zip(axes.flat, PANELS.items()):
        missing = []
        for series, label, colour in parts:
            rows = table[(table["panel"] == panel) & (table["series"] == series)]
            if rows.empty:
                missing.append(label)
                continue
            shifted = rows.assign(x=rows["x"] + 1.05)  # so that step 0 has a place on a logarithmic axis
            style.band(axis, shifted, colour, f"{label} (n = {rows['champions'].iloc[0]})")
        axis.set_xscale("log")
        axis.set_xlim(1, last + 1.05)
        axis.xaxis.set_major_formatter(ticker.FuncFormatter(lambda step, _: f"{step:g}"))
        axis.xaxis.set_minor_formatter(ticker.NullFormatter())
        axis.set_ylim(-0.025, max(1.0, 1.05 * float(table["median"].max())) if len(table) else 1.0)
        axis.set_xlabel(X_LABEL[space])
        axis.set_ylabel("Relative fitness")
        style.panel_letter(axis, panel, x=-0.08)
        if len(missing) == len(parts):
            style.no_data(axis, "no walks of " + " and ".join(missing))
            continue
        for label in missing:
            axis.plot([], [], color="none", label=f"no walks of {label}")
        axis.legend(loc="center right")
    notes = study.notes("evo", "evo_devo")
    if len(table):
        notes.append(
            f"Medians over all walks ({int(table['walks'].max())} at most), with {100 * LEVEL:g} % percentile "
            "bootstrap intervals over champions (n). Each step mutates with rates redrawn in [1/48, 1], as in "
            "the released code. Fast: at least 30 body lengths."
        )
    style.caption(figure, TITLE, notes)
    return style.Drawing("fig5", TITLE, figure, table, notes)
