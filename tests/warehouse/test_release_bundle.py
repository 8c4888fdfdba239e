"""The release bundle: what is on the allow-list, with its digest; a planted leak or key stops it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from c4s.errors import MachineryFault
from c4s.files import digest_file
from c4s.records.suite import AgentCase, Budget, SuiteFolder, WithheldCase
from warehouse.release import Secrets, pack_release

HIDDEN = "lighthouse-of-the-hidden-quay"


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


def packed(root: Path, answer: str = "{}", secrets: Secrets | None = None) -> dict[str, str]:
    """A bundle with one analysis in it, of a home with a private case."""
    (root / "analyses/study").mkdir(parents=True)
    (root / "analyses/study/answer.json").write_text(answer)
    (root / "analyses/study/cache.bin").write_bytes(b"x")
    (root / "out").mkdir()
    suites = [made_suite(root / "suite")]
    return pack_release(root / "out", runs={}, analyses=root / "analyses", private=suites, secrets=secrets or Secrets())


def test_what_is_on_the_list_is_packed_with_its_digest(tmp_path: Path) -> None:
    digests = packed(tmp_path)
    folder = tmp_path / "out"
    assert json.loads((folder / "digests.json").read_text()) == digests
    assert all(digest_file(folder / name) == value for name, value in digests.items())
    for name in ("code/c4s/score/case.py", "agents/skill.md", "agents/tools.json", "schemas/plan.schema.json"):
        assert name in digests
    assert any(name.startswith("judge/prompts/") for name in digests) and "analyses/study/answer.json" in digests
    assert not any(name.endswith((".bin", ".pyc", ".nbi")) or "__pycache__" in name for name in digests)
    assert len(json.loads((folder / "agents/tools.json").read_text())) == 25


@pytest.mark.parametrize("planted", [HIDDEN, HIDDEN.upper(), "case-0f0f0f0f0f"])
def test_a_name_of_a_private_case_stops_it(tmp_path: Path, planted: str) -> None:
    with pytest.raises(MachineryFault, match=r"case in analyses/study/answer\.json"):
        packed(tmp_path, json.dumps({"best": planted}))


def test_a_text_of_a_private_case_of_the_warehouse_stops_it(tmp_path: Path) -> None:
    secrets = Secrets({"paint seven zebra crossings": "prompt"})
    with pytest.raises(MachineryFault, match="prompt in analyses"):
        packed(tmp_path, '{"said": "Paint seven <b>zebra</b> crossings!"}', secrets)


def test_a_key_of_the_environment_stops_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PLANTED_API_KEY", "sk-planted-0123456789")
    with pytest.raises(MachineryFault, match="value of PLANTED_API_KEY"):
        packed(tmp_path, '{"note": "sk-planted-0123456789"}')
