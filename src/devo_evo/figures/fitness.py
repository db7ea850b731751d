"""Fig. 3: best fitness over generations, and run champions with and without their development."""

import numpy as np
import pandas as pd

from ..statistics import median_curve, median_interval
from . import style

TITLE = "Evolvability and development (Fig. 3)"
POINTS = 400  # of a curve; more cannot be told apart
BASELINES = {"random_search": (":", "random search"), "neutral": ("--", "neutral drift")}  # line, label
BARS = (("evo", "Evo"), ("evo_devo", "Evo-Devo"), ("removed", "Evo-Devo\nremoved"))


def best_fitness(archive):
    """Best fitness of each generation as trial x generation [body lengths], up to the horizon; negative ones are 0."""
    horizon = archive.horizon()
    frame = archive.generations()
    frame = frame[(frame["generation"] <= horizon.generation) & frame["trial"].isin(horizon.trials)]
    table = frame.pivot(index="trial", columns="generation", values="best_fitness").astype(float)
    return table.fillna(0.0).clip(lower=0.0)


def curve(archive):
    """Median and 95 % band of `best_fitness` over trials: a frame of x (generation), median, low, high, trials."""
    table = best_fitness(archive)
    generations = thinned(table.columns.to_numpy())
    median, low, high = median_curve(table[generations].to_numpy())
    return pd.DataFrame({"x": generations, "median": median, "low": low, "high": high, "trials": len(table)})


def thinned(values, points=POINTS):
    """At most `points` of the values, evenly spread, with the first and the last."""
    if len(values) <= points:
        return values
    return values[np.unique(np.linspace(0, len(values) - 1, points).round().astype(int))]


def numbers(study):
    """Panel A: series evo, evo_devo, and baselines. Panel B: bars of run champions, and of final populations."""
    frames = []
    for name, archive in study.main_arms().items():
        frames.append(curve(archive).assign(panel="A", series=name))
    for series, values in champions(study).items():
        frames.append(_bar(values, series, "run champions"))
    for name in ("evo", "evo_devo"):
        archive = study.main(name)
        if archive is not None and archive.horizon().trials:
            final = archive.survivors()
            final = final[final["trial"].isin(archive.horizon().trials)]
            frames.append(_bar(final.groupby("trial")["fitness"].median(), name, "final populations"))
    if not frames:
        return pd.DataFrame(columns=["panel", "series", "of", "x", "median", "low", "high", "trials"])
    frame = pd.concat(frames, ignore_index=True)
    return frame[["panel", "series", "of", "x", "median", "low", "high", "trials"]] if "of" in frame else frame


def champions(study):
    """Fitness of run champions [body lengths] by series, as far as there are any; `removed`: frozen at birth."""
    result = {}
    for name in ("evo", "evo_devo"):
        archive = study.main(name)
        if archive is not None and archive.horizon().trials:
            result[name] = archive.run_champions()["fitness"]
    removed = study.removed()
    if removed is not None and len(removed):
        result["removed"] = removed["fitness"]
    return result


def _bar(values, series, of):
    interval = median_interval(values, resamples=1000)
    return pd.DataFrame(
        [
            {
                "panel": "B",
                "series": series,
                "of": of,
                "median": interval.estimate,
                "low": interval.low,
                "high": interval.high,
                "trials": int(np.sum(~np.isnan(np.asarray(values, dtype=float)))),
            }
        ]
    )


def draw(study):
    """The figure."""
    table = numbers(study)
    figure, axes = style.new_figure(12, 5, 1, 2, gridspec_kw={"width_ratios": [1.25, 1], "wspace": 0.28})
    _draw_curves(axes[0, 0], table[table["panel"] == "A"])
    _draw_bars(axes[0, 1], table[table["panel"] == "B"])
    for letter, panel in zip("AB", axes[0]):
        panel.set_ylabel("Body lengths traveled")
        style.panel_letter(panel, letter)
    notes = study.notes("evo", "evo_devo")
    if not table.empty:
        notes.append(
            "A: median of the best fitness of each generation over trials. B: medians of run champions (wide "
            "bars) and of the trials' median survivors (narrow, pale). 95 % percentile bootstrap intervals."
        )
    style.caption(figure, TITLE, notes)
    return style.Drawing("fig3", TITLE, figure, table, notes)


def _draw_curves(axes, rows):
    last = rows["x"].max() if len(rows) else 10000
    for series in sorted(rows["series"].unique(), key=lambda name: (" " in name, name)):  # baselines last
        part = rows[rows["series"] == series]
        treatment, _, baseline = series.partition(" ")
        colour, label = style.TREATMENT_COLOUR[treatment], style.TREATMENT_LABEL[treatment]
        if baseline:
            line, words = BASELINES[baseline]
            axes.plot(part["x"], part["median"], color=colour, linewidth=1.3, linestyle=line, label=f"{label}, {words}")
        else:
            style.band(axes, part, colour, label)
    axes.set_xlabel("Generation")
    axes.xaxis.get_major_locator().set_params(integer=True)
    axes.set_xlim(-0.005 * last, max(last, 1))
    _fitness_axis(axes, rows["high"].max() if len(rows) else 0.0)
    if len(rows):
        axes.legend(loc="best", fontsize=10 if rows["series"].nunique() > 2 else 12)
    else:
        style.no_data(axes, "no finished generation")


def _draw_bars(axes, rows):
    rows = rows.set_index(["series", "of"]) if len(rows) else rows
    for place, (series, label) in enumerate(BARS):
        shown = False
        for of, offset, width, alpha in (("run champions", -0.12, 0.5, 1.0), ("final populations", 0.28, 0.22, 0.45)):
            if len(rows) and (series, of) in rows.index:
                row = rows.loc[(series, of)]
                if np.isnan(row["median"]):
                    continue
                axes.bar(place + offset, row["median"], width, color=style.BAR_COLOURS[place], alpha=alpha)
                axes.errorbar(
                    place + offset,
                    row["median"],
                    color=style.ERROR_BAR,
                    capsize=5,
                    linewidth=2,
                    yerr=[[row["median"] - row["low"]], [row["high"] - row["median"]]],
                )
                shown = True
        if not shown:
            axes.text(
                place,
                0.02,
                "no data",
                rotation=90,
                ha="center",
                va="bottom",
                color="0.45",
                style="italic",
                transform=axes.get_xaxis_transform(),
            )
    axes.set_xticks(range(len(BARS)), [label for _, label in BARS])
    axes.set_xlim(-0.6, len(BARS) - 0.4)
    _fitness_axis(axes, rows["high"].max() if len(rows) else 0.0)


def _fitness_axis(axes, highest):
    """The paper's axis; a shorter one while nothing comes near its end."""
    if highest <= 10.0:
        axes.set_ylim(0.0, max(1.0, 1.15 * highest))
    else:
        axes.set_ylim(0.0, max(60.0, 1.05 * highest))
        axes.set_yticks(range(0, int(axes.get_ylim()[1]) + 1, 10))
