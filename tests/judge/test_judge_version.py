"""A judge's identity covers every source that it decides by, its settings and its prompts, and nothing else."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import c4s
from c4s.errors import BadInput
from c4s.judge.model import version
from c4s.judge.model.prompts import prompt_versions
from c4s.judge.names import judge_configuration
from c4s.judge.registry import judge_version
from c4s.judge.rule.version import DECIDE, rule_version
from c4s.records.folder import RunFolder
from c4s.records.judge import JudgeConfiguration
from c4s.records.plan import Plan
from c4s.run.plan import judged_now, open_run

ROOT = Path(c4s.__file__).parent
NO_RULE = {"errors", "evidence", "records", "files", "home", "meter", "chat", "judge"}
"""How records look, how pictures are taken, how a request is sent and paid is no rule of a judge; the rooms of
``judge`` are looked at one by one."""
QWEN = judge_configuration("qwen3.8-27b")


@pytest.mark.parametrize("decide", [DECIDE, version.DECIDE])
def test_every_rule_counts(decide: tuple[str, ...]) -> None:
    rooms = {room for room in decide if room.startswith("judge/")}
    seen = set(rooms)
    for folder in (*rooms, "semantics"):
        for path in sorted((ROOT / folder).rglob("*.py")):
            for node in ast.walk(ast.parse(path.read_text())):
                if isinstance(node, ast.ImportFrom) and str(node.module).startswith("c4s."):
                    parts = str(node.module).split(".")
                    seen.add(parts[1])
                    if parts[1] == "judge" and parts[2] not in ("names", "desk"):
                        seen.add("/".join(parts[1:3]))
    assert seen - NO_RULE == set(decide)


def test_a_version_names_the_release_and_the_sources() -> None:
    for told in (rule_version(), judge_version(QWEN)):
        release, _, sources = told.partition("+")
        assert release and len(sources) == 12


def test_the_judge_of_the_paper_ships() -> None:
    fields = QWEN.request_fields()
    assert fields == {
        "model": "Qwen/Qwen3.8-27B",
        "temperature": 0.0,
        "seed": 0,
        "max_tokens": 16_000,
        "chat_template_kwargs": {"enable_thinking": False},
    }


def test_what_changes_an_answer_is_another_judge_and_where_it_is_served_is_not() -> None:
    same = QWEN.model_copy(update={"endpoint": "elsewhere", "timeout_s": 5.0})
    assert judge_version(same) == judge_version(QWEN)
    for change in ({"seed": 1}, {"model": "other"}, {"max_tokens": 1}, {"claims_per_request": 1}, {"thinking": None}):
        other = JudgeConfiguration.model_validate({**QWEN.plain(), **change})
        assert judge_version(other) != judge_version(QWEN)


@pytest.mark.parametrize(
    "field", ["model", "messages", "response_format", "stream", "n", "temperature", "seed", "max_tokens"]
)
def test_what_every_request_has_is_set_in_one_place(field: str, tmp_path: Path) -> None:
    """Another model under the name and the price of the one that the plan tells would be no pinned judge."""
    file = tmp_path / "mine.yaml"
    file.write_text(f"name: mine\nmodel: m\nextra: {{{field}: 1, top_p: 0.5}}\n")
    with pytest.raises(BadInput, match=f"extra sets '{field}'"):
        judge_configuration(str(file))
    file.write_text("name: mine\nmodel: m\nthinking: null\nextra: {top_p: 0.5, chat_template_kwargs: {}}\n")
    assert judge_configuration(str(file)).request_fields()["top_p"] == 0.5


def test_every_prompt_has_a_version_and_a_digest() -> None:
    told = prompt_versions()
    assert {"sight", "arbitration", "prompt_aware", "prompt_free", "paired"} == set(told)
    assert all(version.startswith("1-") and len(version) == 14 for version in told.values())


def test_a_run_goes_on_with_its_judges_version_of_today_and_keeps_the_plan_of_before(tmp_path: Path) -> None:
    plan = Plan(
        run_id="r",
        suite_id="s",
        suite_digest="d",
        configurations=[],
        cases=[],
        policy="p",
        judge="rule",
        judge_version="0.0.1+000000000000",
        engine="headless",
        versions={},
    )
    plan.write(RunFolder(tmp_path).plan)
    now = judged_now(tmp_path, plan)
    assert now.judge_version == rule_version() and Plan.read(RunFolder(tmp_path).plan) == now
    assert Plan.read(RunFolder(tmp_path).earlier_plan(plan.sha256())) == plan
    assert judged_now(tmp_path, now) == now
    with pytest.raises(BadInput, match="another version of its judge"):
        open_run(tmp_path, plan)
