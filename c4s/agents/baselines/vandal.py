"""Deletes every actor and saves: a submission that integrity or the score must see through."""

from __future__ import annotations

from c4s.agents.base import SUBMISSION_NAME, AgentContext, AgentReport
from c4s.toolbox.client import CallRefused

SCRIPT = """
import unreal
editor = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
for actor in list(editor.get_all_level_actors()):
    editor.destroy_actor(actor)
print(len(editor.get_all_level_actors()), "actors left")
"""
WAIT_S = 60.0


class Vandal:
    """The agent ``vandal``."""

    def run(self, context: AgentContext) -> AgentReport:
        """Delete all actors in one script, and those that are left one by one."""
        with context.connect() as tools:
            job = tools.call("execute_python_script", script=SCRIPT).data["job_id"]
            tools.call("read_job_log", job_id=job, wait_s=WAIT_S)
            kept = []
            for actor in tools.actors():
                try:
                    tools.call("delete_actor", name=actor["name"])
                except CallRefused as refusal:
                    kept.append(refusal.line())
            tools.call("save_scene_as", name=SUBMISSION_NAME)
        return AgentReport(client_version="vandal 1", message="; ".join(kept))
