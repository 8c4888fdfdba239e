"""What other score policies would change on a leaderboard: stored verdicts are scored again, nothing is replaced."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from statistics import fmean
from typing import Final

import numpy as np

from c4s.errors import BadInput
from c4s.protocol.rules import GATE
from c4s.records.policy import ScorePolicy
from c4s.records.verdict import Verdict
from c4s.score.case import case_score
from c4s.score.policies import POLICIES
from c4s.score.rescore import under
from c4s.stats.ranks import competition_ranks
from reports.frame import Board, SiteContext
from reports.frame.asked import verdicts
from reports.frame.board import Row
from warehouse.analyses.panels import set_scores

MOST_CHANGED: Final = 5
"""Trials that are named under a policy."""


@dataclass(frozen=True)
class UnderPolicy:
    """A leaderboard under another policy."""

    policy: ScorePolicy
    scores: Mapping[str, float]
    """Of each complete configuration, as the leaderboard ranks: overall where both tasks are there, else the mean."""
    ranks: Mapping[str, int]
    """Of the ranked ones among them."""
    moved: int
    """Trials whose score is another one."""
    most: Sequence[tuple[Row, float]]
    """Trials that change most, with their score under the policy."""


@dataclass(frozen=True)
class Policies:
    """All of them, beside what is published."""

    here: UnderPolicy
    others: Sequence[UnderPolicy]
    overall: bool
    """Whether scores are overall ones; else means of cases."""
    refusal: str = ""


def under_policies(site: SiteContext, board: Board) -> Policies | None:
    """The shipped policies on the board's public cases; None where no configuration is complete.

    A trial whose verdicts lack what a policy needs is told as the refusal of all.
    """
    found: dict[str, list[tuple[Row, float]]] = defaultdict(list)
    policies = [policy for name, policy in POLICIES.items() if name != board.policy]
    try:
        for case in board.cases:
            asked = verdicts(site.warehouse, board, case["case_id"])
            for trial in (trial for own in case["scores"].values() for trial in own if trial["score"] is not None):
                made = {row["verifier"]: Verdict.parse(row["document"]) for row in asked.get(trial["trial_id"], [])}
                for policy in policies:
                    found[policy.policy_id].append((trial, _score(trial, made, policy)))
    except BadInput as error:
        return Policies(_empty(board), (), overall=False, refusal=error.line())
    here = [(trial, trial["score"]) for case in board.cases for own in case["scores"].values() for trial in own]
    published = _made(board, POLICIES.get(board.policy) or ScorePolicy(policy_id=board.policy), here)
    if published is None:
        return None
    others = [one for policy in policies if (one := _made(board, policy, found[policy.policy_id])) is not None]
    return Policies(published, others, overall=_is_overall(board))


def _score(trial: Row, made: Mapping[str, Verdict], policy: ScorePolicy) -> float:
    """A trial's score under a policy; a zero by rule stays one."""
    if str(trial["status"]).startswith("zero_"):
        return float(trial["score"])
    if GATE not in made:
        raise BadInput("verdicts are not in this warehouse", where=trial["case_id"], todo="c4s report --from-runs")
    score = case_score(
        case_id=trial["case_id"],
        setting=trial["setting"],
        configuration=trial["configuration"],
        repeat=trial["repeat"],
        judge=trial["judge"],
        engine=trial["engine"],
        submitted=True,
        verdicts={name: under(verdict, policy, trial["setting"]) for name, verdict in made.items()},
        policy=policy.policy_id,
        weights=policy.weights(trial["setting"]),
    )
    if score.score is None:
        raise BadInput(score.reason, where=f"{trial['configuration']} on {trial['case_id']}")
    return score.score


def _made(board: Board, policy: ScorePolicy, trials: Sequence[tuple[Row, float | None]]) -> UnderPolicy | None:
    by_case: dict[tuple[str, str], list[float | None]] = defaultdict(list)
    for trial, score in trials:
        by_case[trial["configuration"], trial["case_id"]].append(score)
    whole = [row for row in board.standings if row["resolved"] == row["planned"]]
    names = [row["configuration"] for row in whole]
    known = all(
        by_case.get((name, case["case_id"])) and None not in by_case[name, case["case_id"]]
        for name in names
        for case in board.cases
    )
    if not names or not board.cases or not known:
        return None
    values = np.array(
        [
            [fmean(score for score in by_case[name, case["case_id"]] if score is not None) for name in names]
            for case in board.cases
        ]
    )
    sets = set_scores([case["setting"] for case in board.cases], values)
    means = sets.get("model", values.mean(axis=0))
    ranked = [place for place, row in enumerate(whole) if row["ranked"]]
    ranks = competition_ranks(means[ranked]) if ranked else ()
    changed = [(trial, score) for trial, score in trials if score is not None and score != trial["score"]]
    changed.sort(key=lambda one: -abs(one[1] - one[0]["score"]))
    return UnderPolicy(
        policy,
        {name: float(mean) for name, mean in zip(names, means, strict=True)},
        {names[place]: int(rank) for place, rank in zip(ranked, ranks, strict=True)},
        len(changed),
        changed[:MOST_CHANGED],
    )


def _is_overall(board: Board) -> bool:
    return any(row["model_score"] is not None for row in board.standings)


def _empty(board: Board) -> UnderPolicy:
    return UnderPolicy(ScorePolicy(policy_id=board.policy), {}, {}, 0, ())
