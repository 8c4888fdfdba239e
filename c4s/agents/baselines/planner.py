"""Baseline ``planner``: no model. It reads what stands on and near what and builds it; in a repair it mends the odd."""

from __future__ import annotations

from c4s.agents.base import SUBMISSION_NAME, AgentContext, AgentReport
from c4s.agents.baselines.composing import compose
from c4s.agents.baselines.mending import mends
from c4s.agents.baselines.palette import description
from c4s.protocol.settings import is_construction
from c4s.toolbox.client import CallRefused, GatewayClient

TIERS = ("ground", "structures", "props", "details")
DEFAULT_PLATE_M = 200.0


class Planner:
    """The agent ``planner``."""

    def run(self, context: AgentContext) -> AgentReport:
        """Play one case through the tools, as any agent would."""
        with context.connect() as tools:
            if is_construction(context.case.setting):
                message = _construct(tools, context.case.prompt, context.case.plate_m or DEFAULT_PLATE_M)
            else:
                message = _mend(tools)
            tools.call("save_scene_as", name=SUBMISSION_NAME)
        return AgentReport(client_version="planner 4", message=message)


def _construct(tools: GatewayClient, prompt: str, plate_m: float) -> str:
    """Ground, then the planned scene tier by tier, then light and sky where they are missing."""
    notes = []
    try:
        tools.call("ground_pass", scene_text=description(prompt), half_extent_m=plate_m / 2)
    except CallRefused as refusal:
        notes.append(refusal.line())
    graph = compose(prompt, plate_m)
    if graph["nodes"]:
        problems = tools.call("validate_scene_graph", graph=graph).data["problems"]
        dropped = {problem["node"] for problem in problems if problem["dropped"]}
        graph = {"nodes": [node for node in graph["nodes"] if node["id"] not in dropped]}
        solved = tools.call("solve_scene_graph", graph=graph, half_extent_m=plate_m / 2).data["solved"]
        present = solved["tier_counts"]
        for tier in TIERS:
            if tier in present:
                failed = tools.call("build_tier", tier=tier).data["failed"]
                notes += [f"{entry.get('name')}: {entry['error']}" for entry in failed]
    tools.call("setup_environment")
    return "; ".join(notes)


def _mend(tools: GatewayClient) -> str:
    found = mends(tools.actors())
    for mend in found:
        if mend.scale is None:
            tools.call("delete_actor", name=mend.actor)
        else:
            tools.call("set_actor_transform", name=mend.actor, scale=list(mend.scale))
    return "; ".join(f"{mend.actor}: {mend.reason}" for mend in found)
