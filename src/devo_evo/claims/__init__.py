"""Every checkable claim of the paper, fixed before any data, and the verdict on it (docs/statistics.md)."""

from . import beyond, canalization, elite, evolvability, heterochrony, impact, rigid, sweep, walks
from .base import ALPHA, Claim, Judgement, Outcome, Verdict, decide, judge, planned_trials

CLAIMS = (
    evolvability.CLAIMS
    + canalization.CLAIMS
    + elite.CLAIMS
    + walks.CLAIMS
    + heterochrony.CLAIMS
    + sweep.CLAIMS
    + impact.CLAIMS
    + rigid.CLAIMS
    + beyond.CLAIMS
)

__all__ = ["ALPHA", "CLAIMS", "Claim", "Judgement", "Outcome", "Verdict", "decide", "judge", "planned_trials"]
