"""Which things of a scene the entities of a prompt stand for, and what can be said where there are none."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Final

from c4s.protocol.bundle import Entity, Requirements
from c4s.records.binding import Binding
from c4s.semantics.binding import bind
from c4s.semantics.decision import Decision, decided, unknown
from c4s.semantics.inventory import Thing, catalog_path, landscapes, placed, unmeshed
from c4s.semantics.kinds import Facts, ThingKind, leaf
from c4s.semantics.substance import Substance, substance

SURFACE: Final = "surface"
"""Kind of an entity that others stand on."""


class Grounding:
    """The things of one scene by the entities of one bundle. Only things that count (``c4s.semantics.substance``)."""

    def __init__(
        self,
        requirements: Requirements,
        snapshot: Mapping[str, Any],
        catalog: Mapping[str, Facts],
        binding: Binding | None = None,
    ) -> None:
        self.requirements = requirements
        things, self._unread = placed(snapshot, catalog)
        self.landscapes = landscapes(snapshot)
        self.substance: Substance = substance(things, self.landscapes)
        self.things = self.substance.counted
        kinds = list(dict.fromkeys(thing.kind for thing in things))
        self.closed = not self._unread and all(kind.facts is not None and not kind.basic_shape for kind in kinds)
        """Every placed object is a known catalog asset in a known place, so what is not named is not there."""
        found = binding or bind(requirements, catalog)
        self._bindable = {entity_id for entity_id, entity in found.entities.items() if entity.assets}
        self._bound, self._proposed = _kinds_of(requirements, kinds, catalog, found)
        classes = {path: {"name": leaf(path)} for path in sorted(unmeshed(snapshot))}
        self._unmeshed = {key: one.assets for key, one in bind(requirements, classes).entities.items() if one.assets}
        self._counted = _by_kind(self.things)
        self._aside = _by_kind(itertools.chain.from_iterable(self.substance.aside.values()))
        self._named: dict[tuple[ThingKind, ...], list[Thing]] = {}

    def kinds(self, entity_id: str) -> tuple[ThingKind, ...]:
        """The kinds among the placed things that an entity names."""
        return self._bound.get(entity_id, ())

    def ground(self, entity_id: str) -> list[Thing]:
        """The things that an entity names and that count, in the order of the scene."""
        kinds = self.kinds(entity_id)
        if kinds not in self._named:
            places = sorted(place for kind in kinds for place, _ in self._counted.get(kind, ()))
            self._named[kinds] = [self.things[place] for place in places]
        return self._named[kinds]

    def set_aside(self, entity_ids: Sequence[str]) -> int:
        """How many placed things the entities name that do not count."""
        kinds = {kind for entity_id in entity_ids for kind in self.kinds(entity_id)}
        return sum(len(self._aside.get(kind, ())) for kind in kinds)

    def in_doubt(self, entity_ids: Sequence[str]) -> int:
        """How many placed things that are not named so may be of these entities: proposed, primitive, unknown, or in a
        place that nobody can tell."""
        maybe = {kind for entity in self.entities(entity_ids) for kind in self._proposed.get(entity.id, ())}
        if any(entity.is_object for entity in self.entities(entity_ids)):
            maybe |= {kind for kind in self._counted if kind.facts is None or kind.basic_shape}
        maybe -= {kind for entity_id in entity_ids for kind in self.kinds(entity_id)}
        return self._unread + sum(len(self._counted.get(kind, ())) for kind in maybe)

    def divided(self, entity_ids: Sequence[str]) -> bool:
        """Whether another entity names things of the same kinds: which of them are meant here state cannot tell."""
        mine = {kind for entity_id in entity_ids for kind in self.kinds(entity_id)}
        others = (kinds for entity_id, kinds in self._bound.items() if entity_id not in entity_ids)
        return any(not mine.isdisjoint(kinds) for kinds in others)

    def has_place(self, ids: Sequence[str]) -> bool:
        """Whether state can say where all these entities are: objects, and regions that the catalog has assets for."""
        return all(entity.is_object or entity.id in self._bindable for entity in self.entities(ids))

    def entities(self, ids: Sequence[str]) -> list[Entity]:
        """The entities of the bundle among these."""
        return [self.requirements.entities[i] for i in ids if i in self.requirements.entities]

    def collective(self, ids: Sequence[str]) -> bool:
        """Whether any of the entities is a collection."""
        return any(entity.collection for entity in self.entities(ids))

    def laid(self, ids: Sequence[str]) -> bool:
        """Whether all of the entities are surfaces: a ground of many tiles is one thing to stand on."""
        return all(entity.kind == SURFACE for entity in self.entities(ids))

    def present(self, entity_ids: Sequence[str]) -> tuple[list[Thing], Decision | None]:
        """Things of the entities, or the decision when there are none."""
        named = {id(things): things for things in map(self.ground, entity_ids)}
        things = list(dict.fromkeys(itertools.chain.from_iterable(named.values())))
        if things:
            return things, None
        entities = self.entities(entity_ids)
        regions = not all(entity.is_object for entity in entities)
        if not self.things and not self.substance.aside and not self._unread and not (regions and self.landscapes):
            return [], decided(False, "the scene holds no object")
        if not entities:
            return [], unknown("the requirement names no entity")
        wanted = " / ".join(entity.names[0] for entity in entities if entity.names)
        if set_aside := self.set_aside(entity_ids):
            return [], unknown(f"{set_aside} placed as {wanted}, none of which counts")
        if any(self._proposed.get(entity.id) for entity in entities):
            return [], unknown(f"what may be a {wanted} is not named so")
        if lit := [path for entity in entities for path in self._unmeshed.get(entity.id, ())]:
            return [], unknown(f"a {leaf(lit[0])} is there, which no box tells of")
        if regions:
            return [], unknown(f"{wanted} is a region that has to be seen")
        if not all(entity.id in self._bindable for entity in entities):
            return [], unknown(f"no asset of the catalog is a {wanted}; others may make one up")
        if self.closed:
            return [], decided(False, f"no object of the scene is a {wanted}")
        return [], unknown(f"no object is named {wanted}, but some objects are primitives, unknown or unplaced")


def _kinds_of(
    requirements: Requirements, kinds: Sequence[ThingKind], catalog: Mapping[str, Facts], found: Binding
) -> tuple[dict[str, tuple[ThingKind, ...]], dict[str, tuple[ThingKind, ...]]]:
    """Which of the placed kinds each entity names, and which of them are proposed for it.

    Of what no catalog holds the name of the asset is read, where it can be trusted (``inventory.trusted``).
    """
    own = {kind.asset: {"name": leaf(kind.asset)} for kind in kinds if kind.facts is None and kind.named}
    others = bind(requirements, own)
    known = {kind: catalog_path(kind.asset, catalog) or kind.asset for kind in kinds}
    named, proposed = {}, {}
    for entity_id in requirements.entities:
        ends = [found.entities.get(entity_id), others.entities[entity_id]]
        assets = {asset for one in ends if one is not None for asset in one.assets}
        maybe = {proposal.asset for one in ends if one is not None for proposal in one.proposed}
        named[entity_id] = tuple(kind for kind in kinds if known[kind] in assets)
        proposed[entity_id] = tuple(kind for kind in kinds if known[kind] in maybe)
    return named, proposed


def _by_kind(things: Iterable[Thing]) -> dict[ThingKind, list[tuple[int, Thing]]]:
    rows: dict[ThingKind, list[tuple[int, Thing]]] = {}
    for place, thing in enumerate(things):
        rows.setdefault(thing.kind, []).append((place, thing))
    return rows
