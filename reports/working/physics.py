"""Physical safety from its two leaves, each a share of the actors that are eligible for it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from c4s.protocol.physics import safety
from c4s.protocol.rules import PHYSICS_DIGITS, PHYSICS_LEAF_WEIGHTS
from c4s.verify.physics.verifier import PHYSICS
from reports.working.flow import COUNT, Addend, Step

TITLES = {"floating": "Support", "solid_penetration": "No penetration"}


def physics_step(document: Mapping[str, Any], weights: Mapping[str, float] = PHYSICS_LEAF_WEIGHTS) -> Step:
    """Support and freedom from penetration, as published half and half; a leaf without a number is worth zero."""
    measured = document["measurements"]
    results = {leaf["leaf_id"]: leaf for leaf in measured.get("leaf_results", [])}
    inner, parts = [], []
    for name, weight in weights.items():
        stored = measured.get("leaves", {}).get(name, {})
        leaf = results.get(name, {})
        step = _leaf(name, leaf, stored)
        inner.append(step)
        note = "" if step.made is not None else str(leaf.get("reason") or leaf.get("status") or "missing")
        parts.append(Addend(TITLES[name], step.made or 0.0, weight, note))
    total = 0.0
    for part in parts:
        total += part.share or 0.0
    return Step(
        PHYSICS.name,
        "Physical safety",
        f"{' + '.join(f'{weight:g} {TITLES[name].lower()}' for name, weight in weights.items())}, 4 decimals",
        parts,
        round(total, PHYSICS_DIGITS),
        document["score"],
        inner=inner,
    )


def _leaf(name: str, leaf: Mapping[str, Any], stored: Mapping[str, Any]) -> Step:
    """A leaf's safety from how many of its population failed; without a count from its own rate."""
    evaluated, failed, unresolved = (int(leaf.get(key) or 0) for key in ("evaluated", "failed", "unresolved"))
    direction = stored.get("direction") or leaf.get("metadata", {}).get("score_direction")
    measured = leaf.get("status") == "measured"
    parts = [
        Addend("eligible and evaluated", float(evaluated), kind=COUNT),
        Addend("failed", float(failed), kind=COUNT),
        *([Addend("without evidence", float(unresolved), kind=COUNT)] if unresolved else []),
        *([Addend("set aside", float(leaf["excluded"]), kind=COUNT)] if leaf.get("excluded") else []),
    ]
    made = None
    if measured:
        bad = direction == "lower_is_better"
        share = (failed if bad else evaluated - failed) / evaluated if evaluated else float(not bad)
        raw = round(share, PHYSICS_DIGITS) if evaluated and not unresolved else float(leaf["score"])
        made = safety(raw, direction)
    rule = "1 − failed / evaluated" if direction == "lower_is_better" else "(evaluated − failed) / evaluated"
    note = "" if measured else f"{leaf.get('status', 'missing')}: {leaf.get('reason') or 'worth zero'}"
    if measured and not evaluated:
        note = "nothing was eligible: neutral"
    elif measured and unresolved:
        note = "with actors without evidence: as the verdict tells the rate"
    return Step(f"physics-{name}", TITLES[name], f"{rule}, 4 decimals", parts, made, stored.get("safety"), note=note)
