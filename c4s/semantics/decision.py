"""A decision on a requirement, and how decisions combine with three truth values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from c4s.semantics.inventory import Thing

Status = Literal["MATCH", "MISMATCH", "UNKNOWN"]
SHARE = 0.5
"""A collection satisfies a relation or look when at least half of its members do; the share is the score."""


@dataclass(frozen=True)
class Decision:
    """A decision with its evidence. ``score`` is in [0, 1], and 0 when unknown."""

    status: Status
    score: float
    reason: str
    actors: list[str] = field(default_factory=list)
    measures: dict[str, Any] = field(default_factory=dict)
    partly: bool = False
    """Of a mismatch: some of the things satisfy it, or may, so its opposite is not sure either."""


def unknown(reason: str, actors: Sequence[str] = ()) -> Decision:
    """Not decidable from the state."""
    return Decision("UNKNOWN", 0.0, reason, list(actors))


def decided(holds: bool, reason: str, things: Sequence[Thing] = (), **measures: Any) -> Decision:
    """A definite yes or no."""
    return Decision("MATCH" if holds else "MISMATCH", float(holds), reason, actor_names(things), measures)


def shared(things: Sequence[Thing], holding: Sequence[Thing], reason: str, *, any_suffices: bool) -> Decision:
    """A yes or no from the share of things that satisfy a test, with that share as the score."""
    share = len(holding) / len(things)
    score = float(share > 0) if any_suffices else share
    return Decision(
        "MATCH" if score >= SHARE else "MISMATCH",
        score,
        reason,
        actor_names(holding),
        {"satisfying": len(holding), "of": len(things)},
        partly=0 < score < SHARE,
    )


def actor_names(things: Sequence[Thing], most: int = 50) -> list[str]:
    """Names of the things' actors, without repeats, at most 50."""
    return list(dict.fromkeys(thing.actor for thing in things))[:most]


def conjunction(decisions: Sequence[Decision]) -> Decision:
    """All of them: a known no decides (a whole one before a partial one), else an unknown leaves it open, else the
    lowest score."""
    for status in ("MISMATCH", "UNKNOWN"):
        found = [d for d in decisions if d.status == status]
        if found:
            return min(found, key=lambda d: (d.partly, d.score))
    return min(decisions, key=lambda d: d.score)


def disjunction(decisions: Sequence[Decision]) -> Decision:
    """Any of them: a known yes decides, else an unknown leaves it open."""
    for status in ("MATCH", "UNKNOWN"):
        found = [d for d in decisions if d.status == status]
        if found:
            return max(found, key=lambda d: d.score)
    return max(decisions, key=lambda d: (d.partly, d.score))


def negation(decision: Decision) -> Decision:
    """The opposite of a decision; that a few satisfy it is no proof of the opposite."""
    if decision.status == "UNKNOWN":
        return decision
    if decision.partly:
        return unknown(f"partly: {decision.reason}", decision.actors)
    return Decision(
        "MISMATCH" if decision.status == "MATCH" else "MATCH",
        1.0 - decision.score,
        f"not: {decision.reason}",
        decision.actors,
        decision.measures,
    )
