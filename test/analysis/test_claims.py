#!/usr/bin/python3
"""Verdicts: the logic for every claim, and whole studies in which each claim holds, or its opposite does."""

import dataclasses
import math
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import devo_evo  # noqa: E402
from devo_evo import claims, statistics  # noqa: E402
from devo_evo.claims import Outcome, Verdict, impact  # noqa: E402
from synthetic_study import AS_CLAIMED, OPPOSITE, SyntheticStudy  # noqa: E402

PLENTY = 10000  # trials


def verdicts(study):
    """{key: verdict} of every claim."""
    return {judgement.claim.key: judgement.verdict for judgement in claims.judge(claims.CLAIMS, study)}


def found(p=math.nan, generations=PLENTY, trials=PLENTY, against=math.nan, **more):
    """An outcome with a test, if p is given."""
    test = None if math.isnan(p) else statistics.TestResult("a test", p, (trials,))
    return Outcome(test=test, trials=trials, generations=generations, against=against, **more)


class EveryClaimTest(unittest.TestCase):
    def each(self):
        for claim in claims.CLAIMS:
            with self.subTest(claim.key):
                yield claim

    def judged(self, claim, outcome):
        claim = dataclasses.replace(claim, measure=lambda study: outcome)
        (judgement,) = claims.judge([claim], None)
        return judgement.verdict

    def test_shown_by_its_test_or_its_interval_it_holds(self):
        for claim in self.each():
            shown = found(p=0.01) if claim.plan else found(supported=True)
            self.assertIs(self.judged(claim, shown), Verdict.HOLDS)

    def test_with_its_opposite_shown_it_does_not_hold(self):
        for claim in self.each():
            opposite = found(p=0.99, against=0.01) if claim.plan else found(supported=False, refuted=True)
            self.assertIs(self.judged(claim, opposite), Verdict.DOES_NOT_HOLD)

    def test_without_effect_among_plenty_of_trials_it_does_not_hold(self):
        for claim in self.each():
            if claim.plan:
                self.assertIs(self.judged(claim, found(p=0.4, against=0.6)), Verdict.DOES_NOT_HOLD)

    def test_without_effect_among_few_trials_there_are_too_few(self):
        for claim in self.each():
            few = found(p=0.4, against=0.6, trials=2) if claim.plan else found(supported=None, trials=2)
            self.assertIs(self.judged(claim, few), Verdict.TOO_FEW_TRIALS)

    def test_not_shown_after_few_generations_there_are_too_few(self):
        for claim in self.each():
            if claim.generations:
                early = (
                    found(p=0.99, against=0.01, generations=10)
                    if claim.plan
                    else found(supported=False, refuted=True, generations=10)
                )
                self.assertIs(self.judged(claim, early), Verdict.TOO_FEW_GENERATIONS)

    def test_what_is_about_the_end_of_evolution_does_not_hold_before(self):
        for claim in self.each():
            early = found(p=0.01, generations=10) if claim.plan else found(supported=True, generations=10)
            expected = Verdict.TOO_FEW_GENERATIONS if claim.final else Verdict.HOLDS
            self.assertIs(self.judged(claim, early), expected)

    def test_without_data_there_is_no_verdict(self):
        for claim in self.each():
            self.assertIs(self.judged(claim, Outcome(missing="everything")), Verdict.NO_DATA)

    def test_it_says_what_is_estimated_and_how(self):
        for claim in self.each():
            for text in (claim.statement, claim.where, claim.paper, claim.replication, claim.estimand, claim.test):
                self.assertTrue(text)
            self.assertEqual(bool(claim.plan), bool(claim.planning))

    def test_keys_are_unique(self):
        self.assertEqual(len({claim.key for claim in claims.CLAIMS}), len(claims.CLAIMS))


class FamilyTest(unittest.TestCase):
    def test_p_values_are_corrected_within_their_family(self):
        def claim(family, p):
            return dataclasses.replace(claims.CLAIMS[0], family=family, measure=lambda study: found(p=p))

        judged = claims.judge([claim("a", 0.03), claim("a", 0.04), claim("b", 0.04)], None)
        self.assertEqual([round(judgement.adjusted_p, 9) for judgement in judged], [0.06, 0.06, 0.04])
        self.assertEqual(
            [judgement.verdict for judgement in judged], [Verdict.DOES_NOT_HOLD, Verdict.DOES_NOT_HOLD, Verdict.HOLDS]
        )

    def test_a_larger_family_takes_more_trials(self):
        claim = claims.CLAIMS[0]
        self.assertGreater(claims.planned_trials(claim, claims.CLAIMS), claims.planned_trials(claim, [claim]))


class StudiesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)

    def study(self, name, story, **arguments):
        SyntheticStudy(pathlib.Path(self.folder.name) / name, story, **arguments)
        study = devo_evo.open_study(pathlib.Path(self.folder.name) / name)
        self.addCleanup(study.close)
        return study

    def test_what_the_paper_claims_holds_where_it_is_so(self):
        result = verdicts(self.study("as claimed", AS_CLAIMED))
        # Five slow lineages are too few for a signed-rank test, and the paper has no more. Rigid bodies: test_rigid.py.
        expected = {
            "control-breaks-slow": Verdict.TOO_FEW_TRIALS,
            "body-breaks-slow": Verdict.TOO_FEW_TRIALS,
            **{claim.key: Verdict.NO_DATA for claim in claims.rigid.CLAIMS},
        }
        for claim in claims.CLAIMS:
            with self.subTest(claim.key):
                self.assertIs(result[claim.key], expected.get(claim.key, Verdict.HOLDS))

    def test_what_the_paper_claims_does_not_hold_where_the_opposite_is_so(self):
        with mock.patch.dict(impact.PAPER_TABLE, {2: (1.0,) * 8}), mock.patch.object(
            impact.impact, "expected_traits", lambda n, profile="paper": 1.5
        ):
            result = verdicts(self.study("opposite", OPPOSITE))
        for claim in claims.CLAIMS:
            with self.subTest(claim.key):
                self.assertIs(
                    result[claim.key], Verdict.NO_DATA if claim.key.startswith("rigid") else Verdict.DOES_NOT_HOLD
                )

    def test_a_short_study_says_that_it_is_too_short(self):
        result = verdicts(
            self.study(
                "short", {**AS_CLAIMED, "fast_evo": 0, "fast_devo": 0}, generations=200, trials=3, sweep_trials=3
            )
        )
        self.assertIs(result["fast-share"], Verdict.TOO_FEW_GENERATIONS)
        self.assertIs(result["window-rise"], Verdict.TOO_FEW_GENERATIONS)
        self.assertIs(result["evo-median"], Verdict.TOO_FEW_GENERATIONS)

    def test_a_long_study_of_few_trials_says_how_many_would_do(self):
        judged = claims.judge(claims.CLAIMS, self.study("few", AS_CLAIMED, trials=3, sweep_trials=3))
        by_key = {judgement.claim.key: judgement for judgement in judged}
        self.assertEqual(by_key["fast-share"].verdict_text, "too few trials (15 would do)")
        self.assertEqual(by_key["removed"].verdict, Verdict.TOO_FEW_TRIALS)

    def test_one_trial_shows_and_refutes_nothing(self):
        result = verdicts(self.study("one", AS_CLAIMED, trials=1, sweep_trials=1))
        judged = {key for key, verdict in result.items() if verdict in (Verdict.HOLDS, Verdict.DOES_NOT_HOLD)}
        # Those need no trials, or pool the champions of many arms.
        self.assertEqual(judged - {"low-rates-refine"}, {"impact-voxels", "impact-genes", "impact-operator"})


if __name__ == "__main__":
    unittest.main()
