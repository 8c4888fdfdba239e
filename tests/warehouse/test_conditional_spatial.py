"""The conditional spatial analysis on a made case table whose truth is known, from judgements to the question."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from c4s.files import canonical_json
from c4s.records.judgement import Answer, ClaimJudgement, Judgements
from c4s.records.verdict import Verdict
from c4s.verify.semantic.detailed import verify_detailed
from tests.warehouse.made_rows import store_schedule, trial_row
from warehouse.database import rebuild, rows
from warehouse.parquet import write_part
from warehouse.records import VerdictRow

ENTITIES = ("desk", "lamp", "cups", "door", "shelf")
CHECKS: dict[str, dict[str, Any]] = {
    "desk is there": {"about": ["desk"]},
    "lamp is there": {"about": ["lamp"]},
    "lamp stands": {"about": ["lamp"]},
    "red cups are there": {"about": ["cups"], "qualifiers": [{"kind": "color", "name": "red"}]},
    "no door": {"about": ["door"], "polarity": "negative"},
    "three shelves": {"about": ["shelf"], "quantity": {"mode": "exact", "value": 3}},
    "shelf on the desk": {"about": ["shelf"], "relation": "on"},
    "desk and shelf": {"about": ["desk", "shelf"]},
}
SPATIAL: dict[str, tuple[str, list[str], bool]] = {
    "desk under lamp": ("spatial_relation", ["desk", "lamp"], True),
    "desk in a row": ("distribution", ["desk"], True),
    "desk is ordered": ("composition", ["desk"], True),
    "lamp beside cups": ("spatial_relation", ["lamp", "cups"], False),
    "desk faces door": ("spatial_relation", ["desk", "door"], False),
    "desk by shelf": ("spatial_relation", ["desk", "shelf"], False),
    "all is dense": ("composition", [], False),
}
"""Kind, entities, and whether all of them pass a separate, affirmative, unqualified check."""


def bundle() -> dict[str, Any]:
    """The claims as a requirement bundle."""
    prompt = " ".join(f"{text}." for text in (*CHECKS, *SPATIAL))
    nodes: list[dict[str, Any]] = [{"node_type": "entity", "id": name, "name": name} for name in ENTITIES]
    edges = []
    asked = {text: ("existence", check["about"], check) for text, check in CHECKS.items()}
    asked |= {text: (kind, about, {}) for text, (kind, about, _) in SPATIAL.items()}
    for text, (kind, about, check) in asked.items():
        start = prompt.index(f"{text}.")
        nodes.append(
            {
                "node_type": "predicate",
                "id": text,
                "text": text,
                "predicate_type": kind,
                "polarity": check.get("polarity", "affirmative"),
                "source_span": {"start": start, "end": start + len(text)},
                "semantic_parameters": {name: check.get(name) for name in ("relation", "quantity", "qualifiers")},
            }
        )
        edges += [
            {"edge_type": "argument", "source_id": text, "target_id": entity, "ordinal": number, "role": "subject"}
            for number, entity in enumerate(about)
        ]
    scored = [{"node_id": text, "entity_scopes": {}} for text in asked]
    return {"graph": {"prompt": prompt, "nodes": nodes, "edges": edges}, "requirements": scored}


def verdict(**other: Answer) -> Verdict:
    """The verdict where all is met but what is named, with blanks for underscores."""
    answers: dict[str, Answer] = dict.fromkeys((*CHECKS, *SPATIAL), "MATCH")
    answers |= {name.replace("_", " "): answer for name, answer in other.items()}
    claims = [ClaimJudgement(claim=name, answer=one, score=float(one == "MATCH")) for name, one in answers.items()]
    return verify_detailed(bundle(), Judgements(judge="made", judge_version="1", claims=claims))


def kept(made: Verdict) -> dict[str, bool]:
    """Whether each spatial claim is kept."""
    decisions = made.measurements["decisions"]
    return {row["node_id"]: row["existence"]["pass"] for row in decisions if row["existence"] is not None}


def test_a_claim_is_kept_where_every_entity_passes_a_check_that_says_no_more() -> None:
    assert kept(verdict()) == {name: wanted for name, (_, _, wanted) in SPATIAL.items()}


def test_missing_contradictory_and_open_evidence_leaves_a_claim_out() -> None:
    of_lamp = [name for name, (_, about, wanted) in SPATIAL.items() if wanted and "lamp" in about]
    answers: tuple[Answer, ...] = ("MISMATCH", "UNKNOWN", "NOT_EVALUATED", "ERROR")
    for answer in answers:
        found = kept(verdict(lamp_stands=answer))
        assert of_lamp and not any(found[name] for name in of_lamp) and found["desk in a row"]
    (row,) = [row for row in verdict(lamp_stands="MISMATCH").measurements["decisions"] if row["node_id"] == of_lamp[0]]
    assert row["existence"]["entities"] == {
        "desk": {"desk is there": "MATCH"},
        "lamp": {"lamp is there": "MATCH", "lamp stands": "MISMATCH"},
    }


def store(root: Path, number: int, made: Verdict) -> None:
    """A verdict of a trial in a warehouse."""
    row = VerdictRow(
        **trial_row(number),
        verifier=made.verifier,
        status=made.status,
        score=made.score,
        reason=made.reason,
        policy=made.policy,
        document=canonical_json(made.plain()),
        verdict_sha256="0",
    )
    write_part(root, "verdicts", [row], suite="s", configuration="alpha", key=row.trial_id)


def test_the_question_counts_direct_answers_by_kind_among_what_is_kept(tmp_path: Path) -> None:
    """Of the relations one in two kept scenes is not met; distribution is left open once, which is no mismatch."""
    store_schedule(tmp_path, range(3))
    store(tmp_path, 0, verdict(desk_under_lamp="MISMATCH", desk_by_shelf="MISMATCH"))
    store(tmp_path, 1, verdict(desk_in_a_row="UNKNOWN", all_is_dense="MISMATCH"))
    store(tmp_path, 2, verdict(desk_is_there="UNKNOWN", desk_under_lamp="MISMATCH"))
    rebuild(tmp_path)
    found = rows(tmp_path, "SELECT * FROM conditional_spatial WHERE configuration = 'alpha'")
    told = {
        row["predicate_type"]: [
            row[name] for name in ("requirements", "kept", "mismatches", "undecided", "mismatch_rate")
        ]
        for row in found
    }
    assert told == {
        "spatial_relation": [12, 2, 1, 0, 0.5],
        "distribution": [3, 2, 0, 1, 0.0],
        "composition": [6, 2, 0, 0, 0.0],
    }
    whole = rows(tmp_path, "SELECT * FROM conditional_spatial WHERE configuration IS NULL")
    assert [row | {"configuration": "alpha"} for row in whole] == found
