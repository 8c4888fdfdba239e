"""Submits the truth. It exists to validate the evaluator and is never ranked.

Its run alone mounts the truth as one more read-only level; it opens that level and saves it as its submission, through
the same tools as every other agent.
"""

from __future__ import annotations

from c4s.agents.base import SUBMISSION_NAME, AgentContext, AgentReport
from c4s.errors import AgentFault, BadInput

WAIT_S = 120.0


class Oracle:
    """The agent ``oracle``."""

    def run(self, context: AgentContext) -> AgentReport:
        """Open the truth and save it."""
        if context.truth_package is None:
            raise BadInput("the oracle needs the withheld truth", where=context.case.alias)
        script = (
            "import unreal\n"
            f"assert unreal.EditorLoadingAndSavingUtils.load_map({context.truth_package!r}) is not None\n"
        )
        with context.connect() as tools:
            job = tools.call("execute_python_script", script=script).data["job_id"]
            state = tools.call("read_job_log", job_id=job, wait_s=WAIT_S).data
            if state["status"] != "done":
                raise AgentFault(
                    f"the truth cannot be opened: {state.get('error', state['status'])}", where=context.case.alias
                )
            tools.call("save_scene_as", name=SUBMISSION_NAME)
        return AgentReport(client_version="oracle 1")
