"""The evidence ladder over the claims of one submission (paper, Evidence ladder).

State decides what it can. What it leaves open is looked at: in its own views, where that leaves it open once more from
another side, and at last between yes and no on the best of all its views. What nothing was photographed for is not
evaluated. Claims that are made of others follow from those.
"""

from __future__ import annotations

from collections.abc import Sequence

from c4s.judge.model.combining import combined, is_made_of_others, leaves_of
from c4s.judge.model.rungs import Answered, Rungs, Sighted
from c4s.judge.model.sights import ClaimSight, Sights
from c4s.records.judgement import ClaimJudgement
from c4s.semantics.decision import Decision
from c4s.semantics.state import StateDecider
from c4s.semantics.views import Views

OPEN = "UNKNOWN"


class Ladder:
    """Judges every scored claim of a bundle."""

    def __init__(self, decider: StateDecider, sights: Sights, rungs: Rungs, views: Views | None) -> None:
        """``views`` tell which actors are seen; for the record."""
        self._decider, self._requirements = decider, decider.requirements
        self._sights, self._rungs, self._views = sights, rungs, views

    def judged(self) -> tuple[list[ClaimJudgement], list[ClaimJudgement]]:
        """A judgement of every scored claim, in the bundle's order; and of the others that those are made of."""
        known: dict[str, ClaimJudgement] = {}
        wanted: dict[str, None] = {}
        for node in self._requirements.scored:
            if not self._is_open(node):
                known[node] = self._of_state(node)
                continue
            wanted |= dict.fromkeys(leaves_of(self._requirements, node, self._is_open))
        known |= self._looked_at(list(wanted))
        for node in self._requirements.scored:
            self._fill(node, known)
            combined(self._requirements, node, known)
        scored = self._requirements.scored
        return [known[node] for node in scored], [known[node] for node in sorted(known.keys() - set(scored))]

    def _is_open(self, node: str) -> bool:
        return self._decider.decide(node).status == OPEN

    def _fill(self, node: str, known: dict[str, ClaimJudgement]) -> None:
        """Add what state says of the claims below a claim, as far as nothing else does."""
        stack, seen = [node], set[str]()
        while stack:
            at = stack.pop()
            if at in seen or at in known:
                continue
            seen.add(at)
            if is_made_of_others(self._requirements, at) and self._is_open(at):
                stack += self._requirements.predicates[at].operands
            else:
                known[at] = self._of_state(at)

    def _of_state(self, node: str) -> ClaimJudgement:
        found = self._decider.decide(node)
        return self._claim(node, found, answer=found.status, score=found.score, reason=found.reason)

    def _claim(self, node: str, state: Decision, **fields: object) -> ClaimJudgement:
        seen = None if self._views is None else sum(self._views.sees(actor) for actor in state.actors)
        made = {"claim": node, "actors": state.actors, "measures": state.measures, "seen_actors": seen, **fields}
        return ClaimJudgement.model_validate(made)

    def _looked_at(self, claims: Sequence[str]) -> dict[str, ClaimJudgement]:
        """What sight says of claims that state leaves open."""
        sights = {claim: self._sights.of(claim) for claim in claims}
        found: dict[str, tuple[Sighted, Answered]] = {}
        for rung in ("sight", "alternate", "arbitration"):
            open_claims = [claim for claim in claims if claim not in found or _is_open(found[claim][1])]
            views = {claim: self._views_for(rung, sights[claim]) for claim in open_claims}
            for claim, answered in self._rungs.climb(rung, {c: names for c, names in views.items() if names}).items():
                found[claim] = rung, answered
        return {claim: self._judgement(claim, sights[claim], found.get(claim)) for claim in claims}

    def _views_for(self, rung: Sighted, sight: ClaimSight) -> tuple[str, ...]:
        if rung == "arbitration":
            return self._sights.best(sight, self._rungs.writer.configuration.pictures_per_request)
        return sight.primary if rung == "sight" else sight.alternate

    def _judgement(self, claim: str, sight: ClaimSight, found: tuple[Sighted, Answered] | None) -> ClaimJudgement:
        state = self._decider.decide(claim)
        if found is None:
            return self._claim(claim, state, answer="NOT_EVALUATED", score=0.0, reason=sight.reason or state.reason)
        return self._claim(claim, state, **told_by(*found))


def told_by(rung: Sighted, answered: Answered) -> dict[str, object]:
    """The fields of a claim's judgement that a rung's answer decides."""
    asked: dict[str, object] = {
        "stage": rung,
        "views": list(answered.views),
        "request_sha256": answered.asked.request_sha256,
        "answer_sha256": answered.asked.answer_sha256,
    }
    if answered.fault:
        return {**asked, "answer": "ERROR", "score": 0.0, "reason": answered.fault}
    said = answered.said
    if said is None:
        reason = f"the answer broke its contract twice: {answered.broken}"
        return {**asked, "answer": OPEN, "score": 0.0, "reason": reason, "fallback": True}
    return {
        **asked,
        "answer": said.answer,
        "score": float(said.answer == "MATCH"),
        "confidence": said.confidence,
        "reason": said.saw,
        "cited": list(answered.cited),
    }


def _is_open(answered: Answered) -> bool:
    """Whether the next rung is to look: what failed with a fault is not asked for again."""
    return not answered.fault and (answered.said is None or answered.said.answer == OPEN)
