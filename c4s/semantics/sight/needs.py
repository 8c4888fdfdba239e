"""Which actors the claims of a bundle need to be seen, and how: claims that need the same share one need.

What a claim needs follows from the entities it names and the things these are bound to, never from how well the scene
does: its subjects, for a relation both sides, for a logic claim what its operands need. Where a side has more than
24 things, subjects are 24 evenly spaced in their order along a space-filling curve, references the two nearest to each.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Final, Literal

import numpy as np

from c4s.protocol.bundle import LOGIC_TYPES, Predicate
from c4s.semantics.boxes import morton_order
from c4s.semantics.inventory import Thing
from c4s.semantics.kinds import ThingKind
from c4s.semantics.state import StateDecider

MOST_THINGS = 24
"""Of one side of a claim that are looked for."""
GROUP = 4
"""Things of a collection that are shown close by where a look at some of them is enough."""
_REFERENCES = 2
COUNTED: Final = frozenset({"existence", "presence", "quantity", "count", "set", "logic"})
"""Types that need no sight where state decides them, unless they ask for a look as well."""
SCENE_WIDE: Final = frozenset(
    {"scene_identity", "environment", "atmosphere", "composition", "style_bundle", "boundary"}
)
"""Types that speak of the whole scene: the overview views show it."""
SPREAD: Final = frozenset({"quantity", "count", "distribution", "composition"})
"""Types that need all their things in one picture, however small; others are seen from near."""

DECIDED: Final = 2
"""Urgency of a claim that state has decided: it has the views that are taken for others."""

Kind = Literal["close", "all", "sides"]


@dataclass(frozen=True)
class Need:
    """Things that one view is to show."""

    kind: Kind
    """``close``: a few things; ``all``: a whole collection; ``sides``: subjects with their references."""
    subjects: Sequence[int]
    """Numbers of things."""
    references: Sequence[int] = ()

    @property
    def things(self) -> list[int]:
        """All of them, each once."""
        return list(dict.fromkeys([*self.subjects, *self.references]))


@dataclass
class ClaimNeed:
    """What one claim needs: views of its own, the overview, or nothing that can be seen."""

    claim: str
    urgency: int
    """0: state leaves it open; 1: its looks may be checked in pixels; ``DECIDED``."""
    needs: list[Need] = field(default_factory=list)
    bound: list[int] = field(default_factory=list)
    """Numbers of all things that it speaks of."""
    overview: bool = False
    reason: str = ""
    """Why nothing can be looked at."""


Wants = Callable[[StateDecider, str], int | None]


def urgency(judge: StateDecider, node: str) -> int | None:
    """How much a claim may need sight, as ``ClaimNeed.urgency``; None where state has settled it.

    Settled are counts and existence that state decides and that ask for no look.
    """
    predicate = judge.requirements.predicates[node]
    if judge.decide(node).status == "UNKNOWN":
        return 0
    if predicate.qualifiers or predicate.type in ("attribute", "material"):
        return 1
    return None if predicate.type in COUNTED else DECIDED


def placed(judge: StateDecider) -> list[Thing]:
    """Everything that is placed: first the things that count, in their order, then those that were set aside."""
    return [*judge.things, *itertools.chain.from_iterable(judge.grounding.substance.aside.values())]


class Needs:
    """The needs of all claims of a bundle on one scene."""

    def __init__(self, judge: StateDecider) -> None:
        self._judge = judge
        self.things = placed(judge)
        """What needs number."""
        self._number = {id(thing): place for place, thing in enumerate(self.things)}
        self._aside: dict[ThingKind, list[Thing]] = {}
        for thing in self.things[len(judge.things) :]:
            self._aside.setdefault(thing.kind, []).append(thing)
        self._centres = np.array([thing.centre for thing in self.things]).reshape(-1, 3)
        self._known: dict[tuple[str, tuple[int, ...], tuple[int, ...]], list[Need]] = {}

    def all(self, wants: Wants = urgency) -> list[ClaimNeed]:
        """What each claim that sight may be needed for needs, in the bundle's order."""
        asked = ((node, wants(self._judge, node)) for node in self._judge.requirements.scored)
        return [self._of(node, grade) for node, grade in asked if grade is not None]

    def _of(self, node: str, grade: int) -> ClaimNeed:
        found = ClaimNeed(node, grade)
        for predicate in self._leaves(node):
            self._add(predicate, found)
        if found.needs or found.overview:
            found.reason = ""
        return found

    def _leaves(self, node: str) -> list[Predicate]:
        """The predicate, or for a logic claim those that it is made of; each once."""
        predicates = self._judge.requirements.predicates
        seen: dict[str, None] = {}
        stack, leaves = [node], []
        while stack:
            here = stack.pop()
            if here in seen or here not in predicates:
                continue
            seen[here] = None
            if predicates[here].type in LOGIC_TYPES and predicates[here].operands:
                stack += reversed(predicates[here].operands)
            else:
                leaves.append(predicates[here])
        return leaves

    def _add(self, predicate: Predicate, found: ClaimNeed) -> None:
        entities = self._judge.requirements.entities
        named = [entity for entity in (*predicate.subjects, *predicate.references) if entity in entities]
        if predicate.type in SCENE_WIDE or not any(entities[entity].is_object for entity in named):
            found.overview = True
        subjects, references = self._bound(predicate.subjects), self._bound(predicate.references)
        found.bound = list(dict.fromkeys([*found.bound, *subjects, *references]))
        missing = [
            entities[entity].names[0] for entity in named if entities[entity].is_object and not self._bound([entity])
        ]
        if missing:
            found.reason = found.reason or f"no object of the scene is bound to {missing[0]}"
            found.overview |= found.urgency == 0
        elif subjects:
            found.needs += [need for need in self._split(predicate, subjects, references) if need not in found.needs]

    def _bound(self, ids: Sequence[str]) -> list[int]:
        """Numbers of the things that entities name: those that count; where none does, those that were set aside."""
        found = {self._number[id(thing)] for entity in ids for thing in self._named(entity)}
        return sorted(found)

    def _named(self, entity: str) -> list[Thing]:
        if counted := self._judge.ground(entity):
            return counted
        return [thing for kind in self._judge.grounding.kinds(entity) for thing in self._aside.get(kind, ())]

    def _split(self, predicate: Predicate, subjects: list[int], references: list[int]) -> list[Need]:
        """The needs of one predicate: all together, and of many things some from near."""
        kind: Kind = "sides" if references else "all" if predicate.type in SPREAD else "close"
        key = kind, tuple(subjects), tuple(references)
        if key not in self._known:
            sampled = self._sample(subjects)
            beside = self._beside(sampled, references)
            some = self._group(sampled)
            if kind == "close":
                needs = [Need("close", some)]
            elif kind == "all":
                needs = [Need("all", sampled)]
            else:
                needs = [Need("sides", sampled, beside)]
                if len(sampled) > GROUP:
                    needs.append(Need("sides", some, self._beside(some, beside, 1)))
            self._known[key] = needs
        return self._known[key]

    def _sample(self, things: list[int]) -> list[int]:
        if len(things) <= MOST_THINGS:
            return things
        order = morton_order(self._centres[things])
        picks = np.linspace(0, len(things) - 1, MOST_THINGS).round().astype(int)
        return sorted({things[order[pick]] for pick in picks.tolist()})

    def _beside(self, subjects: list[int], references: list[int], each: int = _REFERENCES) -> list[int]:
        """The references, of many those nearest to the subjects."""
        if len(references) <= (MOST_THINGS if each > 1 else GROUP):
            return references
        from scipy.spatial import KDTree

        near = KDTree(self._centres[references]).query(self._centres[subjects], k=min(each, len(references)))[1]
        return self._sample(sorted({references[place] for place in np.ravel(near).tolist()}))

    def _group(self, things: list[int]) -> list[int]:
        """The things that stand closest together, with the one whose neighbours are nearest in the middle."""
        if len(things) <= GROUP:
            return things
        from scipy.spatial import KDTree

        ways, near = KDTree(self._centres[things]).query(self._centres[things], k=GROUP)
        heart = int(np.argmin(np.round(ways[:, -1], 3)))
        return sorted(things[place] for place in near[heart].tolist())
