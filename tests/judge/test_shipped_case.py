"""The judge on a shipped case: its truth scores, and what is hidden is not there."""

from __future__ import annotations

import copy
from typing import Any

import pytest

from c4s.evidence import export_evidence
from c4s.files import read_json
from c4s.protocol.bundle import read_requirements
from c4s.records.evidence import catalog_facts
from c4s.records.pack import Pack
from cases.requirements import bundle
from cases.starter import indoor_cases
from tests.built import built_packs
from tests.judge.judged import verify_detailed, verify_overview

Snapshot = dict[str, Any]


@pytest.fixture(scope="module")
def shipped(tmp_path_factory: pytest.TempPathFactory) -> tuple[Any, Snapshot, Any]:
    """Requirement bundle, truth and catalog of the flat; the truth comes from a clean engine."""
    root = tmp_path_factory.mktemp("flat")
    packs, level = [built_packs(tmp_path_factory, "c4s-home") / "c4s-home"], indoor_cases.scenes()[1].level
    level.write(root / "content" / f"{level.package.lstrip('/')}.level.json")
    export_evidence(
        engine="headless",
        packs=packs,
        submission_content=root / "content",
        package=level.package,
        out=root / "evidence",
    )
    case = next(case for case in indoor_cases.INDOOR_TEXT_CASES if case.case_id == "text-flat-family")
    made = bundle(case.case_id, case.description, case.description, case.requirements)
    return (
        made,
        read_json(root / "evidence" / "snapshot.json"),
        catalog_facts(Pack.read(folder / "pack.json") for folder in packs),
    )


def captures(snapshot: Snapshot) -> dict[str, Any]:
    """Four views that show what a camera can: every actor that is not hidden."""
    visible = {actor["name"]: 4000 for actor in snapshot["actors"] if not actor["c4s"].get("hidden")}
    return {"views": [{"visible": visible, "camera": {"width": 960, "height": 540}}] * 4}


def hidden(snapshot: Snapshot, share: float) -> Snapshot:
    """The scene with a share of its actors hidden."""
    made = copy.deepcopy(snapshot)
    for actor in made["actors"][: round(share * len(made["actors"]))]:
        actor["c4s"]["hidden"] = True
    return made


def test_hidden_actors_are_not_there(shipped: tuple[Any, Snapshot, Any]) -> None:
    asked, truth, catalog = shipped
    whole = verify_detailed(asked, truth, catalog, captures(truth))
    rest = hidden(truth, 0.95)
    kept = {"actors": [actor for actor in rest["actors"] if not actor["c4s"].get("hidden")], "c4s": truth["c4s"]}
    left = verify_detailed(asked, rest, catalog, captures(rest))
    assert whole.score is not None and left.score is not None
    assert whole.score > 0.4 and left.score < 0.25 * whole.score
    assert left.score == verify_detailed(asked, kept, catalog, captures(kept)).score
    overview, after = (verify_overview(asked, s, catalog, captures(s)).score for s in (truth, rest))
    assert overview is not None and after is not None and after < 0.5 * overview


def test_what_no_view_shows_is_there_but_not_seen(shipped: tuple[Any, Snapshot, Any]) -> None:
    asked, truth, catalog = shipped
    blind = {"views": [{"visible": {}, "camera": {"width": 960, "height": 540}}] * 4}
    seen, unseen = (verify_detailed(asked, truth, catalog, shown) for shown in (captures(truth), blind))
    assert seen.score == unseen.score
    assert verify_overview(asked, truth, catalog, blind).score == 0.0


def test_a_shipped_bundle_is_read_whole(shipped: tuple[Any, Snapshot, Any]) -> None:
    asked, _, _ = shipped
    read = read_requirements(asked)
    assert len(read.scored) == len(asked["requirements"]) == len(read.predicates)
    assert len(read.entities) + len(read.predicates) + 1 == len(asked["graph"]["nodes"])
