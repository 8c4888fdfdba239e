"""The offline rule judge: decides what the scene's state decides, and calls everything else UNKNOWN.

It is deterministic, reads no pictures and no text that the agent under test wrote. See ``docs/rule-judge.md`` for what
each kind of requirement means to it.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from c4s.protocol.bundle import LOGIC_TYPES, Entity, Predicate, Requirements
from c4s.protocol.words import phrases_of, tokens
from c4s.semantics.inventory import Thing, inventory
from c4s.semantics.kinds import Facts, KindIndex, ThingKind
from c4s.semantics.looks import has_color, is_made_of, material_index
from c4s.semantics.measures import (
    RELATIONS,
    SYNONYMS,
    encircles,
    is_cluster,
    is_ring,
    is_row,
    is_scattered,
    plan_centres,
)
from c4s.semantics.quantities import limits

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
    )


def actor_names(things: Sequence[Thing], most: int = 50) -> list[str]:
    """Names of the things' actors, without repeats, at most 50."""
    return list(dict.fromkeys(thing.actor for thing in things))[:most]


def conjunction(decisions: Sequence[Decision]) -> Decision:
    """All of them: a known no decides, else an unknown leaves it open, else the lowest score."""
    for status in ("MISMATCH", "UNKNOWN"):
        found = [d for d in decisions if d.status == status]
        if found:
            return min(found, key=lambda d: d.score)
    return min(decisions, key=lambda d: d.score)


def disjunction(decisions: Sequence[Decision]) -> Decision:
    """Any of them: a known yes decides, else an unknown leaves it open."""
    for status in ("MATCH", "UNKNOWN"):
        found = [d for d in decisions if d.status == status]
        if found:
            return max(found, key=lambda d: d.score)
    return max(decisions, key=lambda d: d.score)


def negation(decision: Decision) -> Decision:
    """The opposite of a decision."""
    if decision.status == "UNKNOWN":
        return decision
    return Decision(
        "MISMATCH" if decision.status == "MATCH" else "MATCH",
        1.0 - decision.score,
        f"not: {decision.reason}",
        decision.actors,
        decision.measures,
    )


class RuleJudge:
    """Decides the predicates of one bundle on one scene."""

    def __init__(self, requirements: Requirements, snapshot: Mapping[str, Any], catalog: Mapping[str, Facts]) -> None:
        self.requirements = requirements
        self.things = inventory(snapshot, catalog)
        self._places: dict[ThingKind, list[int]] = {}
        for place, thing in enumerate(self.things):
            self._places.setdefault(thing.kind, []).append(place)
        self.closed = all(kind.facts is not None and not kind.basic_shape for kind in self._places)
        """Every placed object is a known catalog asset, so what is not named is not there."""
        self._kinds = KindIndex(self._places)
        self._phrases = {entity.id: phrases_of(entity.names) for entity in requirements.entities.values()}
        self._materials = material_index(catalog)
        self._named: dict[tuple[ThingKind, ...], list[Thing]] = {}
        self._grounded: dict[str, list[Thing]] = {}
        self._decisions: dict[str, Decision] = {}
        self._holding: dict[tuple[str, tuple[str, ...], tuple[str, ...]], list[Thing]] = {}

    def ground(self, entity_id: str) -> list[Thing]:
        """The things that an entity names."""
        if entity_id not in self._grounded:
            kinds = tuple(self._kinds.find(self._phrases.get(entity_id, ())))
            if kinds not in self._named:
                places = sorted(place for kind in kinds for place in self._places[kind])
                self._named[kinds] = [self.things[place] for place in places]
            self._grounded[entity_id] = self._named[kinds]
        return self._grounded[entity_id]

    def decide(self, predicate_id: str) -> Decision:
        """The decision on a predicate of the bundle; a logic predicate's operands are decided before it."""
        entered: set[str] = set()
        stack = [predicate_id]
        while stack:
            node = stack[-1]
            predicate = self.requirements.predicates[node]
            if node not in self._decisions:
                entered.add(node)
                self._decisions[node] = unknown("the requirement refers to itself")
                if predicate.type in LOGIC_TYPES and all(o in self.requirements.predicates for o in predicate.operands):
                    stack += [operand for operand in reversed(predicate.operands) if operand not in self._decisions]
                continue
            if node in entered:
                entered.remove(node)
                found = self._decide(predicate)
                self._decisions[node] = negation(found) if predicate.negative else found
            stack.pop()
        return self._decisions[predicate_id]

    def _decide(self, predicate: Predicate) -> Decision:
        if predicate.type in LOGIC_TYPES and predicate.operands:
            return self._logic(predicate)
        deciders: dict[str, Callable[[Predicate], Decision]] = {
            "existence": self._existence,
            "presence": self._existence,
            "quantity": self._quantity,
            "count": self._quantity,
            "set": self._existence,
            "attribute": self._looks,
            "material": self._looks,
            "spatial_relation": self._relation,
            "distribution": self._distribution,
        }
        decide = deciders.get(predicate.type)
        return decide(predicate) if decide else unknown(f"a {predicate.type} requirement has to be seen")

    def _logic(self, predicate: Predicate) -> Decision:
        missing = [operand for operand in predicate.operands if operand not in self.requirements.predicates]
        if missing:
            return unknown(f"unknown operand {missing[0]}")
        parts = [self._decisions[operand] for operand in predicate.operands]
        if predicate.operator in ("any_of", "or"):
            return disjunction(parts)
        if predicate.operator in ("all_of", "and"):
            return conjunction(parts)
        if predicate.operator in ("not", "none_of"):
            return negation(disjunction(parts))
        return unknown(f"unknown operator {predicate.operator}")

    def _presence(self, entity_ids: Sequence[str]) -> tuple[list[Thing], Decision | None]:
        """Things of the entities, or the decision when there are none."""
        named = {id(things): things for things in map(self.ground, entity_ids)}
        things = list(dict.fromkeys(itertools.chain.from_iterable(named.values())))
        if things:
            return things, None
        if not self.things:
            return [], decided(False, "the scene holds no object")
        entities = [self.requirements.entities[i] for i in entity_ids if i in self.requirements.entities]
        if not entities:
            return [], unknown("the requirement names no entity")
        wanted = " / ".join(" ".join(phrases[0]) for phrases in (self._phrases[e.id] for e in entities) if phrases)
        if not all(entity.is_object for entity in entities):
            return [], unknown(f"{wanted} is a region that has to be seen")
        if self.closed:
            return [], decided(False, f"no object of the scene is a {wanted}")
        return [], unknown(f"no object is named {wanted}, but some objects are primitives or not in the catalog")

    def _existence(self, predicate: Predicate) -> Decision:
        things, absent = self._presence(predicate.subjects)
        if absent:
            return absent
        parts = [decided(True, "placed", things, count=len(things))]
        if predicate.quantity:
            parts.append(self._count(things, predicate.quantity))
        if predicate.qualifiers:
            parts.append(self._qualified(things, predicate))
        if predicate.relation and predicate.references:
            parts.append(self._relation(predicate))
        return conjunction(parts)

    def _quantity(self, predicate: Predicate) -> Decision:
        things, absent = self._presence(predicate.subjects)
        if absent and absent.status == "UNKNOWN":
            return absent
        return self._count(things, predicate.quantity or {})

    def _count(self, things: Sequence[Thing], quantity: Mapping[str, Any]) -> Decision:
        wanted = limits(quantity)
        if wanted is None:
            return unknown(f"{quantity.get('qualitative') or quantity.get('mode')} is no count", actor_names(things))
        low, high = wanted
        return decided(
            low <= len(things) <= high,
            "counted",
            things,
            count=len(things),
            at_least=low,
            **({} if high == float("inf") else {"at_most": high}),
        )

    def _looks(self, predicate: Predicate) -> Decision:
        things, absent = self._presence(predicate.subjects)
        if absent:
            return absent
        return self._qualified(things, predicate) if predicate.qualifiers else unknown("no attribute is named")

    def _qualified(self, things: Sequence[Thing], predicate: Predicate) -> Decision:
        """Whether the things show every qualifier of the predicate."""
        individual = all(not entity.collection for entity in self._entities(predicate.subjects))
        return conjunction([self._shows(things, kind, words, individual) for kind, words in predicate.qualifiers])

    def _shows(self, things: Sequence[Thing], kind: str, words: str, individual: bool) -> Decision:
        found: dict[tuple[ThingKind, tuple[str, ...]], bool | None] = {}
        for thing in things:
            if (thing.kind, thing.materials) not in found:
                found[thing.kind, thing.materials] = self._shown(thing, kind, words)
        answers = [found[thing.kind, thing.materials] for thing in things]
        holding = [thing for thing, answer in zip(things, answers, strict=True) if answer]
        if individual and holding:
            return shared(things, holding, f"{kind} {words}", any_suffices=True)
        if None in answers and len(holding) < len(things):
            return unknown(f"{kind} {words} is not said by the assets", actor_names(things))
        return shared(things, holding, f"{kind} {words}", any_suffices=individual)

    def _shown(self, thing: Thing, kind: str, words: str) -> bool | None:
        """What a thing's asset and materials say of a qualifier."""
        if kind == "material":
            return is_made_of(thing, words, self._materials)
        if kind == "color":
            return has_color(thing, words, self._materials)
        return True if thing.kind.says(tokens(words)) else None

    def _entities(self, ids: Sequence[str]) -> list[Entity]:
        return [self.requirements.entities[i] for i in ids if i in self.requirements.entities]

    def _relation(self, predicate: Predicate) -> Decision:
        word = "_".join(str(predicate.relation or "").lower().replace("-", "_").split())
        relation = SYNONYMS.get(word)
        subjects, absent = self._presence(predicate.subjects)
        if absent:
            return absent
        if not predicate.references:
            return unknown("the relation names no reference", actor_names(subjects))
        references, missing = self._presence(predicate.references)
        if missing:
            return missing
        if relation is None:
            return unknown(f"the relation {word or 'given'} is not decidable by geometry", actor_names(subjects))
        sides = tuple(predicate.subjects), tuple(predicate.references)
        if relation.endswith("_inverse") or relation == "between_references":
            subjects, references, sides = references, subjects, sides[::-1]
            relation = "between" if relation == "between_references" else relation.removesuffix("_inverse")
        among = set(subjects)
        others = [thing for thing in references if thing not in among] or references
        if relation == "around":
            return self._around(subjects, others)
        if (relation, *sides) not in self._holding:
            holds = RELATIONS[relation](subjects, others)
            self._holding[relation, *sides] = [subjects[place] for place in np.flatnonzero(holds).tolist()]
        individual = all(not entity.collection for entity in self._entities(predicate.subjects))
        return shared(
            subjects, self._holding[relation, *sides], f"{relation} {len(others)} reference(s)", any_suffices=individual
        )

    def _around(self, subjects: Sequence[Thing], references: Sequence[Thing]) -> Decision:
        if len(subjects) < 3:
            holding = [
                thing
                for thing in subjects
                if any(np.all(thing.low[:2] <= o.low[:2]) and np.all(thing.high[:2] >= o.high[:2]) for o in references)
            ]
            return decided(bool(holding), "one box holds the references' plan", holding)
        holds, gap = encircles(subjects, references)
        return decided(holds, "stand around the references", subjects, largest_gap_deg=round(gap, 1))

    def _distribution(self, predicate: Predicate) -> Decision:
        things, absent = self._presence(predicate.subjects)
        if absent:
            return absent
        words = {
            word
            for text in (predicate.relation or "", *(name for _, name in predicate.qualifiers), predicate.text)
            for word in tokens(text)
        }
        if len(things) < 3:
            return unknown("fewer than three objects have no distribution", actor_names(things))
        points = plan_centres(things)
        if words & {"row", "line", "lined", "queue"}:
            holds, value = is_row(points)
            return decided(holds, "in a row", things, spread_share=round(value, 4))
        if words & {"ring", "circle", "circular"}:
            holds, value = is_ring(points)
            return decided(holds, "in a ring", things, radius_variation=round(value, 4))
        if words & {"cluster", "clustered", "grouped", "huddled", "bunched"}:
            holds, value = is_cluster(things)
            return decided(holds, "clustered", things, nearest_cm=round(value, 1))
        if words & {"scattered", "scatter", "spread", "dotted", "strewn"}:
            holds, value = is_scattered(points)
            return decided(holds, "scattered", things, clark_evans=round(value, 4))
        return unknown("the distribution has to be seen", actor_names(things))
