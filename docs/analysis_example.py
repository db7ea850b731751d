#!/usr/bin/python3
"""A worked analysis: does the body of the best robots develop less than that of their founders, and does it matter?

    python3 docs/analysis_example.py OUTPUT [FOLDER]

OUTPUT is the folder of an experiment of a treatment that develops; a picture goes to FOLDER (default: the present one).
"""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot  # noqa: E402
import pandas as pd  # noqa: E402

import devo_evo  # noqa: E402
from devo_evo import statistics  # noqa: E402


def main(output, folder="."):
    # 1. Open the archive. Everything below belongs to this moment, even if evolution goes on.
    archive = devo_evo.Archive(output)
    horizon = archive.horizon()
    print(
        f"{archive.treatment}, profile {archive.profile}: "
        f"{len(horizon.trials)} trials at generation {horizon.generation}"
    )

    # 2. Frames. Every column has a unit.
    champions = archive.run_champions()
    print(champions[["fitness", "turns", "morphology_window", "control_window"]].round(3).to_string())
    print("units:", {name: champions.attrs["units"][name] for name in ("fitness", "turns", "morphology_window")})

    # 3. Lineages: what became of the windows on the way from the founder to the run champion?
    lineages = archive.lineages()
    ends = lineages.groupby("trial")[["morphology_window", "control_window"]].agg(["first", "last"])
    change = pd.DataFrame(
        {window: ends[window]["last"] - ends[window]["first"] for window in ("morphology_window", "control_window")}
    )
    for window in change:
        interval = statistics.median_interval(change[window])
        print(f"change of {window}: {interval.estimate:+.3f} [{interval.low:+.3f}, {interval.high:+.3f}]")
    test = statistics.signed_rank(change["control_window"] - change["morphology_window"])
    print(f"body canalized more than control: {test.name}, n = {test.sizes[0]}, p = {test.p:.3g}")

    # 4. Robots, simulated again: as they are, and with the development of body or control taken away.
    robots = list(champions["id"].items())
    genomes = archive.genomes(robots)
    copies = {
        "as evolved": genomes,
        "body frozen at birth": [genome.without_development(control=False) for genome in genomes],
        "control frozen at birth": [genome.without_development(body=False) for genome in genomes],
        "both frozen at birth": [genome.without_development() for genome in genomes],
    }
    fitness = pd.DataFrame(
        {
            name: devo_evo.evaluate(robots_of, archive.parameters)["fitness"].to_numpy()
            for name, robots_of in copies.items()
        },
        index=champions.index,
    )
    # The archive's own fitness comes back to the last bit.
    assert (fitness["as evolved"] == champions["fitness"]).all()
    print(fitness.round(3).to_string())

    # 5. A picture.
    figure, axes = pyplot.subplots(figsize=(7, 4))
    for trial, rows in lineages.groupby("trial"):
        axes.plot(rows["generation"], rows["morphology_window"], color="#D65F5F", label="$W_L$" if trial == 1 else None)
        axes.plot(
            rows["generation"], rows["control_window"], color="#6ACC65", label=r"$W_\Phi$" if trial == 1 else None
        )
    axes.set_xlabel("Generation of birth")
    axes.set_ylabel("Developmental window")
    axes.legend(frameon=False)
    path = pathlib.Path(folder) / "lineages.png"
    figure.savefig(path, dpi=120, bbox_inches="tight")
    print(f"wrote {path}")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(*sys.argv[1:])
