"""What is left of run champions' fitness in changed worlds. The paper conjectures it in its Discussion."""

import pandas as pd

from ..statistics import median_interval
from . import style

TITLE = "External robustness (conjectured in the Discussion)"
QUANTITIES = {
    "friction": "Friction, times",
    "gravity": "Gravity, times",
    "slope": "Slope, rise over run",
    "actuation_amplitude": "Actuation amplitude, times",
}


def numbers(study):
    """Medians over run champions: quantity, series (treatment), x (value), median, low, high (relative fitness [1])."""
    frame = study.robustness()
    frame = frame[(frame["part"] == "main") & (frame["home"] > 0)]
    frame = frame.assign(relative=frame["relative"].astype(float).fillna(0.0))
    rows = []
    for quantity in QUANTITIES:
        for treatment in ("evo", "evo_devo"):
            own = frame[frame["treatment"] == treatment]
            if not (own["quantity"] == quantity).any():
                continue
            unchanged = own[own["quantity"] == "none"].assign(value=0.0 if quantity == "slope" else 1.0)
            part = pd.concat([own[own["quantity"] == quantity], unchanged])
            for value, worlds in part.groupby("value"):
                interval = median_interval(worlds["relative"])
                rows.append(
                    {
                        "quantity": quantity,
                        "series": treatment,
                        "x": value,
                        "median": interval.estimate,
                        "low": interval.low,
                        "high": interval.high,
                        "champions": len(worlds),
                    }
                )
    return pd.DataFrame(rows, columns=["quantity", "series", "x", "median", "low", "high", "champions"])


def draw(study):
    """The figure."""
    table = numbers(study)
    figure, axes = style.new_figure(12, 8, 2, 2, gridspec_kw={"wspace": 0.22, "hspace": 0.3})
    for axis, (quantity, label) in zip(axes.flat, QUANTITIES.items()):
        rows = table[table["quantity"] == quantity]
        if rows.empty:
            style.no_data(axis, "no lives in changed worlds")
        for treatment, part in rows.groupby("series", sort=False):
            style.band(
                axis,
                part,
                style.TREATMENT_COLOUR[treatment],
                f"{style.TREATMENT_LABEL[treatment]} (n = {int(part['champions'].max())})",
                marker="o",
            )
        axis.axhline(1.0, color=style.GREY, linestyle="--", linewidth=1)
        axis.set_xlabel(label)
        axis.locator_params(axis="x", nbins=5)
        axis.set_ylabel("Relative fitness")
    if len(table):
        axes[0, 0].legend(loc="best")
    notes = study.notes("evo", "evo_devo")
    if len(table):
        notes.append(
            "Fitness of run champions over that in the world they evolved in; medians with 95 % percentile bootstrap "
            "intervals over champions."
        )
    style.caption(figure, TITLE, notes)
    return style.Drawing("fig_robustness", TITLE, figure, table, notes)
