"""Solid penetration: the share of scored solids without a contact deeper than their tolerance (paper, Physical Safety).

A contact counts for each of its two actors against that actor's own tolerance, once an actor. Contacts inside one
logical object and with non-solid colliders do not count. An actor whose own bodies, box or neighbours are not known, or
one of whose contacts has no trusted depth, however shallow, is unresolved unless another contact proves a violation.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from c4s.collision import NOISE_CM, Contact, ContactRule, SceneBodies
from c4s.protocol.rules import FIXED_TOLERANCE_CM, MAXIMUM_TOLERANCE_CM, SHORTEST_SPAN_CM, TOLERANCE_SHARE
from c4s.verify.actors.roles import Role, bounds_of


@dataclass(frozen=True)
class Penetration:
    """Outcome of the check. Actors are positions in the scene."""

    violators: list[int]
    clean: list[int]
    unresolved: dict[int, str]
    """Actor to the reason why it can be neither."""
    tolerances_cm: dict[int, float]
    contacts: dict[int, list[tuple[int, float, bool]]]
    """Per scored actor: (other actor, depth in cm, trusted) of each counted contact, deepest first."""
    noise_cm: float
    """Depths this far beyond the tolerance are not told apart from it."""

    def violating(self, actor: int) -> list[tuple[int, float, bool]]:
        """The actor's trusted contacts beyond its tolerance."""
        limit = self.tolerances_cm[actor] + self.noise_cm
        return [contact for contact in self.contacts[actor] if contact[2] and contact[1] > limit]

    @property
    def score(self) -> float | None:
        """1 - violators / evaluated; None when evidence is missing and nothing is proven, or nothing is evaluated."""
        evaluated = len(self.violators) + len(self.clean)
        if not evaluated or (self.unresolved and not self.violators):
            return None
        return 1 - len(self.violators) / evaluated


def adaptive_tolerance_cm(extent: Sequence[float]) -> float:
    """Text-to-scene tolerance of an actor from its half extents (cm): 5 % of the shortest span, in [5, 50]."""
    shortest = max(2 * min(float(half) for half in extent), SHORTEST_SPAN_CM)
    return min(max(FIXED_TOLERANCE_CM, TOLERANCE_SHARE * shortest), MAXIMUM_TOLERANCE_CM)


def tolerances_cm(
    actors: Sequence[Mapping[str, Any]], role: Sequence[Role], scored: Iterable[int], *, adaptive: bool
) -> dict[int, float]:
    """Tolerance of each scored solid with a valid box: by size (text-to-scene), or 5 cm for all."""
    boxes = {i: bounds_of(actors[i]) for i in scored if role[i] == "scored_solid"}
    return {
        i: adaptive_tolerance_cm(box[1].tolist()) if adaptive else FIXED_TOLERANCE_CM
        for i, box in boxes.items()
        if box is not None
    }


def contact_rule(
    actors: Sequence[Mapping[str, Any]], role: Sequence[Role], tolerances: Mapping[int, float]
) -> ContactRule:
    """Contacts that can count: between solids of different logical objects, judged by the tolerances (cm)."""
    rule = ContactRule.everything(len(actors))
    logical: dict[str, int] = {}
    for index, actor in enumerate(actors):
        rule.solid[index] = role[index] != "non_solid"
        if name := actor.get("logical_object_id"):
            rule.group[index] = logical.setdefault(str(name), len(logical))
    for index, tolerance in tolerances.items():
        rule.limits_cm[index] = tolerance + NOISE_CM
    return rule


def penetration(
    actors: Sequence[Mapping[str, Any]],
    role: Sequence[Role],
    found: Iterable[Contact],
    scene: SceneBodies,
    *,
    scored: Iterable[int],
    tolerances: Mapping[int, float],
    noise_cm: float = 0.0,
) -> Penetration:
    """Judge the scored solids among ``scored``.

    Args:
        actors: all actors of the scene.
        role: their roles.
        found: contacts of the scene (at least those deeper than 5 cm).
        scene: bodies, for which actors are unresolved.
        scored: positions of the population. Its ``scored_solid`` members are judged; those whose role is not known are
            unresolved.
        tolerances: see ``tolerances_cm``.
        noise_cm: rounding of the measured depths.
    """
    targets = [i for i in scored if role[i] == "scored_solid"]
    boxes = {i: bounds_of(actor) for i, actor in enumerate(actors)}
    touching: dict[int, list[tuple[int, float, bool]]] = {i: [] for i in targets}
    for contact in found:
        a, b = contact.a_index, contact.b_index
        if "non_solid" in (role[a], role[b]) or _one_object(actors[a], actors[b]):
            continue
        for mine, other in ((a, b), (b, a)):
            if mine in touching:
                touching[mine].append((other, contact.depth_cm, contact.trusted))
    result = Penetration(
        [],
        [],
        {i: "no valid world box" for i in scored if role[i] == "unresolved"},
        dict(tolerances),
        touching,
        noise_cm,
    )
    held: list[int] = []
    for index in targets:
        touching[index].sort(key=lambda contact: (math.isnan(contact[1]), -contact[1], not contact[2]))
        if result.violating(index):
            result.violators.append(index)
        elif not all(trusted for _, _, trusted in touching[index]):
            result.unresolved[index] = "the depth of a contact could not be confirmed"
        elif index in scene.unresolved:
            result.unresolved[index] = scene.unresolved[index]
        else:
            held.append(index)
    doubtful = _near_unknown(held, boxes, [i for i in scene.unresolved if role[i] != "non_solid"])
    for index in held:
        if index in doubtful:
            result.unresolved[index] = "meets the box of an actor without known collision bodies"
        else:
            result.clean.append(index)
    return result


def _one_object(a: Mapping[str, Any], b: Mapping[str, Any]) -> bool:
    one, other = a.get("logical_object_id"), b.get("logical_object_id")
    return bool(one) and bool(other) and str(one) == str(other)


def _near_unknown(targets: Sequence[int], boxes: Mapping[int, Any], unknown: Sequence[int]) -> set[int]:
    """Targets whose box meets the box of an actor without known bodies (or one without a box at all)."""
    if not unknown:
        return set()
    if any(boxes[i] is None for i in unknown):
        return set(targets)
    origins = np.array([boxes[i][0] for i in unknown])
    extents = np.array([boxes[i][1] for i in unknown])
    own = np.array(unknown)
    return {
        i
        for i in targets
        if bool(((np.abs(origins - boxes[i][0]) <= extents + boxes[i][1]).all(axis=1) & (own != i)).any())
    }
