"""A script of an agent without a model, run to its end."""

from __future__ import annotations

from c4s.errors import AgentFault
from c4s.toolbox.client import GatewayClient


def run_script(tools: GatewayClient, script: str) -> str:
    """What a script printed; ``AgentFault`` when it failed."""
    state = tools.call("execute_python_script", script=script, execution_mode="sync").data
    while state["status"] in ("running", "queued"):
        state = tools.call("read_job_log", job_id=state["job_id"], wait_s=60).data
    if state["status"] != "done":
        raise AgentFault(str(state.get("error", state["status"])))
    return str(state["output"]).strip()
