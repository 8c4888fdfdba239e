"""Verdict documents and Python submissions of a made warehouse, with what was planted in them.

Each repair recovers its targets or not and changes other actors or not; each text has spatial requirements whose
entities are there or not; each script holds operations and shows errors. All of it is drawn apart from scores.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Final

import numpy as np

from c4s.files import canonical_json
from c4s.protocol.settings import is_construction
from c4s.trajectory import FAMILIES

COMPLETE, SPOILT, KEPT, MISMATCHED, FAILED = 0.6, 0.35, 0.2, 0.25, 0.3
"""Chances: of a complete repair, of false positives in it, of a spatial requirement whose entities are all there, of a
mismatch among those, of a script that shows an error."""
REQUIREMENTS, SCRIPTS = 12, 4
"""Spatial requirements of a text, and scripts of a run."""
KINDS: Final = ("added", "background_changed", "background_lost", "background_repurposed")
_FIELDS: Final = (["transform.location"], ["property.material_paths"], ["property.material_paths"])
_PREDICATES: Final = ("spatial_relation", "distribution", "composition")
_ERRORS: Final = ("AttributeError", "TypeError", "RuntimeError")


def made_verdicts(
    key: dict[str, Any], case: dict[str, Any], random: np.random.Generator
) -> Iterator[tuple[str, dict[str, Any]]]:
    """The rows of a trial in the tables ``verdicts`` and ``python_submissions``."""
    text = is_construction(case["setting"])
    measured = _spatial(random) if text else _repair(random)
    document = {"measurements": measured, "population": {}, "advisories": []}
    yield (
        "verdicts",
        {
            **key,
            "verifier": "detailed" if text else "repair",
            "status": "measured",
            "score": 0.5,
            "reason": "",
            "policy": "made",
            "document": canonical_json(document),
            "verdict_sha256": "0" * 64,
        },
    )
    for call in range(1, SCRIPTS + 1):
        held = [family for family in FAMILIES if random.random() < 0.4]
        parses = random.random() < 0.9
        failed = random.random() < FAILED
        yield (
            "python_submissions",
            {
                **key,
                "attempt": 1,
                "recorded": True,
                "call": call,
                "parseable": parses,
                "families": " ".join(held) if parses else "",
                "feedback": failed or random.random() < 0.8,
                "failed": failed,
                "errors": str(random.choice(_ERRORS)) if failed else "",
            },
        )


def _repair(random: np.random.Generator) -> dict[str, Any]:
    complete, spoilt = random.random() < COMPLETE, random.random() < SPOILT
    found = [_false_positive(random) for _ in range(int(random.integers(1, 3)))] if spoilt else []
    missed = 0 if complete else int(random.integers(1, 3))
    counts = {"tp": 3 - missed, "fp": len(found), "fn": missed}
    strict = counts | {"fn": max(missed, int(random.random() < 0.1))}
    relaxed = counts | {"fn": 0 if random.random() < 0.1 else missed}
    profiles = {"strict": strict, "nominal": counts, "relaxed": relaxed}
    return {**counts, "false_positives": found, "profiles": profiles}


def _false_positive(random: np.random.Generator) -> dict[str, Any]:
    kind = str(random.choice(KINDS))
    row: dict[str, Any] = {"actor": f"Actor_{int(random.integers(1000))}", "kind": kind}
    if kind == "background_changed":
        place = int(random.integers(len(_FIELDS)))
        row |= {"fields": _FIELDS[place], "renamed_material": place == 2}
    return row


def _spatial(random: np.random.Generator) -> dict[str, Any]:
    decisions = []
    for place in range(REQUIREMENTS):
        there = random.random() < KEPT
        answer = "MISMATCH" if random.random() < MISMATCHED else "UNKNOWN" if random.random() < 0.1 else "MATCH"
        decisions.append(
            {
                "node_id": f"predicate-{place}",
                "predicate_type": _PREDICATES[place % len(_PREDICATES)],
                "status": answer,
                "existence": {"pass": there},
            }
        )
    return {"decisions": decisions}
