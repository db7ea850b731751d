"""What a claim is, and how the verdict on it is reached. Nothing here looks at data."""

import dataclasses
import enum
import math
from typing import Callable, Optional

from ..statistics import NOTHING, Interval, TestResult, holm

ALPHA = 0.05  # of each family, after Holm's correction
FAST = 30.0  # from here on a robot is fast, that is, rolls [body lengths]
LEAST = 6  # values of which the median has a 95 % interval: 2 * 0.5^6 < 0.05
PAPER_GENERATIONS = 10000
ROLLING_GENERATIONS = 5300  # upper end of the replication's interval for Evo-Devo's median time to 30 body lengths


class Verdict(enum.Enum):
    """What the data say about a claim."""

    HOLDS = "holds"
    DOES_NOT_HOLD = "does not hold"
    TOO_FEW_TRIALS = "too few trials"
    TOO_FEW_GENERATIONS = "too few generations"
    NO_DATA = "no data"


@dataclasses.dataclass(frozen=True)
class Outcome:
    """What was found about one claim."""

    ours: str = ""  # the estimate in words and numbers
    interval: Interval = NOTHING  # its 95 % interval
    test: Optional[TestResult] = None  # of the claim; None: judged by the interval or exactly
    against: float = math.nan  # p of the opposite of the claim
    supported: Optional[bool] = None  # without a test: whether the claim is shown; None: undecided
    refuted: bool = False  # without a test: whether its opposite is shown
    trials: int = 0  # independent units, of the smaller group
    trials_needed: Optional[int] = None  # where the plan says nothing: estimated from the width of the interval
    generations: int = 0  # that the data reach
    missing: str = ""  # what there is no data of

    @property
    def p(self):
        """p of the claim's test; NaN without one."""
        return self.test.p if self.test else math.nan


@dataclasses.dataclass(frozen=True)
class Claim:
    """A claim of the paper, fixed before any data: what is estimated, how it is tested, what it takes."""

    key: str
    family: str  # within which p values are corrected
    statement: str
    where: str  # in the paper
    paper: str  # its number
    replication: str  # the independent replication's number
    estimand: str
    test: str
    measure: Callable  # of a Study, giving an Outcome
    generations: int = PAPER_GENERATIONS  # that would do
    final: bool = False  # whether it is about the end of evolution, and cannot be judged before
    plan: Optional[Callable] = None  # trials needed, of alpha; None: from the interval
    planning: str = ""  # the effect that the plan assumes


@dataclasses.dataclass(frozen=True)
class Judgement:
    """A claim, what was found, and the verdict."""

    claim: Claim
    outcome: Outcome
    adjusted_p: float  # Holm, within the family
    trials_needed: Optional[int]  # for 80 % power
    verdict: Verdict

    @property
    def verdict_text(self):
        """The verdict, and how many would do."""
        if self.verdict is Verdict.TOO_FEW_TRIALS:
            return f"{self.verdict.value} ({self.trials_needed} would do)" if self.trials_needed else self.verdict.value
        if self.verdict is Verdict.TOO_FEW_GENERATIONS:
            return f"{self.verdict.value} ({self.claim.generations} would do)"
        return self.verdict.value


def decide(claim, outcome, adjusted_p, trials_needed):
    """The verdict.

    A claim holds if its test rejects the null hypothesis after Holm's correction (or its interval lies where the claim
    puts it), but for one about the end of evolution not before that. It does not hold if evolution went on long enough,
    and either its opposite was shown or there were enough trials to show it. Else there are too few of something.
    """
    if outcome.missing and not outcome.trials:
        return Verdict.NO_DATA
    enough_generations = outcome.generations >= claim.generations
    shown = outcome.supported if outcome.test is None else adjusted_p <= ALPHA
    if shown and (enough_generations or not claim.final):
        return Verdict.HOLDS
    if not enough_generations:
        return Verdict.TOO_FEW_GENERATIONS
    # Beside a test, what refutes is an interval, and of fewer than LEAST units there is none.
    refuted = outcome.refuted and (outcome.test is None or outcome.trials >= LEAST)
    if refuted or outcome.against <= ALPHA:
        return Verdict.DOES_NOT_HOLD
    if outcome.test is None and outcome.supported is None:
        return Verdict.TOO_FEW_TRIALS
    if trials_needed is not None and outcome.trials < trials_needed:
        return Verdict.TOO_FEW_TRIALS
    return Verdict.DOES_NOT_HOLD


def judge(claims, study):
    """A Judgement of every claim, in order."""
    outcomes = [claim.measure(study) for claim in claims]
    adjusted = {}
    for family in dict.fromkeys(claim.family for claim in claims):
        members = [index for index, claim in enumerate(claims) if claim.family == family]
        for index, p in zip(members, holm([outcomes[index].p for index in members])):
            adjusted[index] = float(p)
    result = []
    for index, (claim, outcome) in enumerate(zip(claims, outcomes)):
        needed = planned_trials(claim, claims) if claim.plan else outcome.trials_needed
        result.append(
            Judgement(claim, outcome, adjusted[index], needed, decide(claim, outcome, adjusted[index], needed))
        )
    return result


def planned_trials(claim, claims):
    """Trials for 80 % power at the level that Holm leaves the claim at worst."""
    size = sum(1 for other in claims if other.family == claim.family and other.plan)
    return claim.plan(ALPHA / max(size, 1))


def within(interval, low, high, **outcome):
    """An outcome judged by where an interval lies: shown if within low..high, refuted if wholly outside, else open.

    Of fewer than LEAST units a median has no 95 % interval: that is open, too.
    """
    if outcome.get("trials", 0) < LEAST:
        return Outcome(interval=interval, **{**outcome, "trials_needed": max(LEAST, outcome.get("trials_needed") or 0)})
    inside = low <= interval.low and interval.high <= high
    outside = interval.high < low or interval.low > high
    return Outcome(
        interval=interval, supported=True if inside else False if outside else None, refuted=outside, **outcome
    )


def missing(what):
    """An outcome without data."""
    return Outcome(missing=what)
