"""What every agent with a model is told first, the same for all clients."""

from __future__ import annotations

import shutil
from pathlib import Path

from c4s.records.suite import AgentCase
from c4s.toolbox.skill import skill_text

SERVER = "c4s"
"""Name of the tool server in every client's configuration."""
_TASK = """\
{prompt}

## How to work
You work in a running Unreal Editor through the tools of the server `{server}`; {others}. Positions \
are in centimetres, rotations are [pitch, yaw, roll] in degrees, Z is up.
You may make {calls} tool calls within {minutes:g} minutes. Each answer tells what is left.
The start level is {start_map}. When you are done, save the scene with `save_scene_as`; what is not saved does not
count. Save early and again: the last saved scene is your submission.
"""
_ALONE = "you have no other tools, no shell and no\nfiles"
_AMONG_OTHERS = "whatever else you have, only\nthey change the scene"
_PICTURES = "The attached pictures show the scene as it should be, from {count} views.\n"


def briefing(case: AgentCase, server: str, *, pictures: int, alone: bool = True) -> str:
    """The first message: the case's prompt, the rules of work, and how many pictures are attached.

    ``alone``: whether the agent has no tools but those of the server.
    """
    text = _TASK.format(
        others=_ALONE if alone else _AMONG_OTHERS,
        prompt=case.prompt.strip(),
        server=server,
        calls=case.budget.tool_calls,
        minutes=case.budget.wall_minutes,
        start_map=case.start_map,
    )
    text = f"{text}\n{skill_text()}"
    return text + (_PICTURES.format(count=pictures) if pictures else "")


def copied_pictures(case: AgentCase, agent_folder: Path, into: Path) -> list[Path]:
    """The case's reference views, copied into a folder under plain names."""
    found = []
    for number, view in enumerate(case.reference_views, 1):
        found.append(into / f"reference-{number}{Path(view).suffix}")
        shutil.copyfile(agent_folder / view, found[-1])
    return found


def reference_pictures(case: AgentCase, agent_folder: Path) -> list[Path]:
    """Files of the case's reference views."""
    return [agent_folder / name for name in case.reference_views]
