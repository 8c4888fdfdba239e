"""A suite without Python: from a pack to a frozen and released suite, through the command line."""

from __future__ import annotations

import json
import os
import re
from pathlib import Path

import pytest
import yaml

from c4s.files import canonical_json, read_json
from c4s.records.asking import CaseReview
from c4s.records.frozen import Frozen
from c4s.records.pack import MANIFEST, Pack
from c4s.records.suite import SuiteFolder
from cases.workshop import SuiteFile
from tests.built import built_packs
from tests.cli.warm import warm_process

KEPT = ("hay_bale", "crate", "wheelbarrow", "scarecrow", "hay_cart", "cow", "sheep", "tool_rack", "wood_pile", "plough")


def c4s(home: Path, *arguments: object, code: int = 0) -> str:
    """What a command says on both streams; its exit code is looked at."""
    settings = {**os.environ, "C4S_HOME": str(home), "COLUMNS": "200"}
    done = warm_process().call([*map(str, arguments)], cwd=Path.cwd(), environment=settings, limit_s=280)
    assert done.code == code, done.out + done.err
    return done.out + done.err


@pytest.fixture(scope="module")
def walked(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """A home with a small pack that may be used with AI, and the folder of a suite that was begun and built there."""
    home, place = tmp_path_factory.mktemp("home"), tmp_path_factory.mktemp("author") / "yard"
    source = built_packs(tmp_path_factory, "c4s-farm") / "c4s-farm"
    pack = Pack.read(source / "pack.json")
    folder = home / "packs/yard-things"
    folder.mkdir(parents=True)
    kept = [asset for asset in pack.assets if asset.id in KEPT]
    small = pack.model_copy(update={"pack_id": "yard-things", "assets": kept, "ai_use": "allowed"})
    wanted = small.named_files()
    small = small.model_copy(update={"files": {n: d for n, d in pack.files.items() if n in wanted}})
    for name in small.files:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes((source / name).read_bytes())
    small.write(folder / "pack.json")
    c4s(home, "suite", "new", "yard-things", "--out", place, "--author", "ada", "--environment", "outdoor", "--yes")
    said = c4s(home, "suite", "build", place)
    assert "next: c4s suite stats yard" in said and (place / "yard.png").read_bytes().startswith(b"\x89PNG")
    return home, place


def test_a_begun_suite_file_is_complete_and_can_be_checked(walked: tuple[Path, Path]) -> None:
    home, place = walked
    text = (place / "suite.yaml").read_text()
    assert text.startswith("# yaml-language-server: $schema=suite.schema.json\n")
    assert json.loads((place / "suite.schema.json").read_text()) == SuiteFile.model_json_schema()
    file = SuiteFile.model_validate(yaml.safe_load(text))
    assert file.authors == ["ada"] and len(file.repairs) == 1 and len(file.repairs[0].views) == 1
    assert (place / "scene.png").read_bytes().startswith(b"\x89PNG")
    assert "1 scenes and 1 cases that fit together" in c4s(home, "suite", "check", place)


def test_numbers_and_differences_of_a_built_suite(walked: tuple[Path, Path]) -> None:
    home, _ = walked
    (row,) = json.loads(c4s(home, "suite", "stats", "yard", "--json"))["settings"]
    assert (row["cases"], row["public"], row["views"], row["chains"]) == (1, 1, {"1": 1}, {"1": 1})
    assert row["target_pixels"]["least"] >= 400
    assert "1 of 1 cases are the same" in c4s(home, "suite", "diff", "yard", home / "suites/yard")


def test_freezing_wants_reviews_of_others_and_a_release_has_public_cases_alone(
    walked: tuple[Path, Path], tmp_path: Path
) -> None:
    home, _ = walked
    suite = SuiteFolder(home / "suites/yard")
    said = c4s(home, "suite", "freeze", "yard", code=1)
    assert "0 of 3 reviewers who did not make it find it solvable" in said and not suite.frozen.exists()
    record = suite.suite()
    log = home / "human/reviews/yard/reviews.jsonl"
    log.parent.mkdir(parents=True)

    def review(who: str, said: str = "yes", note: str = "") -> None:
        answers = dict.fromkeys(("clear", "solvable", "consistent"), said)
        row = CaseReview.model_validate(
            {
                "suite": "yard",
                "suite_digest": record.sha256(),
                "reviewer": who,
                "alias": record.cases[0].alias,
                "answers": answers,
                "note": note,
            }
        )
        with log.open("a") as lines:
            lines.write(canonical_json(row.plain()) + "\n")

    for who in ("ada", "bob", "cem"):
        review(who)
    said = c4s(home, "suite", "freeze", "yard", code=1)
    assert "2 of 3 reviewers who did not make it find it solvable" in said, f"the author's own counts: {said}"
    review("eve", "no", "the bale could stand anywhere")
    assert "eve says it is not clear" in c4s(home, "suite", "freeze", "yard", code=1)
    log.write_text("".join(line for line in log.read_text().splitlines(True) if '"eve"' not in line))
    review("dan")
    c4s(home, "suite", "freeze", "yard")
    frozen = Frozen.read(suite.frozen)
    assert frozen.cases["yard-01-move"].solvable == ["bob", "cem", "dan"] and frozen.packs[0].ai_use == "allowed"
    assert "files are as they were frozen" in c4s(home, "suite", "check", "yard")
    out = tmp_path / "release"
    c4s(home, "suite", "export", "yard", "--public", "--out", out)
    release = SuiteFolder(out).suite()
    assert [case.case_id for case in release.cases] == ["yard-01-move"]
    for pack in release.packs:
        told = (out / "licences" / f"{pack.pack_id}.txt").read_text()
        own = Pack.read(home / "packs" / pack.pack_id / MANIFEST)
        assert f"Licence: {own.license}\n" in told
        words = home / "packs" / pack.pack_id / "LICENSE.txt"
        assert not words.is_file() or told.endswith(words.read_text())
    assert "this is there already" in c4s(home, "suite", "export", "yard", "--public", "--out", out, code=2)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda v: v.pop("title"), r"line 1: field 'title': it is missing"),
        (lambda v: v["repairs"][0].update(scene_id="hall"), r"yard-01-move\): no scene 'hall'|no scene 'hall'"),
        (lambda v: v["repairs"][0]["corruptions"][0].update(actor="Bale_9"), r"Bale_9"),
        (lambda v: v["repairs"][0]["corruptions"][0].update(kind="melt"), r"'melt'"),
        (lambda v: v["repairs"][0]["corruptions"][0].update(by_cm=[1, 2]), r"by_cm"),
        (lambda v: v["repairs"][0]["corruptions"][0].pop("by_cm"), r"a move has either by_cm or to_cm"),
        (lambda v: v["repairs"][0]["views"][0].update(fov_deg=200), r"fov_deg"),
        (lambda v: v["repairs"].append(v["repairs"][0]), r"two cases or scenes have this case id"),
        (lambda v: v["scenes"][0].update(level="../../etc/passwd.level.json"), r"leads out of its folder"),
        (lambda v: v["scenes"][0].update(packs=["no-such"]), r"no-such"),
        (lambda v: v.update(colour="red"), r"field 'colour': there is no such field"),
    ],
)
def test_a_wrong_suite_file_is_one_line_that_says_where(
    walked: tuple[Path, Path], tmp_path: Path, change, says: str
) -> None:
    home, place = walked
    value = yaml.safe_load((place / "suite.yaml").read_text())
    change(value)
    (tmp_path / "suite.yaml").write_text(yaml.safe_dump(value, sort_keys=False))
    (tmp_path / "showroom.level.json").write_bytes((place / "showroom.level.json").read_bytes())
    said = c4s(home, "suite", "check", tmp_path, code=2)
    assert re.search(says, said) and len(said.strip().splitlines()) == 1, said


def test_nothing_is_written_over_and_nothing_is_made_of_nothing(walked: tuple[Path, Path], tmp_path: Path) -> None:
    home, place = walked
    before = (place / "suite.yaml").read_bytes()
    assert "a suite file lies here already" in c4s(home, "suite", "new", "yard-things", "--out", place, "-y", code=2)
    assert (place / "suite.yaml").read_bytes() == before
    assert "no such folder, file, scene or pack" in c4s(
        home, "suite", "new", "x", "--out", tmp_path / "n", "-y", code=2
    )
    folder = home / "packs/yard-things"
    c4s(home, "suite", "new", folder, "--out", tmp_path / "again", "-y", "--environment", "outdoor")
    assert "- again-pack" in (tmp_path / "again/suite.yaml").read_text(), "a path is a folder of meshes, not a pack"
    assert read_json(SuiteFolder(home / "suites/yard").sightings)["yard-01-move"][0]["pixels"] >= 400
