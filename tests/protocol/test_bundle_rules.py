"""The validator of requirement bundles: published ones pass, and whatever breaks a rule is caught by that rule."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.protocol import graph
from c4s.protocol.bundle import MAXIMUM_NODES
from c4s.protocol.graph.check import check_bundle, sound_requirements
from c4s.protocol.graph.prompt import description_end, prompt_view
from c4s.protocol.graph.report import MOST_FINDINGS
from cases.requirements import bundle
from cases.starter.indoor_text_cases import INDOOR_TEXT_CASES
from cases.starter.outdoor_texts import farm_text, harbour_text
from tests.protocol.breaks import BREAKS, Bundle, first, no_words, nodes
from tests.shared import SHARED

ALLEY = SHARED / "upstream/tests/fixtures/synthetic-alley.bundle.json"
BAZAAR = SHARED / "upstream/benchmark/public/text-to-scene/bazaar/requirements/bazaar.bundle.json"
STARTER = [farm_text(), harbour_text(), *INDOOR_TEXT_CASES]


def authored() -> Bundle:
    case = farm_text()
    return bundle(case.case_id, case.description, case.description + "\n\n=== ASSET PALETTE ===\nx", case.requirements)


def published(path: Any) -> Bundle:
    if not path.is_file():
        pytest.skip("the published bundles are not here")
    found: Bundle = json.loads(path.read_text())
    return found


SOURCES: dict[str, Callable[[], Bundle]] = {
    "authored": authored,
    "bazaar": lambda: published(BAZAAR),
    "alley": lambda: published(ALLEY),
}


def told(made: Bundle) -> dict[str, str]:
    return {finding.rule: finding.severity for finding in check_bundle(made, making=True).findings}


@pytest.mark.parametrize("source", SOURCES)
@pytest.mark.parametrize(("rule", "severity", "break_it"), BREAKS, ids=[f"{n}-{b[0]}" for n, b in enumerate(BREAKS)])
def test_whatever_breaks_a_rule_is_caught_by_it(source, rule, severity, break_it):
    made = SOURCES[source]()
    before = told(made)
    assert "error" not in before.values()
    break_it(made)
    assert told(made)[rule] == severity
    if severity == "error":
        with pytest.raises(BadInput, match="requirement bundle cannot be used"):
            check_bundle(made, making=True).refuse(where="x")


def test_words_left_out_are_told_of_a_bundle_that_is_there_and_refused_of_one_in_the_making():
    made = authored()
    no_words(made)
    assert sound_requirements(made).scored
    assert [finding.rule for finding in check_bundle(made).warnings] == ["consistency.digest", "coverage.words"]


def test_every_rule_is_broken_once():
    sources = "".join(path.read_text() for path in Path(graph.__file__).parent.glob("*.py"))
    rules = set(re.findall(r'"((?:grounding|references|scope|cycles|consistency|coverage)\.[a-z]+)"', sources))
    assert rules == {rule for rule, _, _ in BREAKS} - {"shape"}


def test_published_bundles_pass_with_stated_warnings_only():
    assert told(published(BAZAAR)) == {}
    assert told(published(ALLEY)) == {"consistency.digest": "warning"}
    found = check_bundle(published(ALLEY)).coverage
    assert (found.terms, found.covered) == (18, 18)


@pytest.mark.parametrize("case", STARTER, ids=lambda case: case.case_id)
def test_starter_bundles_pass_without_a_word_left_out(case):
    made = bundle(case.case_id, case.description, case.description, case.requirements)
    report = check_bundle(made)
    assert report.findings == ()
    assert report.coverage.ratio == 1


def test_a_report_tells_all_and_a_refusal_the_first():
    made = authored()
    first(made)["text"] = "a purple submarine"
    made["graph"]["roots"][0]["weight"] = 2.0
    report = check_bundle(made)
    plain = report.plain()
    assert {"grounding.text", "scope.weight"} <= {row["rule"] for row in plain["errors"]}
    assert plain["counts"]["requirements"] == len(made["requirements"])
    with pytest.raises(BadInput, match=r"x: .*\(and \d+ more error"):
        report.refuse(where="x")
    made["graph"]["nodes"] = [{"node_type": "entity"}] * MAXIMUM_NODES
    assert len(check_bundle(made).errors) == MOST_FINDINGS


def test_a_composite_does_not_cover_what_its_parts_do_not():
    made = published(ALLEY)
    made["requirements"], made["evaluations"] = made["requirements"][:2], made["evaluations"][:2]
    keep = {row["node_id"] for row in made["requirements"]} | {node["id"] for node in nodes(made, "entity")}
    made["graph"]["nodes"] = [
        node for node in made["graph"]["nodes"] if node["node_type"] != "predicate" or node["id"] in keep
    ]
    assert "neon" in check_bundle(made).coverage.uncovered


@pytest.mark.parametrize(
    ("prompt", "description"),
    [
        ("A yard.", "A yard."),
        ("A yard.\n\n=== ASSET PALETTE ===\nx", "A yard."),
        ("A yard.\n\n    === GROUND ===\n    x\n\n=== ASSET PALETTE ===\n", "A yard."),
        ("A yard === ASSET PALETTE === in a row.", "A yard === ASSET PALETTE === in a row."),
    ],
)
def test_a_description_ends_before_the_palette(prompt, description):
    assert prompt[: description_end(prompt)] == description
    assert prompt_view(prompt)["source_span"] == [0, len(description)]


VALUES = st.recursive(
    st.none() | st.booleans() | st.integers(-5, 5) | st.floats() | st.text(max_size=8),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=8), inner, max_size=3),
    max_leaves=6,
)


@settings(deadline=None, max_examples=300)
@given(st.data())
def test_any_damage_is_told_or_harmless(data):
    """A value anywhere in a sound bundle, replaced by anything: a report, never another exception."""
    made = authored()
    place: Any = made
    while True:
        keys = list(place) if isinstance(place, dict) else list(range(len(place)))
        key = data.draw(st.sampled_from(keys))
        if isinstance(place[key], dict | list) and place[key] and data.draw(st.booleans()):
            place = place[key]
            continue
        place[key] = data.draw(VALUES)
        break
    report = check_bundle(made)
    if not report.errors:
        sound_requirements(made)
