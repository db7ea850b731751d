"""Fig. S1 and Fig. 4A: developmental windows and fitness along the lineages of Evo-Devo run champions."""

import pandas as pd

from . import style

TITLE = "Developmental windows along lineages (Fig. S1)"
FAST = 30.0  # a run champion that rolls [body lengths]
ROWS = (
    ("morphology_window", "$W_L$", style.LINEAGE_RED, 0.7, (0.1, 0.3, 0.5)),
    ("control_window", r"$W_\Phi$", style.LINEAGE_GREEN, 0.7, (0.1, 0.3, 0.5)),
    ("fitness", "$F$", style.LINEAGE_BLUE, 80.0, (20, 40, 60)),
)
COLUMNS = 10  # of Fig. S1


def numbers(study):
    """One row per ancestor: trial, ancestor (0: founder), x (right-aligned), both windows [1], fitness [body lengths],
    and the band in which 95 % of neutral lineages lie, if they were simulated."""
    archive = study.main("evo_devo")
    if archive is None or not archive.horizon().trials:
        return pd.DataFrame(
            columns=["trial", "ancestor", "x", "fast", "morphology_window", "control_window", "fitness"]
        )
    frame = archive.lineages()[
        ["trial", "ancestor", "id", "generation", "morphology_window", "control_window", "fitness"]
    ]
    return align(frame, "fitness", FAST)


def align(frame, measure, least):
    """Adds to rows of ancestors x (right-aligned) and `fast`: whether the trial's run champion has at least so much."""
    sizes = frame.groupby("trial")["ancestor"].transform("max")
    frame["x"] = frame["ancestor"] + (sizes.max() - sizes)
    champions = frame[frame["ancestor"] == sizes].set_index("trial")[measure]
    frame["fast"] = frame["trial"].map(champions) >= least
    return frame


def draw(study):
    """Fig. S1: every trial."""
    table = numbers(study)
    trials = sorted(table["trial"].unique())
    columns = min(COLUMNS, max(len(trials), 3))
    blocks = max(1, -(-len(trials) // columns))
    figure = style.mpl_figure.Figure(figsize=(2.0 * columns + 1.0, 5.2 * blocks + 0.4))
    grid = figure.add_gridspec(blocks, columns, wspace=0.12, hspace=0.22)
    if not trials:
        style.no_data(figure.add_subplot(grid[0, :]), "no lineage yet: no Evo-Devo trial has a run champion")
    for number, trial in enumerate(trials):
        cell = grid[number // columns, number % columns].subgridspec(3, 1, hspace=0.08)
        draw_lineage(
            figure, cell, table[table["trial"] == trial], f"run {trial}", table, labelled=number % columns == 0
        )
    notes = study.notes("evo_devo")
    notes.append(
        "T: ancestors of the run champion, its random founder first, right-aligned. \u2217: the run champion "
        f"travels less than {FAST:g} body lengths."
    )
    style.caption(figure, TITLE, notes)
    return style.Drawing("figS1", TITLE, figure, table, notes)


def draw_lineage(figure, cell, rows, title, table, labelled, fitted=False):
    """Three panels of one lineage, stacked in a cell of a grid; axes are those of all lineages in `table`. Returns them.

    fitted: whether the axis of fitness is as high as the best, whatever its unit.
    """
    longest, best = table["x"].max(), float(table["fitness"].max())
    panels = []
    for row, (column, label, colour, top, ticks) in enumerate(ROWS):
        axes = figure.add_subplot(cell[row, 0])
        axes.plot(rows["x"], rows[column], color=colour, linewidth=2.2, solid_capstyle="round")
        axes.set_xlim(0, longest + 1)
        panels.append(axes)
        if column == "fitness" and fitted:
            axes.set_ylim(0.0, 1.1 * best)
        elif column == "fitness" and best <= 10.0:  # the paper's axis would show nothing
            axes.set_ylim(min(0.0, float(table[column].min())), max(1.0, 1.2 * best))
        else:
            axes.set_ylim(0.0, max(top, 1.05 * float(table[column].max())))
            axes.set_yticks(ticks)
        axes.tick_params(labelsize=8, labelleft=labelled)
        axes.set_xticks([])
        if labelled:
            axes.set_ylabel(label, fontsize=13)
        if row == 0:
            axes.set_title(title, fontsize=11)
        if row == 2:
            axes.set_xlabel("T" if rows["fast"].iloc[0] else "T  \u2217", fontsize=11)
    return panels


def representatives(table):
    """Three trials for Fig. 4A, fixed before any data: of the fast ones (else of all), those whose run champions are at
    the quartiles of fitness."""
    last = table.sort_values("ancestor").groupby("trial").tail(1)
    candidates = last[last["fast"]] if last["fast"].sum() >= 3 else last
    ordered = candidates.sort_values(["fitness", "trial"])["trial"].to_numpy()
    places = range(len(ordered)) if len(ordered) <= 3 else [len(ordered) * quarter // 4 for quarter in (1, 2, 3)]
    return [int(ordered[place]) for place in places]
