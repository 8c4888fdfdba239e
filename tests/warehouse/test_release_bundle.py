"""The release bundle: what is on the allow-list, with its digest; a planted leak or key stops it."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from c4s.errors import MachineryFault
from c4s.files import digest_file
from c4s.records.suite import AgentCase, Budget, SuiteFolder, WithheldCase
from warehouse.release import Secrets, look_through, pack_release

HIDDEN = "lighthouse-of-the-hidden-quay"
ANSWER = "analyses/study/answer.json"
LEAK = r"case in analyses/study/answer\.json"


def made_suite(root: Path) -> SuiteFolder:
    """A suite whose one case is private."""
    suite = SuiteFolder(root)
    case = AgentCase(
        alias="case-0f0f0f0f0f",
        setting="text-to-scene",
        prompt="A yard.",
        start_map="/Game/Blank",
        budget=Budget(tool_calls=1, wall_minutes=1),
        packs=[],
        catalog=[],
    )
    withheld = WithheldCase(case_id=HIDDEN, alias=case.alias, scene_id="quay", visibility="private")
    case.write(suite.agent(case.alias) / "case.json")
    withheld.write(suite.withheld(HIDDEN) / "case.json")
    suite.freeze("hidden", "Hidden", "", [])
    return suite


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A suite with a private case, an analysis, and the bundle that is made of them in ``out``."""
    root = tmp_path_factory.mktemp("home")
    (root / "analyses/study").mkdir(parents=True)
    (root / ANSWER).write_text("{}")
    (root / "analyses/study/cache.bin").write_bytes(b"x")
    (root / "out").mkdir()
    made = made_suite(root / "suite")
    pack_release(root / "out", runs={}, analyses=root / "analyses", private=[made], secrets=Secrets())
    return root


@pytest.fixture
def planted(tmp_path: Path) -> Callable[[str], Path]:
    """Makes a folder with an answer that a study might have left."""

    def plant(text: str) -> Path:
        (tmp_path / ANSWER).parent.mkdir(parents=True)
        (tmp_path / ANSWER).write_text(text)
        return tmp_path

    return plant


def test_what_is_on_the_list_is_packed_with_its_digest(home: Path) -> None:
    folder = home / "out"
    digests = json.loads((folder / "digests.json").read_text())
    assert all(digest_file(folder / name) == value for name, value in digests.items())
    found = {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}
    assert found == {*digests, "digests.json"}
    for name in ("code/c4s/score/case.py", "agents/skill.md", "agents/tools.json", "schemas/plan.schema.json"):
        assert name in digests
    assert any(name.startswith("judge/prompts/") for name in digests) and ANSWER in digests
    assert not any(name.endswith((".bin", ".pyc", ".nbi")) or "__pycache__" in name for name in digests)
    assert len(json.loads((folder / "agents/tools.json").read_text())) == 25


def test_a_bundle_that_holds_something_private_is_not_made(home: Path, tmp_path: Path) -> None:
    (tmp_path / "analyses/study").mkdir(parents=True)
    (tmp_path / ANSWER).write_text(json.dumps({"best": HIDDEN}))
    suite = SuiteFolder(home / "suite")
    with pytest.raises(MachineryFault, match=LEAK):
        pack_release(tmp_path / "out", runs={}, analyses=tmp_path / "analyses", private=[suite], secrets=Secrets())


@pytest.mark.parametrize("name", [HIDDEN, HIDDEN.upper(), "case-0f0f0f0f0f"])
def test_a_name_of_a_private_case_is_found(home: Path, planted: Callable[[str], Path], name: str) -> None:
    with pytest.raises(MachineryFault, match=LEAK):
        look_through(planted(json.dumps({"best": name})), private=[SuiteFolder(home / "suite")], secrets=Secrets())


def test_a_text_of_a_private_case_of_the_warehouse_is_found(planted: Callable[[str], Path]) -> None:
    secrets = Secrets({"paint seven zebra crossings": "prompt"})
    with pytest.raises(MachineryFault, match="prompt in analyses"):
        look_through(planted('{"said": "Paint seven <b>zebra</b> crossings!"}'), private=[], secrets=secrets)


def test_a_key_of_the_environment_is_found(planted: Callable[[str], Path], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PLANTED_API_KEY", "sk-planted-0123456789")
    with pytest.raises(MachineryFault, match="value of PLANTED_API_KEY"):
        look_through(planted('{"note": "sk-planted-0123456789"}'), private=[], secrets=Secrets())
