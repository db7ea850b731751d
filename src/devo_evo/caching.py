"""Results that are kept: an object that is read at one moment gives the same answer as long as it lives."""

import functools

import pandas as pd


def remembered(method):
    """Keeps what a method returned for each set of (hashable) arguments, in the object's `_remembered`.

    Frames are handed out as copies, so that nobody's changes are seen by others.
    """

    @functools.wraps(method)
    def wrapper(self, *arguments):
        key = (method.__name__, *arguments)
        if key not in self._remembered:
            self._remembered[key] = method(self, *arguments)
        kept = self._remembered[key]
        return kept.copy() if isinstance(kept, pd.DataFrame) else kept

    return wrapper
