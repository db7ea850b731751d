"""Run champions frozen at birth, mid-life or death, in body, control or both: more of what Fig. 3B has one bar of."""

import pandas as pd

from ..statistics import median_interval
from . import style

TITLE = "Development frozen (beside Fig. 3B)"
MOMENTS = ("birth", "midlife", "death")
SCOPES = {  # label, colour
    "both": ("body and control", style.BAR_COLOURS[2]),
    "body": ("body", style.BAR_COLOURS[0]),
    "control": ("control", style.BAR_COLOURS[1]),
}


def numbers(study):
    """A row per bar: moment, scope, median, low, high (fitness of Evo-Devo run champions [body lengths]), trials."""
    frame = study.variants()
    frame = frame[(frame["part"] == "main") & (frame["treatment"] == "evo_devo")]
    rows = []
    for moment in MOMENTS:
        for scope in SCOPES:
            values = frame[(frame["moment"] == moment) & (frame["scope"] == scope)]["fitness"].dropna()
            if len(values):
                interval = median_interval(values, resamples=1000)
                rows.append([moment, scope, interval.estimate, interval.low, interval.high, len(values)])
    archive = study.main("evo_devo")
    if rows and archive is not None:
        champions = archive.run_champions()["fitness"].dropna()
        interval = median_interval(champions, resamples=1000)
        rows.insert(0, ["never", "nothing", interval.estimate, interval.low, interval.high, len(champions)])
    return pd.DataFrame(rows, columns=["moment", "scope", "median", "low", "high", "trials"])


def draw(study):
    """The figure."""
    table = numbers(study)
    figure, axes = style.new_figure(8, 4.5)
    axis = axes[0, 0]
    if table.empty:
        style.no_data(axis, "no run champions with frozen development")
    for scope, (label, colour) in SCOPES.items():
        rows = table[table["scope"] == scope]
        places = [MOMENTS.index(moment) + 0.27 * (list(SCOPES).index(scope) - 1) for moment in rows["moment"]]
        axis.bar(places, rows["median"], 0.25, color=colour, label=label)
        errors = [rows["median"] - rows["low"], rows["high"] - rows["median"]]
        axis.errorbar(places, rows["median"], yerr=errors, fmt="none", color=style.ERROR_BAR, capsize=4, linewidth=1.6)
    for _, row in table[table["scope"] == "nothing"].iterrows():
        axis.axhline(row["median"], color=style.ORANGE, linestyle="--", label="as evolved")
        axis.axhspan(row["low"], row["high"], color=style.ORANGE, alpha=0.15, linewidth=0)
    if len(table):
        axis.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), title="frozen")
    axis.set_xticks(range(len(MOMENTS)), ["at birth", "at mid-life", "at death"])
    axis.set_ylabel("Body lengths traveled")
    notes = study.notes("evo_devo")
    if len(table):
        notes.append(
            "Medians of Evo-Devo run champions whose body, control or both have all their life the values of one "
            "moment, with 95 % percentile bootstrap intervals."
        )
    style.caption(figure, TITLE, notes)
    return style.Drawing("fig_frozen", TITLE, figure, table, notes)
