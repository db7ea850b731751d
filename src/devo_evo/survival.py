"""Time to an event that some never have: Kaplan-Meier's estimate and the log-rank test.

A trial that never reached 30 body lengths counts as one that had not by its last generation (it is censored).
"""

import math

import numpy as np
import pandas as pd
from scipy import stats

from .statistics import TestResult


def kaplan_meier(times, happened):
    """Kaplan-Meier's estimate. Returns a frame: time, at_risk, events, survival (share without the event after time).

    times: of the event, or of the end of observation. happened: whether it was the event.
    """
    times, happened = np.asarray(times, dtype=float), np.asarray(happened, dtype=bool)
    rows, survival = [(0.0, len(times), 0, 1.0)], 1.0
    for time in np.unique(times[happened]):
        at_risk, events = int(np.sum(times >= time)), int(np.sum(times[happened] == time))
        survival *= 1.0 - events / at_risk
        rows.append((time, at_risk, events, survival))
    return pd.DataFrame(rows, columns=["time", "at_risk", "events", "survival"])


def median_time(times, happened):
    """Time by which half have had the event; infinite if that was not observed."""
    curve = kaplan_meier(times, happened)
    reached = curve[curve["survival"] <= 0.5]
    return math.inf if reached.empty else float(reached["time"].iloc[0])


def log_rank(times, happened, other_times, other_happened, alternative="earlier"):
    """One-sided log-rank test of the first group having its events earlier (or "later") than the second."""
    first, first_happened = np.asarray(times, dtype=float), np.asarray(happened, dtype=bool)
    second, second_happened = np.asarray(other_times, dtype=float), np.asarray(other_happened, dtype=bool)
    excess = variance = 0.0  # of the first group's events, over what they would be if both were alike
    for time in np.unique(np.concatenate([first[first_happened], second[second_happened]])):
        in_first, in_second = np.sum(first >= time), np.sum(second >= time)
        total = in_first + in_second
        events_first = np.sum(first[first_happened] == time)
        events = events_first + np.sum(second[second_happened] == time)
        excess += events_first - events * in_first / total
        if total > 1:
            variance += events * (in_first / total) * (in_second / total) * (total - events) / (total - 1)
    p = math.nan
    if variance > 0:
        z = excess / math.sqrt(variance)
        p = float(stats.norm.sf(z if alternative == "earlier" else -z))
    return TestResult("log-rank", p, (len(first), len(second)))
