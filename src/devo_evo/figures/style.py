"""How every figure looks: the paper's colours, deterministic files, notes on what the data are."""

import dataclasses
import pathlib
import textwrap

import matplotlib

matplotlib.use("Agg")

from matplotlib import figure as mpl_figure  # noqa: E402 (after the choice of backend)
import pandas as pd  # noqa: E402

from ..study import LABELS  # noqa: E402

# ColorBrewer's Set2, as far as the paper uses it.
GREEN, ORANGE, BLUE, PINK, LIME, GREY = "#66c2a5", "#fc8d62", "#8da0cb", "#e78ac3", "#a6d854", "#b3b3b3"
# The palette of lineages: W_L, W_Phi, F.
LINEAGE_RED, LINEAGE_GREEN, LINEAGE_BLUE = "#D65F5F", "#6ACC65", "#4878CF"
# Bars are drawn with three quarters of the saturation.
BAR_COLOURS = ("#72b6a1", "#e99675", "#95a3c3")
ERROR_BAR = "#424242"

TREATMENT_COLOUR = {"evo": GREEN, "evo_devo": ORANGE, "evo_devo_body": PINK, "evo_devo_control": LIME}
TREATMENT_LABEL = LABELS

SETTINGS = {
    "font.family": "serif",
    "font.serif": ["DejaVu Serif"],
    "mathtext.fontset": "dejavuserif",
    "font.size": 11,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.labelsize": 14,
    "axes.grid": False,
    "legend.frameon": False,
    "legend.fontsize": 12,
    "pdf.fonttype": 42,
    "svg.hashsalt": "devo_evo",
    "figure.dpi": 100,
    "savefig.dpi": 110,
    "path.simplify": True,
}
# What would differ from one drawing of the same data to the next.
_METADATA = {
    "pdf": {"CreationDate": None, "ModDate": None, "Producer": "devo_evo", "Creator": "devo_evo"},
    "png": {"Software": "devo_evo"},
}


@dataclasses.dataclass
class Drawing:
    """A figure that was drawn, and exactly the numbers in it."""

    name: str  # of its files, such as "fig3"
    title: str  # of the paper's figure
    figure: mpl_figure.Figure
    numbers: pd.DataFrame  # what is plotted
    notes: list  # what the data are, and what they do not support

    def save(self, folder):
        """Writes PDF, PNG and CSV into a folder. Returns their paths."""
        folder = pathlib.Path(folder)
        paths = [folder / f"{self.name}.{kind}" for kind in ("pdf", "png", "csv")]
        with matplotlib.rc_context(SETTINGS):
            self.figure.savefig(paths[0], metadata=_METADATA["pdf"], bbox_inches="tight", pad_inches=0.15)
            self.figure.savefig(paths[1], metadata=_METADATA["png"], bbox_inches="tight", pad_inches=0.15)
        self.numbers.to_csv(paths[2], index=False, lineterminator="\n")
        return paths


def new_figure(width, height, rows=1, columns=1, **arguments):
    """A figure of some inches with a grid of axes (a two-dimensional array)."""
    figure = mpl_figure.Figure(figsize=(width, height))
    axes = figure.subplots(rows, columns, squeeze=False, **arguments)
    return figure, axes


def caption(figure, title, notes):
    """Title above; below the axes, what the data are."""
    figure.draw_without_rendering()
    renderer = figure._get_renderer()  # pylint: disable=protected-access
    boxes = [axes.get_tightbbox(renderer).transformed(figure.transFigure.inverted()) for axes in figure.axes]
    inch = 1.0 / figure.get_figheight()
    figure.text(0.5, max(box.y1 for box in boxes) + 0.15 * inch, title, fontsize=13, ha="center", va="bottom")
    left, right = min(box.x0 for box in boxes), max(box.x1 for box in boxes)
    width = int((right - left) * figure.get_figwidth() * 14.5)
    text = "\n".join(textwrap.fill(note, width) for note in notes)
    figure.text(
        left,
        min(box.y0 for box in boxes) - 0.15 * inch,
        text,
        fontsize=9,
        va="top",
        ha="left",
        color="0.3",
        family="DejaVu Sans",
    )


def panel_letter(axes, letter, x=-0.1, y=1.02):
    """The letter of a panel, outside its upper left corner."""
    axes.text(x, y, letter, transform=axes.transAxes, fontsize=22, family="DejaVu Sans", va="bottom", ha="right")


def no_data(axes, text):
    """Says in an empty panel what is missing."""
    axes.text(
        0.5,
        0.5,
        textwrap.fill(text, 34),
        transform=axes.transAxes,
        ha="center",
        va="center",
        fontsize=11,
        color="0.45",
        style="italic",
    )


def band(axes, rows, colour, label, **line):
    """A median line with its confidence band: columns x, median, low, high."""
    axes.plot(rows["x"], rows["median"], color=colour, label=label, linewidth=2.2, **line)
    axes.fill_between(rows["x"], rows["low"], rows["high"], color=colour, alpha=0.2, linewidth=0)
