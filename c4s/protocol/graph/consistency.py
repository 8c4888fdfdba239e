"""Consistency: types, quantities, rows and polarities that agree with each other."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterator, Mapping
from typing import Any, TypeAlias

from c4s.protocol.graph.report import GraphFinding
from c4s.protocol.graph.view import BundleView, Row

Told: TypeAlias = tuple[Any, ...]
ENTITY_TYPES = ("object", "region", "surface")
GROUNDINGS = ("actor", "actor_collection", "derived_region", "scene_global")
REFERENTS = ("individual", "collection")
MODES = {
    "exact": ("value",),
    "approximately": ("value",),
    "at_least": ("value", "lower"),
    "at_most": ("value", "upper"),
    "range": ("lower", "upper"),
    "qualitative": ("qualitative",),
}
"""Modes of a quantity, and the fields that say it: one of them, of a range both."""


def consistency_faults(view: BundleView) -> Iterator[GraphFinding]:
    """What contradicts itself in a bundle whose references resolve."""
    for identity in view.predicates:
        yield from _types(view, identity)
        quantity = view.parameters(identity)["quantity"]
        if quantity is not None:
            yield from _quantity(identity, quantity)
    yield from _known(view)
    yield from _pairs(view)
    yield from _contradictions(view)
    yield from _counts(view)
    yield from _identity(view)


def _types(view: BundleView, identity: str) -> Iterator[GraphFinding]:
    predicate, told = view.predicates[identity], view.parameters(identity)
    kind = predicate["predicate_type"]
    wanted = "presence" if kind == "existence" else kind
    if told["requirement_type"] != wanted:
        yield _fault(
            "consistency.type",
            identity,
            f"its requirement_type is {told['requirement_type']!r}, of a {kind} {wanted!r}",
        )
    needs = {"quantity": "quantity", "count": "quantity", "spatial_relation": "relation", "logic": "logic"}
    field = needs.get(kind)
    if field and told[field] is None:
        yield _fault("consistency.type", identity, f"a {kind} without a {field}")
    if kind in ("attribute", "material") and not told["qualifiers"]:
        yield GraphFinding("consistency.qualifier", "warning", identity, f"a {kind} without a qualifier")
    if told["logic"] is not None:
        operator, parts = told["logic"]["operator"], len(told["logic"]["requirement_ids"])
        if kind not in ("logic", "set"):
            yield _fault("consistency.type", identity, f"a {kind} with logic of its own")
        if parts < (1 if operator in ("not", "none_of") else 2):
            yield _fault("consistency.logic", identity, f"{operator} of {parts} part{'s' if parts != 1 else ''}")


def _quantity(identity: str, quantity: Row) -> Iterator[GraphFinding]:
    mode, numbers = quantity["mode"], {name: quantity[name] for name in ("value", "lower", "upper")}
    if any(number is not None and number < 0 for number in numbers.values()):
        yield _fault("consistency.quantity", identity, "a quantity below 0")
    low = -math.inf if numbers["lower"] is None else numbers["lower"]
    high = math.inf if numbers["upper"] is None else numbers["upper"]
    if low > high:
        yield _fault("consistency.quantity", identity, f"a quantity of at least {low:g} and at most {high:g}")
    elif numbers["value"] is not None and not low <= numbers["value"] <= high:
        yield _fault("consistency.quantity", identity, f"a quantity of {numbers['value']:g} outside its own limits")
    if mode not in MODES:
        yield GraphFinding("consistency.mode", "warning", identity, f"nobody counts by the quantity mode {mode!r}")
        return
    told = [quantity[field] is not None for field in MODES[mode]]
    if not (all(told) if mode == "range" else any(told)):
        yield _fault("consistency.quantity", identity, f"a quantity of mode {mode!r} without its {MODES[mode][-1]}")


def _known(view: BundleView) -> Iterator[GraphFinding]:
    for identity, entity in view.entities.items():
        for field, known in (
            ("entity_type", ENTITY_TYPES),
            ("grounding_mode", GROUNDINGS),
            ("referent_kind", REFERENTS),
        ):
            if entity[field] not in known:
                yield GraphFinding(
                    "consistency.entity", "warning", identity, f"nobody knows the {field} {entity[field]!r}"
                )


def _pairs(view: BundleView) -> Iterator[GraphFinding]:
    """One evaluation a requirement, in one order, with its type."""
    asked = [(row["requirement_id"], row["node_id"]) for row in view.requirements]
    answered = [(row["requirement_id"], row["node_id"]) for row in view.evaluations]
    if asked != answered:
        odd = sorted(set(asked) ^ set(answered))
        place = odd[0][0] if odd else "evaluations"
        yield _fault("consistency.evaluations", place, "evaluations and requirements are not one to one, in one order")
    for row in view.evaluations:
        node = view.predicates.get(row["node_id"])
        if node is not None and row["parameters"].get("predicate_type") != node["predicate_type"]:
            yield _fault(
                "consistency.evaluations", row["binding_id"], "its predicate_type is not that of its predicate"
            )
    for row in view.requirements:
        if row["status"] != "supported":
            yield GraphFinding(
                "consistency.status", "warning", row["requirement_id"], f"its status is {row['status']!r}"
            )


def _told(view: BundleView, identity: str) -> Told:
    """All that a predicate says, without its polarity."""
    node, told = view.predicates[identity], view.parameters(identity)
    qualifiers = tuple(sorted((q["kind"], q["name"].casefold()) for q in told["qualifiers"]))
    quantity = tuple(sorted((key, value) for key, value in (told["quantity"] or {}).items() if value is not None))
    logic = (told["logic"]["operator"], tuple(told["logic"]["requirement_ids"])) if told["logic"] else ()
    return node["predicate_type"], told["relation"], view.named(identity), qualifiers, repr(quantity), logic


def _contradictions(view: BundleView) -> Iterator[GraphFinding]:
    """The same said and denied, or said twice; each among what is scored, where it must hold at once."""
    first: dict[Told, str] = {}
    for identity in view.predicates:
        if identity not in view.scored:
            continue
        told = _told(view, identity)
        other = first.setdefault(told, identity)
        if other == identity:
            continue
        if view.predicates[other]["polarity"] != view.predicates[identity]["polarity"]:
            yield _fault("consistency.polarity", identity, f"it denies what {other!r} says")
        else:
            yield GraphFinding("consistency.twice", "warning", identity, f"it says what {other!r} says")


def _counts(view: BundleView) -> Iterator[GraphFinding]:
    """Counts of one collection that cannot both hold."""
    limits: dict[Told, tuple[str, float, float]] = {}
    for identity in view.predicates:
        if identity not in view.scored or view.predicates[identity]["polarity"] != "affirmative":
            continue
        told = view.parameters(identity)
        quantity, named = told["quantity"], view.named(identity)
        if quantity is None or not named or told["qualifiers"]:
            continue
        low, high = _limits(quantity)
        about = (named, told["relation"])
        if about not in limits:
            limits[about] = identity, low, high
        elif low > limits[about][2] or high < limits[about][1]:
            yield _fault(
                "consistency.count", identity, f"its count cannot hold together with that of {limits[about][0]!r}"
            )


def _limits(quantity: Row) -> tuple[float, float]:
    """What a plain count allows; everything for words and for rough numbers."""
    value, low, high = (quantity[name] for name in ("value", "lower", "upper"))
    if quantity["mode"] == "exact" and value is not None:
        return value, value
    if quantity["mode"] == "at_least":
        return (value if value is not None else low or 0), math.inf
    if quantity["mode"] == "at_most":
        return 0, (value if value is not None else high if high is not None else math.inf)
    if quantity["mode"] == "range" and low is not None and high is not None:
        return low, high
    return 0, math.inf


def _identity(view: BundleView) -> Iterator[GraphFinding]:
    told = view.provenance.get("prompt_sha256")
    if told != hashlib.sha256(view.prompt.encode()).hexdigest():
        yield GraphFinding(
            "consistency.digest", "warning", "provenance", "prompt_sha256 is not the digest of the prompt"
        )
    if not isinstance(told, str) or not view.bundle["bundle_id"].endswith(told[:12]):
        yield GraphFinding(
            "consistency.digest", "warning", "bundle", "its bundle_id does not end in its prompt's digest"
        )
    approved = view.review.get("approved") if isinstance(view.review, Mapping) else None
    if approved is not True:
        yield GraphFinding("consistency.review", "warning", "review", "it is not approved")


def _fault(rule: str, place: str, message: str) -> GraphFinding:
    return GraphFinding(rule, "error", place, message)
