"""The page of the tools and the skill text."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from made_case import path_of

from c4s.agents.briefing import briefing
from c4s.records.suite import AgentCase, Budget
from c4s.toolbox.page import tools_page
from c4s.toolbox.registry import TOOLS
from c4s.toolbox.skill import PARTS, skill_text

PAGE = Path(__file__).resolve().parents[2] / "docs/tools.md"


def test_the_page_of_the_tools_is_what_the_registry_says() -> None:
    assert PAGE.read_text() == tools_page(), "run `python -m c4s.toolbox.page > docs/tools.md`"
    assert [line[4:] for line in tools_page().splitlines() if line.startswith("### ")] == list(TOOLS)


def test_the_skill_has_four_parts_and_names_only_what_is_there() -> None:
    text = skill_text()
    assert len(PARTS) == 4 and len(re.findall(r"^## ", text, re.MULTILINE)) == 4
    assert len(text) < 8000, "it is in every first message"
    named = set(re.findall(r"`([a-z]+_[a-z_]+)(?:\(.*?\))?`", text))
    fields = {"size_m", "bounds_min_cm", "bounds_max_cm", "spawn_path", "spawn_with", "job_id"}
    assert named - fields <= set(TOOLS)
    assert {"setup_environment", "save_scene_as", "search_assets", "validate_scene_graph"} <= named


def test_the_snippets_of_the_skill_work_as_they_are_written(open_run: Callable) -> None:
    opened = open_run()
    snippets = re.findall(r"```python\n(.*?)```", skill_text(), re.DOTALL)
    assert len(snippets) == 2
    for snippet in snippets:
        script = snippet.replace("/Game/Pack/SM_Chair.SM_Chair", path_of("SM_crate"))
        told = opened.client.call("execute_python_script", script=script, execution_mode="sync").data
        assert told["status"] == "done", told
    assert "Chair_1" in opened.client.call("find_actors_by_name", pattern="Chair_1").data["actors"][0]["label"]
    camera = opened.engine.call("capture.viewport_camera")
    assert camera["location_cm"] == [-800, -800, 500] and camera["rotation_deg"][1] == pytest.approx(45)
    assert opened.client.call("take_screenshot").images


def test_every_case_is_told_the_same_skill() -> None:
    case = AgentCase.parse(
        {
            "alias": "c",
            "setting": "text-to-scene",
            "prompt": "Build a town.",
            "packs": [],
            "start_map": "/Game/A/B",
            "catalog": [],
            "budget": Budget(tool_calls=800, wall_minutes=180).plain(),
        }
    )
    assert skill_text() in briefing(case, "c4s", pictures=0)
