"""The paper's figures from a study: each as PDF, PNG, and a CSV of exactly the numbers plotted."""

import importlib
import pathlib

from ..errors import DevoEvoError, InvalidInput

# By the number that the paper gives it; the last three are ours.
_MODULES = {
    "3": "fitness",
    "4": "canalization",
    "5": "walks",
    "6": "discovery",
    "S1": "lineages",
    "S2": "development",
    "S3": "sweep",
    "S4": "impact",
    "S5": "rigid",
    "time": "survival",
    "robustness": "robustness",
    "frozen": "frozen",
}
NAMES = tuple(_MODULES)


def draw(name, study):
    """Draws one figure, such as "3" or "S1"."""
    from . import style

    if name not in _MODULES:
        raise InvalidInput(f"there is no figure {name!r}; the figures are " + ", ".join(NAMES))
    with style.matplotlib.rc_context(style.SETTINGS):
        return importlib.import_module("." + _MODULES[name], __name__).draw(study)


def draw_all(study, folder, only=(), say=lambda text: None):
    """Draws figures (default: all) and saves them in a folder. Returns the drawings and the paths of their files."""
    names = [
        name.upper().removeprefix("FIG") if name.upper().removeprefix("FIG") in _MODULES else name for name in only
    ]
    for name in names:
        if name not in _MODULES:
            raise InvalidInput(f"there is no figure {name!r}; the figures are " + ", ".join(NAMES))
    folder = pathlib.Path(folder)
    drawings = []
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name in names or NAMES:
            drawing = draw(name, study)
            drawings.append((drawing, drawing.save(folder)))
            say(f"{folder / drawing.name}.pdf, .png, .csv: {drawing.title}")
    except OSError as error:
        raise DevoEvoError(f"figures cannot be written to {folder}: {error.strerror}") from error
    return drawings
