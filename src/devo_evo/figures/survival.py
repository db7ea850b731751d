"""Share of trials that have not reached 30 body lengths yet, by Kaplan-Meier. Not in the paper."""

import pandas as pd

from .. import survival
from . import style

TITLE = "Time to 30 body lengths (not in the paper)"
FAST = 30.0  # [body lengths]


def times_to_fast(archive, threshold=FAST):
    """Generation at which each trial of the horizon reaches the threshold, or its last one; and whether it did."""
    horizon = archive.horizon()
    table = archive.generations()
    table = table[table["trial"].isin(horizon.trials) & (table["generation"] <= horizon.generation)]
    reached = table[table["best_fitness"].astype(float) >= threshold].groupby("trial")["generation"].min()
    times = reached.reindex(horizon.trials)
    return times.fillna(horizon.generation).to_numpy(dtype=float), times.notna().to_numpy()


def numbers(study):
    """Steps of the curves: series, x (generation), at_risk, events, slow (share below 30 body lengths after x)."""
    frames = []
    for treatment in ("evo", "evo_devo"):
        archive = study.main(treatment)
        if archive is not None:
            curve = survival.kaplan_meier(*times_to_fast(archive)).rename(columns={"time": "x", "survival": "slow"})
            end = curve.iloc[[-1]].assign(x=float(archive.horizon().generation), at_risk=0, events=0)
            frames.append(pd.concat([curve, end]).assign(series=treatment))
    columns = ["series", "x", "at_risk", "events", "slow"]
    return pd.concat(frames, ignore_index=True)[columns] if frames else pd.DataFrame(columns=columns)


def draw(study):
    """The figure."""
    table = numbers(study)
    figure, axes = style.new_figure(7.5, 5)
    axis = axes[0, 0]
    for treatment, rows in table.groupby("series", sort=False):
        axis.step(
            rows["x"],
            rows["slow"],
            where="post",
            color=style.TREATMENT_COLOUR[treatment],
            linewidth=2.2,
            label=f"{style.TREATMENT_LABEL[treatment]} ({int(rows['events'].sum())} reached it)",
        )
    if table.empty:
        style.no_data(axis, "no finished generation")
    else:
        axis.legend(loc="lower left")
    axis.set_xlabel("Generation")
    axis.set_ylabel("Share of trials below 30 body lengths")
    axis.set_ylim(0, 1.05)
    axis.set_xlim(left=0)
    notes = study.notes("evo", "evo_devo")
    style.caption(figure, TITLE, notes)
    return style.Drawing("fig_time_to_fast", TITLE, figure, table, notes)
