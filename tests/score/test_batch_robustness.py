"""Batch rows of any shape: one answer a row, never a stop; files are read row by row."""

from __future__ import annotations

import gzip
import json
import tracemalloc
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.cli.batches import read_rows, write_rows
from c4s.errors import BadInput
from c4s.score.batch import KINDS, score_batch, score_row
from c4s.verify.physics.batch import support_row
from c4s.verify.repair.batch import repair_row
from tests.verify_repair.repair_scenes import actor, scene

SCALARS = st.sampled_from(
    [
        None,
        True,
        False,
        0,
        -1,
        2,
        0.5,
        -0.0,
        float("nan"),
        float("inf"),
        10**400,
        "",
        "measured",
        "logic",
        "\ud800",
        "\n",
    ]
)
ODD = (
    SCALARS
    | st.lists(SCALARS, max_size=3)
    | st.dictionaries(st.sampled_from(["id", "score", "x"]), SCALARS, max_size=2)
)
LEAF = {"leaf_id": "floating", "status": "measured", "score": 0.5, "metadata": {"score_direction": "lower_is_better"}}
DECISION = {
    "semantic_family": "content_quantity",
    "clause_index": 0,
    "effective_score": 0.5,
    "included": True,
    "predicate_weight": 1.0,
    "score_known": True,
    "unrounded_effective_score": 0.5,
}
REQUIREMENT = {
    "node_id": "a",
    "text": "a barn",
    "source_span": [0, 6],
    "predicate_type": "spatial_relation",
    "evaluation_status": "MATCH",
    "entity_scopes": {"e": "all"},
    "score": 0.5,
    "check": {"score": 1},
    "evaluation_binding": {"parameters": {"predicate_type": "count"}, "entity_scopes": {}},
}
DIMENSIONS = dict.fromkeys(
    ("global_prompt_alignment", "composition_and_layout", "style_atmosphere_coherence", "completeness_and_polish"), 0.5
)
ROWS: dict[str, dict[str, Any]] = {
    "t2s_case": {"valid": True, "detailed": 0.5, "overview": 0.5, "physics": 0.5},
    "i2s_case": {"valid": True, "repair_f1": 0.5, "physics_score": 0.5},
    "physics_report": {
        "report": {
            "status": "measured",
            "score": 0.5,
            "metrics": {"leaf_results": [LEAF], "leaf_score_directions": {"floating": "lower_is_better"}},
        }
    },
    "overview_judgement": {"dimension_scores": DIMENSIONS, "structural_score": 1.0, "severe_cap_eligible": True},
    "overview_report": {
        "report": {
            "status": "measured",
            "metrics": {
                "dimensions": {name: {"score": value} for name, value in DIMENSIONS.items()},
                "structural_integrity_score": 1.0,
                "severe_structural_cap_eligible": False,
            },
        }
    },
    "detailed_decisions": {"decisions": [DECISION, DECISION | {"clause_index": None}]},
    "detailed_report": {
        "report": {"status": "measured", "metrics": {"semantic_requirement_aggregation": [DECISION, DECISION]}}
    },
    "semantic_case": {
        "prompt": "a barn. a hen",
        "family_weights": {"content_quantity": 2.0},
        "requirements": [
            REQUIREMENT,
            REQUIREMENT | {"source_span": {"start": 2, "end": 6}, "predicate_type": "existence"},
        ],
    },
    "semantic_graph": {
        "requirements": [REQUIREMENT],
        "graph": {
            "nodes": [{"id": "a", "predicate_type": "logic"}, {"id": "b", "predicate_type": "count"}],
            "edges": [{"edge_type": "scope", "source_id": "a", "target_id": "b"}],
        },
    },
    "model": {
        "missing_as_zero": True,
        "schedule": {"t2s": ["c"], "indoor": ["d", "e"]},
        "rows": [
            {"model": "m", "setting": "t2s", "case_id": "c", "status": "measured", "score": 0.5},
            {"model": "m", "setting": "indoor", "case_id": "d", "score": "0.5", "repair_f1": 0.5},
        ],
    },
}
CHAIR = actor("chair", "Chair", (0, 0, 10))
SCENES = {
    "input": scene(CHAIR, actor("plant", "Plant", (50, 0, 0))),
    "ground_truth": scene(CHAIR),
    "candidate": scene(CHAIR, actor("new", "Chair", (9, 9, 9))),
}


def places(value: Any) -> list[tuple[Any, ...]]:
    """Every path into nested data."""
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    return [path for key, inner in items for path in [(key,), *((key, *rest) for rest in places(inner))]]


@st.composite
def damaged(draw: st.DrawFn, given: dict[str, Any]) -> dict[str, Any]:
    """The data with one or two of its parts replaced or dropped."""
    result: dict[str, Any] = deepcopy(given)
    for _ in range(draw(st.integers(1, 2))):
        *way, last = draw(st.sampled_from(places(result) or [("x",)]))
        holder: Any = result
        for key in way:
            holder = holder[key]
        if isinstance(holder, dict) and draw(st.booleans()):
            holder.pop(last, None)
        else:
            holder[last] = draw(ODD)
    return result


def answered(answer: dict[str, Any]) -> bool:
    line = json.dumps(answer)
    return "name" in answer and "\n" not in line and (set(answer) == {"name", "error"} or "error" not in answer)


@pytest.mark.parametrize("kind", sorted(KINDS))
@settings(max_examples=120, deadline=None)
@given(data=st.data())
def test_every_scoring_row_has_an_answer(kind: str, data: st.DataObject) -> None:
    assert "error" not in score_row({"name": "n", "kind": kind, "input": ROWS[kind]})
    assert answered(score_row({"name": "n", "kind": kind, "input": data.draw(damaged(ROWS[kind]))}))


@settings(max_examples=300, deadline=None)
@given(damaged({"scene": SCENES["input"]}))
def test_every_support_row_has_an_answer(row: dict[str, Any]) -> None:
    assert answered(support_row({"name": "n", **row}))


@settings(max_examples=300, deadline=None)
@given(damaged(SCENES))
def test_every_repair_row_has_an_answer(row: dict[str, Any]) -> None:
    assert answered(repair_row({"name": "n", **row}))


def test_rows_are_read_one_at_a_time(tmp_path: Path) -> None:
    line = json.dumps({"name": "row", "kind": "i2s_case", "input": {"valid": True, "filler": "x" * 400}}) + "\n"
    for path, opened in ((tmp_path / "rows.jsonl", open), (tmp_path / "rows.jsonl.gz", gzip.open)):
        with opened(path, "wt") as out:
            for _ in range(20_000):
                out.write(line)
        tracemalloc.start()
        assert sum(isinstance(row, dict) for row in read_rows(path)) == 20_000
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        assert peak < 1_000_000 < 20_000 * len(line)


def test_a_line_that_is_no_row_stops_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    good = {"name": "\ud800ü", "kind": "i2s_case", "input": {"valid": True, "repair_f1": 1, "physics_score": 1}}
    path = tmp_path / "rows.jsonl"
    path.write_text("\n".join(['{"name": "cut', json.dumps(good), "", "[1]", "NaN", json.dumps(good)]))
    write_rows(path, score_batch)
    answers = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert [answer.get("score") for answer in answers] == [None, 1.0, None, None, 1.0]
    assert [answer["error"].startswith(f"row {n} is not") for n, answer in ((1, answers[0]), (3, answers[2]))]
    assert answers[1]["name"] == good["name"]


def test_a_file_that_is_missing_or_cut_off_is_one_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(BadInput, match="no such file"):
        write_rows(tmp_path / "absent.jsonl", score_batch)
    path = tmp_path / "rows.jsonl.gz"
    path.write_bytes(gzip.compress(b'{"name": "n"}\n' * 5000)[:-20])
    with pytest.raises(BadInput, match="cannot read this file to its end") as caught:
        write_rows(path, score_batch)
    assert "\n" not in caught.value.line() and capsys.readouterr().out.count("\n") > 0
