"""Claims about the windows of the fastest of all designs evaluated: Fig. 4B."""

import pandas as pd

from ..statistics import median_interval
from .base import PAPER_GENERATIONS, Claim, missing
from .outcomes import equivalent, positive, show
from .canalization import CONTROL_MARGIN, EFFECT, FAMILY, WINDOWS, equivalence_needed, needed

ELITE = 0.01  # share of a trial's designs that counts as the fastest


def elite_windows(archive):
    """Median windows of the fastest hundredth of each trial's designs minus those of all its designs."""
    rows = {}
    for trial in archive.horizon().trials:
        designs = archive.individuals(trial, ("fitness", "phenotype_hash", *WINDOWS), valid_only=True)
        designs = designs.drop_duplicates("phenotype_hash")
        if designs.empty:
            continue
        elite = designs.nlargest(max(1, round(ELITE * len(designs))), "fitness")
        rows[trial] = {window: elite[window].median() - designs[window].median() for window in WINDOWS}
    return pd.DataFrame.from_dict(rows, orient="index", columns=list(WINDOWS))


def _elite(window):
    def measure(study):
        archive = study.main("evo_devo")
        if archive is None:
            return missing("the main experiment, Evo-Devo")
        differences = elite_windows(archive)[window]
        interval = median_interval(differences)
        generations = archive.horizon().generation
        words = f"fastest hundredth minus all designs {show(interval, 3)}"
        if window == "morphology_window":
            return positive(-differences, interval, generations, words)
        return equivalent(differences, CONTROL_MARGIN, interval, generations, words)

    return measure


CLAIMS = [
    Claim(
        "elite-body",
        FAMILY,
        "The fastest designs have small W_L.",
        "Fig. 4B",
        "qualitative",
        "not given",
        "median W_L of the fastest hundredth of a trial's designs minus that of all its designs",
        "signed-rank, one-sided",
        _elite("morphology_window"),
        PAPER_GENERATIONS,
        final=True,
        plan=needed,
        planning=EFFECT,
    ),
    Claim(
        "elite-control",
        FAMILY,
        "The fastest designs are free in W_Phi.",
        "Fig. 4B",
        "qualitative",
        "not given",
        "the same of W_Phi",
        f"equivalence (TOST, signed-rank), margin {CONTROL_MARGIN:g}",
        _elite("control_window"),
        PAPER_GENERATIONS,
        final=True,
        plan=equivalence_needed,
        planning="no true difference, standard deviation 0.1",
    ),
]
