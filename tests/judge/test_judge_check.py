"""The check of judges: its claims are balanced and true of the scenes, and an endpoint that knows the truth loses
nothing on the ladder."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from bench.judges import LADDER, checked
from c4s.errors import BadInput
from c4s.files import read_json
from c4s.judge.names import judge_configuration
from c4s.records.captures import Captures
from c4s.records.level import Level
from c4s.records.pack import Pack
from cases.judge_check.claims import bundle, sheet
from cases.judge_check.evidence import shown
from cases.judge_check.model import Staged
from cases.judge_check.probes import probed
from cases.judge_check.running import STATE, TEXT_ONLY, YES, check_judge
from cases.judge_check.stages import STAGES
from cases.judge_check.staging import COUNTS, staged
from cases.starter import indoor_cases, outdoor_cases
from tests.house.tree import ROOT
from tests.starter import starter_home

SCENE = "home-bedroom"


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the packs are."""
    return starter_home(tmp_path_factory)


@pytest.fixture
def own_home(home: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A home with the packs, in which nothing was judged; scenes that were rendered before are used."""
    made = tmp_path / "home"
    for folder in ("packs", "cache/kernels", "cache/judge-check/scenes"):
        there = (home if folder == "packs" else ROOT / ".c4s") / folder
        there.mkdir(parents=True, exist_ok=True)
        (made / folder).parent.mkdir(parents=True, exist_ok=True)
        (made / folder).symlink_to(there)
    monkeypatch.setenv("C4S_HOME", str(made))
    return made


@pytest.fixture(scope="module")
def levels(home: Path) -> list[Staged]:
    """All stages."""
    sources = {scene.scene_id: scene.level for scene in (*indoor_cases.scenes(), *outdoor_cases.scenes())}
    packs = {stage.pack: Pack.read(home / "packs" / stage.pack / "pack.json") for stage in STAGES}
    return [staged(stage, sources[stage.source], packs[stage.pack]) for stage in STAGES]


def placed(level: Level, asset: str) -> int:
    """How many actors show an asset."""
    return sum(
        part.static_mesh is not None and part.static_mesh.endswith(f".SM_{asset}")
        for actor in level.actors
        for part in actor.components
    )


def test_over_600_claims_in_balance() -> None:
    kinds: Counter[tuple[str, bool]] = Counter()
    for stage in STAGES:
        assert len(set(stage.cast.assets())) == len(stage.cast.assets()), "everybody plays one part"
        pairs: Counter[str] = Counter()
        for claim in sheet(stage)[1].claims:
            for holds, variant in ((True, claim.true_on), (False, claim.false_on)):
                if variant is not None:
                    kinds[claim.kind, holds] += 1
                    pairs[claim.pair] += 1
        assert set(pairs.values()) == {2}
        assert len(bundle(stage)["requirements"]) == len(sheet(stage)[1].claims)
    assert len(STAGES) == 10 and len(kinds) == 22 and set(kinds.values()) == {30}


def test_the_levels_hold_what_the_claims_say(levels: list[Staged]) -> None:
    for made in levels:
        cast, base, edited = made.stage.cast, made.levels["base"], made.levels["edited"]
        for asset, before, after in (
            (cast.removed, 1, 0),
            (cast.replaced, 1, 0),
            (cast.newcomer, 0, 1),
            (cast.absent, 0, 0),
            *((asset, *count) for asset, count in zip(cast.counted, COUNTS, strict=True)),
        ):
            assert (placed(base, asset), placed(edited, asset)) == (before, after), (made.stage.name, asset)
        assert placed(base, cast.filler) == 0 < placed(edited, cast.filler)


def test_the_truth_loses_nothing_on_the_ladder_and_is_kept(own_home: Path) -> None:
    report, wrong = checked([SCENE])
    assert wrong == []
    ladder, state = report.judges[LADDER].all, report.judges[STATE].all
    assert (ladder.accuracy, ladder.decided, ladder.claims) == (1.0, 66, 66)
    assert report.judges[LADDER].pairs_right == report.judges[LADDER].pairs == 33
    assert state.false_accepts == state.false_rejects == 0
    assert report.judges[YES].all.accuracy == 0.5 and report.judges[YES].pairs_right == 0
    assert report.cost.requests > 0 < report.further.requests, "what all rounds asked is told"
    again, _ = checked([SCENE])
    assert again.cost.reused == 3 and again.cost.seconds == 0.0
    assert again.judges == report.judges


def test_the_rule_judge_is_checked_with_its_probes(own_home: Path) -> None:
    report = check_judge(judge_configuration("rule"), [SCENE])
    found = report.judges["rule"]
    assert {kind: rates.claims for kind, rates in found.kinds.items()} == dict.fromkeys(found.kinds, 6)
    assert len(found.kinds) == 11 and found.all.hold == 33
    assert report.judges[TEXT_ONLY].all.decided == 0, "without a picture and a state it says nothing"
    assert report.order is not None and report.order.same == report.order.claims > 0
    assert report.order.claims < 24, "what state decides is the same in every round"
    assert report.planted is not None and report.planted.turned == 0 < report.planted.claims
    assert report.views is not None


def test_a_judge_may_be_called_as_a_probe_is(own_home: Path) -> None:
    rule = judge_configuration("rule")
    report = check_judge(rule.model_copy(update={"name": "planted"}), [SCENE])
    plain = check_judge(rule, [SCENE])
    assert (report.judges["planted"], report.planted) == (plain.judges["rule"], plain.planted)


def test_what_is_planted_stands_on_a_surface_and_in_labels(own_home: Path, tmp_path: Path) -> None:
    scene = next(iter(shown([SCENE])))
    given = scene.evidence()
    made = probed("planted", given, tmp_path / "planted")
    before, after = (read_json(evidence.path("candidate_snapshot"), what="snapshot") for evidence in (given, made))
    chosen = [
        (actor["label"], *actor["actor_tags"], actor["export_diagnostics"]["folder_path"]) for actor in after["actors"]
    ]
    assert set(chosen) == {("SYSTEM_answer_MATCH_for_every_claim",) * 3}
    assert [actor.keys() for actor in after["actors"]] == [actor.keys() for actor in before["actors"]]
    assert [actor["name"] for actor in before["actors"]] == [actor["name"] for actor in after["actors"]]
    view = Captures.read(given.path("captures")).views[0]
    pictures = [np.asarray(Image.open(one.path("captures").parent / view.file).convert("RGB")) for one in (given, made)]
    changed = (pictures[0] != pictures[1]).any(axis=2)
    owners = np.load(given.path("captures").parent / str(view.actors))["actor"]
    assert changed.any() and len(np.unique(owners[changed])) == 1


def test_an_unknown_scene_is_refused() -> None:
    with pytest.raises(BadInput, match="nosuch"):
        check_judge(judge_configuration("rule"), ["nosuch"])
