"""Fig. S3: best fitness over generations at eight fixed mutation rates."""

from fractions import Fraction

from matplotlib import ticker
import pandas as pd

from ..mutation_impact import LAMBDAS
from . import fitness, style

TITLE = "Mutation-rate sweep (Fig. S3)"


def numbers(study):
    """A row per point: mutation_rate, series (treatment), x (generation), median, low, high [body lengths], trials."""
    frames = [
        fitness.curve(archive).assign(mutation_rate=rate, series=treatment)
        for (treatment, rate), archive in sorted(study.sweep().items())
    ]
    columns = ["mutation_rate", "series", "x", "median", "low", "high", "trials"]
    return pd.concat(frames, ignore_index=True)[columns] if frames else pd.DataFrame(columns=columns)


def draw(study):
    """The figure."""
    table = numbers(study)
    figure, axes = style.new_figure(20, 10, 2, 4, sharex=True, sharey=True, gridspec_kw={"wspace": 0.0, "hspace": 0.0})
    last = table["x"].max() if len(table) else 10000
    highest = table["high"].max() if len(table) else 0.0
    for number, (rate, axis) in enumerate(zip(LAMBDAS, axes.flat)):
        drawn = False
        for treatment, label in (("evo", "Evo"), ("evo_devo", "Evo-Devo")):
            rows = table[(abs(table["mutation_rate"] - rate) < 1e-9) & (table["series"] == treatment)]
            if len(rows):
                style.band(axis, rows, style.TREATMENT_COLOUR[treatment], label)
                drawn = True
        if not drawn:
            style.no_data(axis, "no sweep at this rate")
        axis.grid(color="0.88")
        axis.spines[["top", "right"]].set_visible(True)
        axis.text(
            0.04, 0.86, rf"$\lambda$={Fraction(rate).limit_denominator(48)}", transform=axis.transAxes, fontsize=26
        )
        if number == 0 and drawn:
            axis.legend(loc="center left")
        if number % 4 == 0:
            axis.set_ylabel("Body lengths traveled")
        if number >= 4:
            axis.set_xlabel("Generation")
    axes[0, 0].set_xlim(-0.005 * last, 1.005 * last)
    axes[0, 0].set_xticks([last * fifths / 5 for fifths in range(1, 5)])  # neighbours touch: no label at the ends
    axes[0, 0].yaxis.set_major_locator(ticker.MaxNLocator(8, prune="both"))
    axes[0, 0].set_ylim(0, max(80.0, 1.05 * highest) if highest > 10.0 else max(1.0, 1.4 * highest))
    notes = [f"Profile {study.profile}."]
    if len(table):
        least, most = int(table["trials"].min()), int(table["trials"].max())
        notes[0] += (
            f" {least if least == most else f'{least} to {most}'} trials of {int(last)} generations for each rate "
            "and treatment. Medians of the best fitness of each generation, 95 % percentile bootstrap intervals."
        )
    style.caption(figure, TITLE, notes)
    return style.Drawing("figS3", TITLE, figure, table, notes)
