"""Stage 1: decides what the scene's state decides, and calls everything else UNKNOWN (paper, Evidence ladder).

It is deterministic, reads no pictures and no text that the agent under test wrote. See ``docs/rule-judge.md`` for what
each kind of requirement means to it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeAlias

from c4s.protocol.bundle import LOGIC_TYPES, Predicate, Requirements
from c4s.protocol.words import tokens
from c4s.records.binding import Binding
from c4s.semantics.decision import (
    SHARE,
    Decision,
    actor_names,
    conjunction,
    decided,
    disjunction,
    negation,
    shared,
    unknown,
)
from c4s.semantics.grounding import Grounding
from c4s.semantics.inventory import Thing
from c4s.semantics.kinds import Facts, ThingKind
from c4s.semantics.looks import has_color, is_made_of, material_index
from c4s.semantics.quantities import limits, loose_limits
from c4s.semantics.relation_words import is_measured
from c4s.semantics.spatial import Spatial, layout_of

ActorColor: TypeAlias = Callable[[str, str], bool | None]
"""Whether an actor, by object name, shows the colour of some words; None where nobody can tell."""


class StateDecider:
    """Decides the predicates of one bundle on one scene; colours by sight too, where somebody looks (``colors``)."""

    def __init__(
        self,
        requirements: Requirements,
        snapshot: Mapping[str, Any],
        catalog: Mapping[str, Facts],
        binding: Binding | None = None,
        colors: ActorColor | None = None,
    ) -> None:
        self.requirements = requirements
        self._colors = colors
        self.grounding = Grounding(requirements, snapshot, catalog, binding)
        self._spatial = Spatial(self.grounding)
        self._materials = material_index(catalog)
        self._decisions: dict[str, Decision] = {}

    @property
    def things(self) -> list[Thing]:
        """The things that count."""
        return self.grounding.things

    def ground(self, entity_id: str) -> list[Thing]:
        """The things that an entity names and that count."""
        return self.grounding.ground(entity_id)

    def measurable(self, predicate: Predicate) -> bool:
        """Whether geometry and counting are what decides such a predicate, whatever it says of this scene."""
        match predicate.type:
            case "spatial_relation":
                named = [entity for _, entity in predicate.arguments]
                return is_measured(predicate.relation) and len(named) > 1 and self.grounding.has_place(named)
            case "distribution":
                return layout_of(predicate) is not None
            case "quantity" | "count":
                return limits(predicate.quantity or {}) is not None
            case kind:
                return kind in ("existence", "presence")

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
            "spatial_relation": self._spatial.relation,
            "distribution": self._spatial.distribution,
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

    def _existence(self, predicate: Predicate) -> Decision:
        things, absent = self.grounding.present(predicate.subjects)
        if absent:
            return absent
        parts = [decided(True, "placed", things, count=len(things))]
        if predicate.quantity:
            parts.append(self._count(things, predicate))
        if predicate.qualifiers:
            parts.append(self._qualified(things, predicate))
        if predicate.relation and predicate.references:
            parts.append(self._spatial.relation(predicate))
        return conjunction(parts)

    def _quantity(self, predicate: Predicate) -> Decision:
        things, absent = self.grounding.present(predicate.subjects)
        if absent and absent.status == "UNKNOWN":
            return absent
        return self._count(things, predicate)

    def _count(self, things: Sequence[Thing], predicate: Predicate) -> Decision:
        """Things counted against a quantity; open where it depends on things that do not count, or on taste."""
        quantity = predicate.quantity or {}
        wanted, bearable = limits(quantity), loose_limits(quantity)
        if wanted is None or bearable is None:
            return unknown(f"{quantity.get('qualitative') or quantity.get('mode')} is no count", actor_names(things))
        count, set_aside = len(things), self.grounding.set_aside(predicate.subjects)
        fits = {wanted[0] <= number <= wanted[1] for number in (count, count + set_aside)}
        if len(fits) > 1:
            return unknown(f"{count} count, {set_aside} more are placed that do not", actor_names(things))
        holds = fits.pop()
        if not holds and bearable[0] <= count <= bearable[1]:
            return unknown(f"{count} is nearly as many as asked for", actor_names(things))
        in_doubt = self.grounding.in_doubt(predicate.subjects)
        if count < wanted[0] <= count + set_aside + in_doubt:
            return unknown(f"{count} are named so, {in_doubt} more may be", actor_names(things))
        if count > wanted[1] and self.grounding.divided(predicate.subjects):
            return unknown(f"{count} are named so, and others of the prompt are too", actor_names(things))
        most = {} if wanted[1] == math.inf else {"at_most": wanted[1]}
        return decided(holds, "counted", things, count=count, at_least=wanted[0], **most)

    def _looks(self, predicate: Predicate) -> Decision:
        things, absent = self.grounding.present(predicate.subjects)
        if absent:
            return absent
        return self._qualified(things, predicate) if predicate.qualifiers else unknown("no attribute is named")

    def _qualified(self, things: Sequence[Thing], predicate: Predicate) -> Decision:
        """Whether the things show every qualifier of the predicate."""
        return conjunction([self._shows(things, predicate, kind, words) for kind, words in predicate.qualifiers])

    def _shows(self, things: Sequence[Thing], predicate: Predicate, kind: str, words: str) -> Decision:
        individual = not self.grounding.collective(predicate.subjects)
        in_part = sum(one == "color" for one, _ in predicate.qualifiers) > 1
        found: dict[tuple[ThingKind, tuple[str, ...]], bool | None] = {}
        for thing in things:
            if (thing.kind, thing.materials) not in found:
                found[thing.kind, thing.materials] = self._shown(thing, kind, words, in_part=in_part)
        answers = [found[thing.kind, thing.materials] for thing in things]
        if kind == "color" and self._colors is not None:
            pairs = zip(things, answers, strict=True)
            answers = [self._colors(one.actor, words) if answer is None else answer for one, answer in pairs]
        holding = [thing for thing, answer in zip(things, answers, strict=True) if answer]
        if individual and holding:
            return shared(things, holding, f"{kind} {words}", any_suffices=True)
        divided = bool(holding) and len(holding) < SHARE * len(things) and self.grounding.divided(predicate.subjects)
        if divided or (None in answers and len(holding) < len(things)):
            return unknown(f"{kind} {words} is not said by the assets", actor_names(things))
        return shared(things, holding, f"{kind} {words}", any_suffices=individual)

    def _shown(self, thing: Thing, kind: str, words: str, *, in_part: bool) -> bool | None:
        """What a thing's asset and materials say of a qualifier."""
        if kind == "material":
            return is_made_of(thing, words, self._materials)
        if kind == "color":
            return has_color(thing, words, self._materials, in_part=in_part)
        return True if thing.kind.says(tokens(words)) else None
