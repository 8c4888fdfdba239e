"""Where things stand to each other: decided where the boxes leave no doubt, else left open to be seen."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from c4s.protocol.bundle import Predicate
from c4s.semantics.boxes import Flags
from c4s.semantics.compass import sides
from c4s.semantics.decision import SHARE, Decision, actor_names, decided, shared, unknown
from c4s.semantics.distributions import LAYOUTS, Layout, angular_gap, plan_centres, scattered
from c4s.semantics.grounding import Grounding
from c4s.semantics.hull import in_ring
from c4s.semantics.inventory import Thing
from c4s.semantics.relation_words import BETWEEN_REFERENCES, INVERSE, relation_of, side_of
from c4s.semantics.relations import LOOSE, RELATIONS, STRICT, taken

OPEN_SHARE = 0.25
"""From this share of a collection on it may be that others of the kind are not meant: it has to be seen."""
AROUND_GAP_DEG = 150.0
"""What stands around something leaves no larger angle empty."""


class Spatial:
    """Decides relations and distributions of one scene."""

    def __init__(self, grounding: Grounding) -> None:
        self._grounding = grounding
        self._related: dict[tuple[str, tuple[str, ...], tuple[str, ...]], Decision] = {}
        self._sides: dict[str, tuple[float, float]] | None = None

    def relation(self, predicate: Predicate) -> Decision:
        """A relation of the predicate's subjects to its references."""
        subjects, absent = self._grounding.present(predicate.subjects)
        if absent:
            return absent
        if not predicate.references:
            return unknown("the relation names no reference", actor_names(subjects))
        references, missing = self._grounding.present(predicate.references)
        if missing:
            return missing
        if side_of(predicate.relation) is not None:
            return self._side(predicate)
        relation = relation_of(predicate.relation)
        if relation is None:
            return unknown(
                f"the relation {predicate.relation or 'given'} is not decidable by geometry", actor_names(subjects)
            )
        sides = tuple(predicate.subjects), tuple(predicate.references)
        if relation.endswith(INVERSE) or relation == BETWEEN_REFERENCES:
            subjects, references, sides = references, subjects, sides[::-1]
            relation = "between" if relation == BETWEEN_REFERENCES else relation.removesuffix(INVERSE)
        among = set(subjects)
        others = [thing for thing in references if thing not in among] or references
        if relation == "around":
            return self._around(subjects, others, sides[0])
        if (relation, *sides) not in self._related:
            self._related[relation, *sides] = self._held(relation, subjects, others, sides)
        return self._related[relation, *sides]

    def _held(
        self, relation: str, subjects: Sequence[Thing], others: Sequence[Thing], sides: tuple[tuple[str, ...], ...]
    ) -> Decision:
        """How many subjects surely stand in a relation, and how many may."""
        individual = not self._grounding.collective(sides[0])
        surely = RELATIONS[relation](subjects, others, STRICT)
        holding = [subjects[place] for place in np.flatnonzero(surely).tolist()]
        made = shared(subjects, holding, f"{relation} {len(others)} reference(s)", any_suffices=individual)
        if made.status == "MATCH":
            apiece = not individual and self._grounding.collective(sides[1]) and not self._grounding.laid(sides[1])
            crowded = taken(relation, holding, others) if apiece else None
            if crowded is not None and crowded.sum() < SHARE * min(len(holding), len(others)):
                return unknown(f"{relation} a few of {len(others)} references only", made.actors)
            return made
        maybe = RELATIONS[relation](subjects, others, LOOSE)
        if self._may_be_meant(maybe, sides[0]):
            return unknown(f"{relation}, by the measures, is open", actor_names(subjects))
        return replace(made, partly=bool(maybe.any()))

    def _may_be_meant(self, maybe: Flags, ids: Sequence[str]) -> bool:
        """Whether those that may satisfy a claim are enough to leave it open: any of an individual and of a collection
        that another entity shares, else a quarter."""
        if not self._grounding.collective(ids) or self._grounding.divided(ids):
            return bool(maybe.any())
        return bool(maybe.sum() >= 2 and maybe.mean() >= OPEN_SHARE)

    def _side(self, predicate: Predicate) -> Decision:
        """A side of the compass, as it is laid for all claims of sides together."""
        if self._sides is None:
            claims = {}
            for node, other in self._grounding.requirements.predicates.items():
                side = side_of(other.relation)
                if other.type == "spatial_relation" and side is not None and other.references:
                    subjects = self._grounding.present(other.subjects)[0]
                    references = self._grounding.present(other.references)[0]
                    if subjects and references:
                        claims[node] = (side, subjects, references)
            self._sides = sides(claims)
        if predicate.id not in self._sides:
            return unknown("where north is cannot be told", actor_names(self._grounding.present(predicate.subjects)[0]))
        (share, half), things = self._sides[predicate.id], self._grounding.present(predicate.subjects)[0]
        if share < SHARE and half >= OPEN_SHARE:
            return unknown("partly on that side", actor_names(things))
        if share < SHARE and half > 0 and self._grounding.divided(predicate.subjects):
            return unknown("some are on that side, and others of the prompt are named so", actor_names(things))
        return Decision(
            "MATCH" if share >= SHARE else "MISMATCH",
            share,
            f"{predicate.relation}, north where it suits all claims of sides best",
            actor_names(things),
            {"share": round(share, 4)},
            partly=share < SHARE and half > 0,
        )

    def _around(self, subjects: Sequence[Thing], references: Sequence[Thing], ids: Sequence[str]) -> Decision:
        """All round what the subjects hold in their midst; what is near on some sides only, or far on all, is open."""
        close = RELATIONS["near"](subjects, references, LOOSE)
        if len(subjects) >= 3:
            places, around = plan_centres(references), plan_centres(subjects)
            held = in_ring(places, around)
            gap = angular_gap(around, places[held].mean(axis=0)) if held.any() else 360.0
            if gap <= AROUND_GAP_DEG and close.mean() >= SHARE and held.mean() >= SHARE:
                return decided(True, "stand around the references", subjects, largest_gap_deg=round(gap, 1))
            if gap <= AROUND_GAP_DEG or self._may_be_meant(close, ids):
                return unknown("near the references, or on all sides of them far off", actor_names(subjects))
            no = decided(False, "not around the references", subjects, largest_gap_deg=round(gap, 1))
            return replace(no, partly=bool(close.any()))
        holding = [
            thing
            for thing in subjects
            if any(np.all(thing.low[:2] <= o.low[:2]) and np.all(thing.high[:2] >= o.high[:2]) for o in references)
        ]
        if holding:
            return decided(True, "one box holds the references' plan", holding)
        if close.any():
            return unknown("near the references", actor_names(subjects))
        return decided(False, "not around the references", subjects)

    def distribution(self, predicate: Predicate) -> Decision:
        """How the predicate's subjects are laid out."""
        things, absent = self._grounding.present(predicate.subjects)
        if absent:
            return absent
        if len(things) < 3:
            return unknown("fewer than three objects have no distribution", actor_names(things))
        layout = layout_of(predicate)
        if layout is None:
            return unknown("the distribution has to be seen", actor_names(things))
        holds, measured, value = layout(things)
        told = round(value, 4)
        if holds is None:
            return unknown(f"{layout.__name__}: {measured} {told} is open", actor_names(things))
        if not holds and self._grounding.divided(predicate.subjects):
            return unknown("which of them are meant cannot be told", actor_names(things))
        return decided(holds, layout.__name__, things, **{measured: told})


def layout_of(predicate: Predicate) -> Layout | None:
    """The test that decides a distribution, by its words; None where none does.

    Its relation goes before its qualifiers, and its text comes last: a ``ring road`` is no ring. What is spread *along*
    something is not scattered.
    """
    said = (predicate.relation or "", " ".join(name for _, name in predicate.qualifiers), predicate.text)
    words = [set(re.findall("[a-z]+", text.lower())) for text in said]
    found = next((layout for one in words for names, layout in LAYOUTS if one & names), None)
    return None if found is scattered and any("along" in one for one in words) else found
