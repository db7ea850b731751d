"""Fig. 4: three lineages, and median fitness over both developmental windows of all designs."""

import math

import matplotlib
from matplotlib import cm, collections, colors
import numpy as np
import pandas as pd

from . import lineages, style

TITLE = "Differential canalization (Fig. 4)"
GRID_X, EXTENT = 30, 100.0  # cells across, and their extent [raw windows: sum of |initial - final|, at most 96]
RAW = 96.0  # raw window of W = 1
LOWEST, HIGHEST = -1, 60  # colours, and the lowest fitness that counts [body lengths]


def hexagons(x, y, values, grid_x=GRID_X, extent=EXTENT):
    """Median of values in hexagonal cells over 0..extent in x and y, laid as Matplotlib's hexbin does.

    Returns a frame of x, y (centres), median, count, for cells with at least one value, ordered by y and x.
    """
    x, y, values = (np.asarray(array, dtype=float) for array in (x, y, values))
    grid_y = int(grid_x / math.sqrt(3))
    step_x, step_y = extent / grid_x, extent / grid_y
    across, up = x / step_x, y / step_y
    near_x, near_y = np.round(across), np.round(up)
    between_x, between_y = np.floor(across), np.floor(up)
    on_lattice = (across - near_x) ** 2 + 3.0 * (up - near_y) ** 2 < (across - between_x - 0.5) ** 2 + 3.0 * (
        up - between_y - 0.5
    ) ** 2
    frame = pd.DataFrame(
        {
            "x": step_x * np.where(on_lattice, near_x, between_x + 0.5),
            "y": step_y * np.where(on_lattice, near_y, between_y + 0.5),
            "value": values,
        }
    )
    cells = frame.groupby(["y", "x"])["value"].agg(["median", "count"]).reset_index()
    return cells[["x", "y", "median", "count"]]


def numbers(study):
    """Panel A: ancestors of three run champions. Panel B: cells x (W_Phi), y (W_L) [1], median fitness, designs."""
    table = lineages.numbers(study)
    chosen = table[table["trial"].isin(lineages.representatives(table))].assign(panel="A") if len(table) else table
    archive = study.main("evo_devo")
    cells = pd.DataFrame(columns=["x", "y", "median", "count"])
    if archive is not None:
        every = archive.designs(LOWEST)
        if len(every):
            cells = hexagons(RAW * every["control_window"], RAW * every["morphology_window"], every["fitness"])
            cells[["x", "y"]] /= RAW
    cells = cells.rename(
        columns={"x": "control_window", "y": "morphology_window", "median": "fitness", "count": "designs"}
    ).assign(panel="B")
    frame = pd.concat([chosen, cells], ignore_index=True)
    return frame[["panel"] + [column for column in frame if column != "panel"]]


def draw(study):
    """The figure."""
    table = numbers(study)
    figure = style.mpl_figure.Figure(figsize=(12.5, 5))
    grid = figure.add_gridspec(1, 2, width_ratios=[1.05, 1], wspace=0.2)
    rows = table[table["panel"] == "A"]
    trials = sorted(rows["trial"].unique())
    left = grid[0, 0].subgridspec(1, max(len(trials), 1), wspace=0.2)
    if not trials:
        style.no_data(figure.add_subplot(left[0, 0]), "no lineage yet: no Evo-Devo trial has a run champion")
    for place, trial in enumerate(trials):
        lineages.draw_lineage(
            figure,
            left[0, place].subgridspec(3, 1, hspace=0.1),
            rows[rows["trial"] == trial],
            f"run {int(trial)}",
            rows,
            labelled=place == 0,
        )
    axes = figure.add_subplot(grid[0, 1])
    _draw_cells(figure, axes, table[table["panel"] == "B"])
    style.panel_letter(figure.axes[0], "A", x=-0.25, y=1.12)
    style.panel_letter(axes, "B", x=-0.12)
    notes = study.notes("evo_devo")
    notes.append(
        "A: lineages at the quartiles of run champions' fitness. B: median fitness of the designs in each cell, "
        f"each design once, those below {LOWEST} body lengths left out."
    )
    style.caption(figure, TITLE, notes)
    return style.Drawing("fig4", TITLE, figure, table, notes)


def _draw_cells(figure, axes, cells):
    axes.set_xlim(0, 1)
    axes.set_ylim(0, 1)
    axes.set_xticks(np.arange(0, 1.01, 0.2))
    axes.set_yticks(np.arange(0, 1.01, 0.2))
    axes.set_xlabel("Controller development")
    axes.set_ylabel("Morphological development")
    if cells.empty:
        style.no_data(axes, "no design evaluated yet")
        return
    grid_y = int(GRID_X / math.sqrt(3))
    corners = np.array([[0.5, -0.5], [0.5, 0.5], [0.0, 1.0], [-0.5, 0.5], [-0.5, -0.5], [0.0, -1.0]])
    corners = corners * np.array([EXTENT / GRID_X, EXTENT / grid_y / 3.0]) / RAW
    centres = cells[["control_window", "morphology_window"]].to_numpy(dtype=float)
    highest = HIGHEST if cells["fitness"].max() > 15.0 else max(1, math.ceil(cells["fitness"].max()))
    bounds = np.linspace(LOWEST, highest, 62)
    shades = cm.ScalarMappable(colors.BoundaryNorm(bounds, 256), matplotlib.colormaps["jet"])
    axes.add_collection(
        collections.PolyCollection(
            centres[:, np.newaxis, :] + corners,
            facecolors=shades.to_rgba(cells["fitness"].to_numpy(dtype=float)),
            edgecolors="none",
            rasterized=True,
        )
    )
    bar = figure.colorbar(
        shades, ax=axes, ticks=np.linspace(0, highest, 7), format="%d" if highest == HIGHEST else "%.2f"
    )
    for height, label, side in ((0.97, "High fitness", "top"), (0.03, "Low fitness", "bottom")):
        bar.ax.text(
            0.5,
            height,
            label,
            rotation=90,
            transform=bar.ax.transAxes,
            ha="center",
            va=side,
            color="w",
            fontsize=10,
        )
    bar.set_label("Median fitness [body lengths]", fontsize=11)
