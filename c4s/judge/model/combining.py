"""Claims that are made of others: logic over the graph with three truth values, as stage 1 combines them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from c4s.protocol.bundle import LOGIC_TYPES, Predicate, Requirements
from c4s.records.judgement import DECIDED, Answer, ClaimJudgement
from c4s.semantics.decision import Decision, conjunction, disjunction, negation, unknown

Judged = Mapping[str, ClaimJudgement]


def is_made_of_others(requirements: Requirements, node: str) -> bool:
    """Whether a claim is decided by its operands, all of which are there."""
    predicate = requirements.predicates[node]
    operands = predicate.operands
    return (
        predicate.type in LOGIC_TYPES
        and bool(operands)
        and all(operand in requirements.predicates for operand in operands)
    )


def leaves_of(requirements: Requirements, node: str, is_open: Callable[[str], bool]) -> Iterator[str]:
    """The claims below a claim that are made of no others and that it still depends on, each once; itself where it is
    one."""
    stack, seen = [node], set[str]()
    while stack:
        at = stack.pop()
        if at in seen or not is_open(at):
            continue
        seen.add(at)
        if is_made_of_others(requirements, at):
            stack += reversed(requirements.predicates[at].operands)
        else:
            yield at


def combined(requirements: Requirements, node: str, judged: dict[str, ClaimJudgement]) -> ClaimJudgement:
    """The judgement of a claim, from those of its operands where it is made of others; all that is made is added."""
    entered: set[str] = set()
    stack = [node]
    while stack:
        at = stack[-1]
        if at in judged:
            stack.pop()
            continue
        predicate = requirements.predicates[at]
        open_operands = [operand for operand in predicate.operands if operand not in judged]
        if at not in entered and open_operands:
            entered.add(at)
            stack += [operand for operand in reversed(open_operands) if operand not in entered]
            continue
        judged[at] = _made_of(predicate, judged)
        stack.pop()
    return judged[node]


def _made_of(predicate: Predicate, judged: Judged) -> ClaimJudgement:
    parts = [judged[operand] for operand in predicate.operands if operand in judged]
    if len(parts) < len(predicate.operands):
        return ClaimJudgement(
            claim=predicate.id, answer="UNKNOWN", score=0.0, reason="the requirement refers to itself", stage="combined"
        )
    found = _combine(predicate, [_decision(part) for part in parts])
    answer: Answer = found.status if found.status in DECIDED else _left_open(parts)
    decided = found.status in DECIDED
    return ClaimJudgement(
        claim=predicate.id,
        answer=answer,
        score=found.score if decided else 0.0,
        confidence=_confidence(parts) if decided else None,
        reason=found.reason,
        stage="combined",
        actors=found.actors,
        views=_all(part.views for part in parts),
        cited=_all(part.cited for part in parts),
        measures={"operands": {part.claim: part.answer for part in parts}},
    )


def _combine(predicate: Predicate, parts: Sequence[Decision]) -> Decision:
    if predicate.operator in ("any_of", "or"):
        found = disjunction(parts)
    elif predicate.operator in ("all_of", "and"):
        found = conjunction(parts)
    elif predicate.operator in ("not", "none_of"):
        found = negation(disjunction(parts))
    else:
        return unknown(f"unknown operator {predicate.operator}")
    return negation(found) if predicate.negative else found


def _decision(said: ClaimJudgement) -> Decision:
    if said.answer == "MATCH" or said.answer == "MISMATCH":
        return Decision(said.answer, said.score, said.reason, said.actors, said.measures)
    return unknown(said.reason, said.actors)


def _left_open(parts: Sequence[ClaimJudgement]) -> Answer:
    """What an undecided claim is, by those of its operands that are not decided: the nearest to a judgement last."""
    answers = {part.answer for part in parts}
    return next((answer for answer in ("ERROR", "UNKNOWN", "NOT_EVALUATED") if answer in answers), "UNKNOWN")


def _confidence(parts: Sequence[ClaimJudgement]) -> float | None:
    told = [part.confidence for part in parts if part.confidence is not None]
    return min(told) if told else None


def _all(lists: Iterator[list[str]]) -> list[str]:
    return list(dict.fromkeys(name for names in lists for name in names))
