"""Fig. S5: rigid bodies. Windows and fitness along lineages, and best fitness over generations."""

import pandas as pd

from ..study import LABELS, counted
from . import style
from .fitness import curve
from .lineages import align, draw_lineage

TITLE = "Differential canalization in rigid bodies (Fig. S5)"
TURNS = 1.0  # from here on a robot rolls [full turns]
COLUMNS = 10  # of lineages
TREATMENTS = ("evo", "evo_devo")
MEASURES = ["morphology_window", "control_window", "fitness", "turns", "first_roll_since_birth_s"]
LINEAGE_COLUMNS = ["trial", "ancestor", "x", "fast", "id", "generation"] + MEASURES


def lineages(study, treatment="evo_devo"):
    """One row per ancestor of each run champion: trial, ancestor (0: founder), x (right-aligned), windows [1], fitness
    [1/m^2], turns, time of the first half turn [s] (NaN: none), and `fast`: whether the run champion rolls."""
    archive = study.rigid(treatment)
    if archive is None:
        return pd.DataFrame(columns=LINEAGE_COLUMNS)
    return align(archive.lineages().copy(), "turns", TURNS)[LINEAGE_COLUMNS]


def numbers(study):
    """Panel A: `lineages` of Evo-Devo. Panel B: x (generation), median, low, high [1/m^2], trials, by series."""
    frames = [lineages(study).assign(panel="A", series="evo_devo")]
    for treatment in TREATMENTS:
        archive = study.rigid(treatment)
        if archive is not None:
            frames.append(curve(archive).assign(panel="B", series=treatment))
    columns = ["panel", "series"] + list(frames[0].columns.drop(["panel", "series"])) + ["median", "low", "high", "trials"]
    return pd.concat([frame for frame in frames if len(frame)] or frames[:1], ignore_index=True).reindex(columns=columns)


def draw(study):
    """The figure."""
    table = numbers(study)
    rows, curves = table[table["panel"] == "A"], table[table["panel"] == "B"]
    trials = sorted(int(trial) for trial in rows["trial"].unique())[:COLUMNS]
    columns = max(len(trials), 3)
    figure = style.mpl_figure.Figure(figsize=(1.5 * columns + 6.5, 5.6))
    grid = figure.add_gridspec(1, 2, width_ratios=[1.5 * columns, 5.0], wspace=0.3)
    _draw_lineages(figure, grid[0, 0], rows, trials, columns)
    axes = figure.add_subplot(grid[0, 1])
    _draw_curves(axes, curves)
    style.panel_letter(axes, "B", x=-0.16)
    notes = _notes(study, len(rows["trial"].unique()) - len(trials))
    style.caption(figure, TITLE, notes)
    return style.Drawing("figS5", TITLE, figure, table, notes)


def _draw_lineages(figure, place, rows, trials, columns):
    cells = place.subgridspec(1, columns, wspace=0.12)
    if not trials:
        axes = figure.add_subplot(place)
        style.no_data(axes, "no experiment with rigid bodies: no lineage of an Evo-Devo run champion")
        style.panel_letter(axes, "A")
    for column, trial in enumerate(trials):
        cell = cells[0, column].subgridspec(3, 1, hspace=0.08)
        drawn = draw_lineage(
            figure, cell, rows[rows["trial"] == trial], f"run {trial}", rows, labelled=column == 0, fitted=True
        )
        if column == 0:
            style.panel_letter(drawn[0], "A", x=-0.25)


def _draw_curves(axes, rows):
    for treatment in TREATMENTS:
        part = rows[rows["series"] == treatment]
        if len(part):
            style.band(axes, part, style.TREATMENT_COLOUR[treatment], style.TREATMENT_LABEL[treatment])
    axes.set_xlabel("Generation")
    axes.set_ylabel("Light at the abdomen [1/m\u00b2]")
    axes.xaxis.get_major_locator().set_params(integer=True)
    if len(rows):
        axes.set_ylim(bottom=0.0)
        axes.legend(loc="lower right")
    else:
        style.no_data(axes, "no finished generation of rigid bodies")


def _notes(study, left_out):
    parts = []
    for treatment in TREATMENTS:
        archive = study.rigid(treatment)
        if archive is None:
            parts.append(f"{LABELS[treatment]}: no finished generation.")
            continue
        horizon = archive.horizon()
        parts.append(
            f"{LABELS[treatment]}: {counted(len(horizon.trials), 'trial')}, {counted(horizon.generation, 'generation')}, "
            f"population {archive.parameters['population']}."
        )
    notes = ["Rigid bodies. " + " ".join(parts)]
    notes.append(
        "A: developmental windows and fitness (mean light, 1/m\u00b2) of the ancestors T of Evo-Devo run champions, the "
        "random founder first, right-aligned"
        + (f"; {counted(left_out, 'more lineage')} in the table of numbers" if left_out else "")
        + f". \u2217: the run champion does not turn over once. B: median of the best fitness of each "
        "generation over trials, with 95 % percentile bootstrap band."
    )
    return notes
