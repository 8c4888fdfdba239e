"""Every sub-rule of the scores at its edge, on rows as the batch command reads them."""

from __future__ import annotations

from typing import Any

import pytest

from c4s.score.batch import score_row

OVERVIEW = {
    "global_prompt_alignment": 1.0,
    "composition_and_layout": 1.0,
    "style_atmosphere_coherence": 1.0,
    "completeness_and_polish": 1.0,
}
FLOATING, SOLID = "floating", "solid_penetration"


def score(kind: str, **given: Any) -> dict[str, Any]:
    return score_row({"name": "row", "kind": kind, "input": given})


def refused(answer: dict[str, Any]) -> bool:
    return set(answer) == {"name", "error"} and "\n" not in answer["error"]


def decision(family: str | None, clause: Any, value: Any = 1.0, **more: Any) -> dict[str, Any]:
    return {"semantic_family": family, "clause_index": clause, "effective_score": value, **more}


def detailed(*rows: Any) -> Any:
    return score("detailed_decisions", decisions=list(rows)).get("score", "refused")


def requirement(text: str, kind: str, status: str = "MATCH", **more: Any) -> dict[str, Any]:
    """A requirement on the words ``text`` of the prompt below."""
    start = PROMPT.index(text)
    return {
        "node_id": text,
        "text": text,
        "source_span": [start, start + len(text)],
        "predicate_type": kind,
        "evaluation_status": status,
        **more,
    }


PROMPT = "A red barn with two oak doors stands by a pond. Hens walk in the yard!? Fog."


def semantic(*rows: dict[str, Any], **more: Any) -> dict[str, Any]:
    found: dict[str, Any] = score("semantic_case", prompt=PROMPT, requirements=list(rows), **more)["semantic_case"]
    return found


class TestDetailed:
    def test_a_clause_is_a_mean_and_a_family_is_a_mean_of_its_clauses(self) -> None:
        assert (
            detailed(
                decision("content_quantity", 0, 1),
                decision("content_quantity", 0, 0),
                decision("content_quantity", 1, 1),
            )
            == 0.75
        )

    def test_absent_families_leave_the_denominator_and_undecided_rows_stay_in_it(self) -> None:
        assert detailed(decision("content_quantity", 0), decision("spatial_composition", 0, 0)) == round(0.4 / 0.6, 4)
        assert detailed(decision("content_quantity", 0, None), decision("content_quantity", 0)) == 0.5

    def test_family_values_are_rounded_before_they_are_averaged(self) -> None:
        thirds = [decision("content_quantity", 0, value) for value in (1, 0, 0)]
        assert detailed(*thirds, decision("spatial_composition", 0)) == round((0.4 * 0.3333 + 0.2) / 0.6, 4)

    def test_excluded_rows_and_unknown_families_do_not_count(self) -> None:
        assert (
            detailed(
                decision("content_quantity", 0, 0),
                decision("content_quantity", 0, 1, included=False),
                decision("decor", 0),
                decision(None, 0),
            )
            == 0.0
        )
        assert detailed(decision("decor", 0)) is None and detailed() is None

    def test_rows_without_a_clause_are_a_clause_of_their_own(self) -> None:
        assert (
            detailed(
                decision("content_quantity", None, 0), decision("content_quantity", 0), decision("content_quantity", 0)
            )
            == 0.5
        )

    @pytest.mark.parametrize(
        ("row", "value"),
        [
            ({"effective_score": 0.3333, "unrounded_effective_score": 1 / 3}, 0.3333),
            ({"effective_score": 0.3333, "unrounded_effective_score": 0.9}, 0.3333),
            ({"effective_score": 0.33333, "unrounded_effective_score": 0.3333}, 0.3333),
            ({"effective_lower": 0.25, "effective_upper": 0.75}, 0.25),
            ({"effective_score_lower_bound": 0.25, "effective_score": 1.0}, 0.25),
            ({"effective_score": True}, 0.0),
            ({"effective_score": "1"}, 0.0),
            ({"effective_score": 1.0000001}, 0.0),
            ({"effective_score": float("nan")}, 0.0),
            ({}, 0.0),
        ],
    )
    def test_the_score_of_a_row(self, row: dict[str, Any], value: float) -> None:
        assert detailed({"semantic_family": "content_quantity", "clause_index": 0} | row) == value

    def test_weights_of_predicates_count_within_and_between_clauses(self) -> None:
        assert (
            detailed(
                decision("content_quantity", 0, 1, predicate_weight=3),
                decision("content_quantity", 0, 0, predicate_weight="1"),
            )
            == 0.75
        )
        assert (
            detailed(decision("content_quantity", 0, 1, predicate_weight=3), decision("content_quantity", 1, 0)) == 0.75
        )

    @pytest.mark.parametrize(
        "row",
        [
            decision("content_quantity", 0, predicate_weight=0),
            decision("content_quantity", 0, predicate_weight=None),
            decision("content_quantity", [0]),
            3,
            None,
        ],
    )
    def test_rows_that_cannot_be_averaged_are_refused(self, row: Any) -> None:
        assert refused(score("detailed_decisions", decisions=[row]))

    def test_clauses_that_cannot_be_ordered_are_refused(self) -> None:
        assert refused(
            score("detailed_decisions", decisions=[decision("content_quantity", 0), decision("content_quantity", "b")])
        )

    def test_known_coverage_is_the_same_mean_over_what_is_known(self) -> None:
        rows = [
            decision("content_quantity", 0, 0, score_known=False),
            decision("content_quantity", 0, 1),
            decision("spatial_composition", 0, 0),
        ]
        assert score("detailed_decisions", decisions=rows)["known_coverage"] == round((0.4 * 0.5 + 0.2) / 0.6, 4)

    @pytest.mark.parametrize("status", ["blocked", "ERROR", "invalid", "not_evaluated", "Refused", "unavailable"])
    def test_unusable_reports_have_no_score(self, status: str) -> None:
        rows = {"semantic_requirement_aggregation": [decision("content_quantity", 0)]}
        assert score("detailed_report", report={"status": status, "metrics": rows})["score"] is None
        assert (
            score(
                "overview_report",
                report={
                    "status": status,
                    "metrics": {
                        "dimensions": {name: {"score": 1} for name in OVERVIEW},
                        "structural_integrity_score": 1,
                    },
                },
            )["score"]
            is None
        )

    @pytest.mark.parametrize("status", ["not_applicable", "partial", "", None, "measured"])
    def test_all_other_statuses_are_used(self, status: Any) -> None:
        rows = {"semantic_requirement_aggregation": [decision("content_quantity", 0)]}
        assert score("detailed_report", report={"status": status, "metrics": rows})["score"] == 1.0


class TestSemanticCase:
    def test_a_row_belongs_to_the_clause_of_its_largest_overlap_the_earliest_on_ties(self) -> None:
        rows = semantic(
            requirement("pond. Hens walk in", "existence"),
            requirement("barn", "existence"),
            requirement("Fog.", "atmosphere"),
            requirement(". H", "existence"),
        )["requirements"]
        assert [row["clause_index"] for row in rows] == [1, 0, 2, 0]

    def test_a_prompt_of_punctuation_is_one_clause(self) -> None:
        case = score(
            "semantic_case", prompt="...", requirements=[{"predicate_type": "existence", "evaluation_status": "MATCH"}]
        )["semantic_case"]
        assert (case["score"], case["clauses"][0]["text"], case["requirements"][0]["source_span"]) == (1, "...", [0, 3])

    @pytest.mark.parametrize(
        ("row", "value", "known"),
        [
            ({"evaluation_status": "MATCH"}, 1.0, True),
            ({"evaluation_status": "MISMATCH"}, 0.0, True),
            ({"evaluation_status": "mismatch ", "score": 0.25}, 0.25, True),
            ({"verdict": "MATCH"}, 1.0, True),
            ({"evaluation_status": "MISMATCH", "score": True, "check": {"score": 0.5}}, 0.5, True),
            ({"evaluation_status": "MATCH", "score": 1.5}, 1.0, True),
            ({"evaluation_status": "ERROR", "score": 1}, 0, False),
            ({"evaluation_status": "UNKNOWN"}, 0.0, False),
            ({}, 0.0, False),
        ],
    )
    def test_a_decision_has_its_score_or_none(self, row: dict[str, Any], value: float, known: bool) -> None:
        case = semantic({"predicate_type": "existence", **row})
        assert (case["score"], case["known_coverage"]) == (value, float(known))

    def test_an_exact_duplicate_counts_once_and_its_words_may_be_spaced_otherwise(self) -> None:
        rows = semantic(
            requirement("oak doors", "material"),
            requirement("oak doors", "material"),
            requirement("oak doors", "material") | {"text": "Oak   DOORS"},
            requirement("oak doors", "attribute"),
            requirement("oak doors", "material", entity_scopes={"e": "all"}),
            requirement("oak doors", "material", evaluation_binding={"parameters": {"side": 1}}),
        )
        assert [row["exclusion_reason"] for row in rows["requirements"]] == [
            None,
            "exact_duplicate",
            "exact_duplicate",
            None,
            None,
            None,
        ]

    def test_a_composite_gives_way_to_what_its_words_hold(self) -> None:
        rows = semantic(
            requirement("two oak doors", "set"),
            requirement("oak", "material"),
            requirement("red barn", "composition"),
            requirement("barn", "existence"),
            requirement("Fog", "logic", semantic_replaced_by_children=True),
        )["requirements"]
        assert [row["exclusion_reason"] for row in rows] == [
            "composite_replaced_by_children",
            None,
            None,
            None,
            "composite_replaced_by_children",
        ]

    def test_a_conjunction_is_capped_by_its_direct_parts_down_all_levels(self) -> None:
        rows = semantic(
            requirement("A red barn with two oak doors", "composition", score=0.9),
            requirement("two oak doors", "spatial_relation", score=0.8),
            requirement("oak", "material", score=0.25),
            requirement("red", "attribute", score=0.5),
        )
        assert [row["effective_score"] for row in rows["requirements"]] == [0.25, 0.25, 0.25, 0.5]
        assert [row["parent_constrained"] for row in rows["requirements"]] == [True, True, False, False]

    def test_only_conjunctions_are_capped_and_only_by_rows_that_count(self) -> None:
        rows = semantic(
            requirement("two oak doors", "attribute"),
            requirement("oak", "material", score=0.0),
            requirement("by a pond", "spatial_relation"),
            requirement("pond", "nonsense", score=0.0),
        )
        assert [row["effective_score"] for row in rows["requirements"]] == [1, 0, 1, 0]

    @pytest.mark.parametrize(
        ("parent", "child", "known"),
        [("MATCH", "ERROR", False), ("ERROR", "MISMATCH", True), ("MISMATCH", "ERROR", True), ("MATCH", "MATCH", True)],
    )
    def test_a_conjunction_is_known_when_all_is_known_or_a_part_is_known_to_be_false(
        self, parent: str, child: str, known: bool
    ) -> None:
        rows = semantic(requirement("by a pond", "spatial_relation", parent), requirement("pond", "existence", child))
        assert rows["requirements"][0]["score_known"] is known

    @pytest.mark.parametrize(
        ("row", "family"),
        [
            ({"predicate_type": "presence"}, "content_quantity"),
            ({"predicate_type": " Material "}, "attributes_materials"),
            ({"evaluation_binding": {"parameters": {"predicate_type": "boundary"}}}, "spatial_composition"),
            ({"predicate_type": "style_bundle"}, "identity_environment"),
            ({"predicate_type": "logic", "semantic_family": "Content_Quantity"}, "content_quantity"),
        ],
    )
    def test_families(self, row: dict[str, Any], family: str) -> None:
        (found,) = semantic({"evaluation_status": "MATCH"} | row)["requirements"]
        assert found["semantic_family"] == family

    @pytest.mark.parametrize(
        "given",
        [
            {"requirements": [{"predicate_type": "logic"}]},
            {"requirements": [{"predicate_type": ""}]},
            {"requirements": [{"predicate_type": "count", "semantic_family": "decor"}]},
            {"requirements": ["x"]},
            {"requirements": [{"predicate_type": "count"}], "family_weights": {"decor": 1}},
            {"requirements": [{"predicate_type": "count"}], "family_weights": {"content_quantity": 0}},
            {"requirements": [{"predicate_type": "count"}], "family_weights": {"content_quantity": True}},
            {"requirements": [{"predicate_type": "count"}], "family_weights": {"content_quantity": None}},
        ],
    )
    def test_cases_that_cannot_be_scored_are_refused(self, given: dict[str, Any]) -> None:
        assert refused(score("semantic_case", prompt=PROMPT, **given))

    def test_requirements_are_named_by_node_by_id_or_by_place(self) -> None:
        rows = semantic(
            {"predicate_type": "count", "requirement_id": "r"},
            {"predicate_type": "set", "id": 7},
            {"predicate_type": "existence"},
        )["requirements"]
        assert [row["node_id"] for row in rows] == ["r", "7", "requirement_2"]


class TestGraph:
    def families(self, nodes: dict[str, str | None], scope: list[tuple[str, str]]) -> dict[str, str]:
        graph = {
            "nodes": [*({"id": name, "predicate_type": kind} for name, kind in nodes.items()), {"id": "e"}, 3],
            "edges": [{"edge_type": "Scope", "source_id": a, "target_id": b} for a, b in scope]
            + [{"edge_type": "argument", "source_id": "l", "target_id": "entity"}, None],
        }
        found: dict[str, str] = score("semantic_graph", graph=graph, requirements=[])["family_map"]
        return found

    def test_a_logic_node_has_the_one_family_of_its_scope(self) -> None:
        kinds: dict[str, str | None] = {"l": "logic", "m": "logic", "a": "count", "b": "Existence", "c": "material"}
        assert self.families(kinds, [("l", "m"), ("m", "a"), ("l", "b")])["l"] == "content_quantity"
        assert "l" not in self.families(kinds, [("l", "m"), ("m", "a"), ("l", "c")])
        assert "l" not in self.families(kinds, [])

    def test_nodes_of_no_family_say_nothing_and_scope_is_followed_through_logic_only(self) -> None:
        kinds: dict[str, str | None] = {"l": "logic", "a": "count", "x": "mystery", "c": "material", "p": "presence"}
        assert self.families(kinds, [("l", "a"), ("l", "x"), ("l", "p"), ("a", "c")]) == {
            "l": "content_quantity",
            "a": "content_quantity",
            "c": "attributes_materials",
        }

    def test_circles_end(self) -> None:
        kinds: dict[str, str | None] = {"l": "logic", "m": "logic", "a": "count"}
        found = self.families(kinds, [("l", "m"), ("m", "l"), ("m", "a")])
        assert found["l"] == found["m"] == "content_quantity"

    def test_requirements_of_scoped_parents_are_marked(self) -> None:
        graph = {
            "nodes": [{"id": "l", "predicate_type": "logic"}, {"id": "requirement_1", "predicate_type": "count"}],
            "edges": [{"edge_type": "scope", "source_id": "l", "target_id": "requirement_1"}],
        }
        assert score("semantic_graph", graph=graph, requirements=[{"node_id": "l"}, {}])["attached"] == [
            {"node_id": "l", "semantic_family": "content_quantity", "semantic_replaced_by_children": True},
            {"semantic_family": "content_quantity"},
        ]


class TestOverview:
    def judged(self, structure: Any = 1.0, eligible: Any = False, **scores: Any) -> dict[str, Any]:
        return score(
            "overview_judgement",
            dimension_scores=OVERVIEW | scores,
            structural_score=structure,
            severe_cap_eligible=eligible,
        )

    def test_weights_and_modifier(self) -> None:
        assert self.judged(global_prompt_alignment=0.0)["score"] == 0.6
        assert self.judged(composition_and_layout=0.0)["score"] == 0.75
        assert self.judged(style_atmosphere_coherence=0.0)["score"] == 0.8
        assert self.judged(completeness_and_polish=0.0)["score"] == 0.85
        assert [self.judged(value)["score"] for value in (0, 0.5, 1)] == [0.75, 0.875, 1.0]

    def test_the_cap_is_applied_only_above_it(self) -> None:
        above = self.judged(1.0, True)
        assert (above["score"], above["severe_cap_applied"], above["score_before_severe_cap"]) == (0.4, True, 1.0)
        at = score(
            "overview_judgement",
            dimension_scores=dict.fromkeys(OVERVIEW, 0.4),
            structural_score=1,
            severe_cap_eligible=True,
        )
        assert (at["score"], at["severe_cap_applied"]) == (0.4, False)
        assert self.judged(1.0, False)["severe_cap_eligible"] is False

    @pytest.mark.parametrize("bad", [None, True, "1", -0.01, 1.01, float("nan")])
    def test_what_is_no_score_is_refused(self, bad: Any) -> None:
        assert refused(self.judged(bad)) and refused(self.judged(completeness_and_polish=bad))

    def test_a_missing_dimension_is_refused_and_another_one_is_ignored(self) -> None:
        assert self.judged(sharpness=0.0)["score"] == 1.0
        assert refused(score("overview_judgement", dimension_scores={"composition_and_layout": 1}, structural_score=1))


class TestPhysics:
    def leaf(self, name: str, value: Any, status: str = "measured", **more: Any) -> dict[str, Any]:
        return {"leaf_id": name, "status": status, "score": value, **more}

    def physics(self, *leaves: Any, **more: Any) -> Any:
        return score("physics_report", report={"status": "measured", "metrics": {"leaf_results": list(leaves), **more}})

    def test_each_leaf_is_half_and_floating_is_a_rate_of_defects(self) -> None:
        assert self.physics(self.leaf(FLOATING, 0.25), self.leaf(SOLID, 0.5))["score"] == 0.625

    @pytest.mark.parametrize("status", ["not_applicable", "not_evaluated", "error", "Measured", ""])
    def test_a_leaf_that_is_not_measured_is_worth_zero_at_its_weight(self, status: str) -> None:
        assert self.physics(self.leaf(FLOATING, 0.0), self.leaf(SOLID, 1.0, status))["score"] == 0.5

    @pytest.mark.parametrize("bad", [None, True, "1", 1.01, -0.1, float("inf")])
    def test_a_measured_leaf_without_a_number_is_worth_zero(self, bad: Any) -> None:
        assert self.physics(self.leaf(FLOATING, 0.0), self.leaf(SOLID, bad))["score"] == 0.5

    def test_direction_of_the_leaf_then_of_the_report_then_the_published_one(self) -> None:
        own = {"score_direction": "higher_is_better"}
        assert (
            self.physics(self.leaf(FLOATING, 0.25, metadata=own), leaf_score_directions={FLOATING: "lower_is_better"})[
                "score"
            ]
            == 0.125
        )
        assert self.physics(self.leaf(SOLID, 0.25), leaf_score_directions={SOLID: "lower_is_better"})["score"] == 0.375
        odd = self.physics(self.leaf(FLOATING, 0.25, metadata={"score_direction": "sideways"}))
        assert (odd["score"], odd["leaves"][FLOATING]["direction"]) == (0.125, "sideways")

    def test_a_leaf_is_named_by_its_report_too_and_the_later_of_two_counts(self) -> None:
        assert self.physics({"report_id": f"physical_safety.{SOLID}", "status": "measured", "score": 1})["score"] == 0.5
        assert self.physics(self.leaf(SOLID, 1.0), self.leaf(SOLID, 0.0))["score"] == 0.0

    def test_only_a_report_without_leaves_keeps_its_number(self) -> None:
        whole = {"status": "measured", "score": 0.33335}
        assert score("physics_report", report=whole)["score"] == round(0.33335, 4)
        assert score("physics_report", report=whole | {"metrics": {"leaf_results": ["?"]}})["score"] == 0.0
        assert score("physics_report", report=whole | {"status": "partial"})["score"] == 0.0
        assert score("physics_report", report=None)["score"] == 0.0

    def test_other_shapes_are_refused(self) -> None:
        assert refused(score("physics_report", report=[1]))
        assert refused(score("physics_report", report={"metrics": {"leaf_results": 3}}))


class TestCase:
    def test_rounding_is_to_even_on_the_binary_value(self) -> None:
        for part in (0.00025, 0.00075, 0.5):
            assert score("t2s_case", valid=True, detailed=part, overview=0, physics=0)["score"] == round(0.2 * part, 4)
        assert score("i2s_case", valid=True, repair_f1=1 / 3, physics_score=1 / 3)["score"] == 0.333333

    def test_a_missing_part_is_zero_in_text_and_refused_in_image(self) -> None:
        row = score("t2s_case", valid=True, detailed=1, overview=None, physics=1)
        assert (row["score"], row["status"], row["missing_components"]) == (
            0.4,
            "measured_with_missing_zero",
            ["overview"],
        )
        assert refused(score("i2s_case", valid=True, repair_f1=1, physics_score=None))

    def test_an_invalid_case_is_zero_whatever_its_parts(self) -> None:
        assert score("t2s_case", valid=False, detailed=1, overview=1, physics=1)["score"] == 0.0
        row = score("i2s_case", valid=False, repair_f1=None, physics_score="x")
        assert (row["status"], row["score"], row["repair_f1"]) == ("zero_invalid_candidate", 0.0, 0.0)
