"""Outcomes of the three kinds of test that most claims rest on; the opposite of each is looked at, too."""

from ..statistics import equivalence_paired, mann_whitney, signed_rank
from .base import Outcome


def greater(first, second, interval, generations, ours):
    """Two independent groups, of which the first is claimed to be the greater."""
    return Outcome(
        ours=ours,
        interval=interval,
        test=mann_whitney(first, second),
        against=mann_whitney(second, first).p,
        trials=min(len(first), len(second)),
        generations=generations,
    )


def positive(differences, interval, generations, ours):
    """Paired differences that are claimed to be positive."""
    return Outcome(
        ours=ours,
        interval=interval,
        test=signed_rank(differences),
        against=signed_rank(-differences).p,
        trials=len(differences),
        generations=generations,
    )


def equivalent(differences, margin, interval, generations, ours):
    """Paired differences that are claimed to lie within +-margin; interval: of their median."""
    return Outcome(
        ours=ours,
        interval=interval,
        test=equivalence_paired(differences, margin),
        refuted=interval.low > margin or interval.high < -margin,
        trials=len(differences),
        generations=generations,
    )


def show(interval, digits=2):
    """An interval as the report shows it, such as "12.01 [11.39, 29.73]"."""
    return f"{interval.estimate:.{digits}f} [{interval.low:.{digits}f}, {interval.high:.{digits}f}]"
