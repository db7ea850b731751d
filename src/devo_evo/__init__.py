"""Archives of devo_evo as pandas frames, robots simulated again, and the statistics, figures and report of a study.

    import devo_evo
    archive = devo_evo.Archive("results/first")
    champions = archive.run_champions()
    lineage = archive.lineage(trial=1)

docs/analysis.md walks through it. Everything is loaded when it is first used: the ROS messages, which live in this
package too (devo_evo.msg, devo_evo.srv), must not need pandas.
"""

_HOMES = {
    "Archive": "archive",
    "Genome": "genomes",
    "RigidGenome": "genomes",
    "Study": "study",
    "open_study": "study",
    "evaluate": "evaluation",
    "evaluate_individuals": "evaluation",
    "ArchiveError": "errors",
    "DevoEvoError": "errors",
    "InvalidInput": "errors",
    "NotBegun": "errors",
}

__all__ = sorted(_HOMES)


def __getattr__(name):
    if name not in _HOMES:
        raise AttributeError(f"module 'devo_evo' has no attribute {name!r}")
    import importlib

    return getattr(importlib.import_module("devo_evo." + _HOMES[name]), name)


def __dir__():
    return sorted(set(globals()) | set(_HOMES))
