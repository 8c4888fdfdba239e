"""Cases as tasks of Inspect AI: ``inspect eval c4s/starter --model MODEL``; the extra ``c4s[inspect]`` installs it.

Inspect finds this module by the entry point ``c4s`` of the group ``inspect_ai``. Its solver opens the scene and lets
the model work through c4s's gateway; its scorer runs c4s's own stages, so a score here is the score that ``c4s run``
gives the same scene. What Inspect knows of model requests is written into c4s's books; calls that Inspect refuses
itself (an unknown tool, wrong arguments) never reach the gateway and are in none of them. The configuration says so:
its harness is ``inspect_ai``.
"""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path
from typing import Any

from inspect_ai import Task, task
from inspect_ai.dataset import MemoryDataset, Sample
from inspect_ai.event import ModelEvent
from inspect_ai.log import transcript
from inspect_ai.model import ChatMessageUser, ContentImage, ContentText
from inspect_ai.scorer import Score, Scorer, Target, mean, scorer
from inspect_ai.solver import Generate, Solver, TaskState, solver
from inspect_ai.tool import mcp_connection, mcp_server_http

from c4s.agents.base import AgentReport
from c4s.agents.briefing import SERVER, briefing, reference_pictures
from c4s.engine import DEFAULT_ENGINE
from c4s.errors import BadInput, unknown
from c4s.harness.driven import DrivenTrial, score_driven
from c4s.home import suites_root
from c4s.judge.names import DEFAULT_JUDGE
from c4s.names import place_in
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.suite import SuiteFolder
from c4s.run.grading import numbers

HARNESS = "inspect_ai"
CONNECT_S, ANSWER_S = 30.0, 900.0
"""Longest waits for a connection, and for an answer of a tool: a job of the editor may take five minutes."""
RUN, SUITE = "c4s_run", "c4s_suite"
"""Where a sample's metadata names the folder of its trial, and the suite."""


@task
def starter(cases: str | Sequence[str] | None = None, judge: str = DEFAULT_JUDGE, policy: str = DEFAULT_POLICY) -> Task:
    """The starter suite. ``-T cases=ID,ID`` chooses cases."""
    return suite_task("starter", cases, judge, policy)


@task
def suite(
    suite: str, cases: str | Sequence[str] | None = None, judge: str = DEFAULT_JUDGE, policy: str = DEFAULT_POLICY
) -> Task:
    """Any built suite: ``inspect eval c4s/suite -T suite=ID``."""
    return suite_task(suite, cases, judge, policy)


def suite_task(name: str, cases: str | Sequence[str] | None, judge: str, policy: str) -> Task:
    """A built suite of ``C4S_HOME`` as a task. ``BadInput`` for an unknown suite or case."""
    folder = place_in(suites_root(), name, "suite")
    if not SuiteFolder(folder).record.is_file():
        raise BadInput(f"unknown suite {name!r}", where=str(suites_root()), todo="build it with `c4s suite build`")
    chosen = cases.split(",") if isinstance(cases, str) else list(cases or ())
    return Task(dataset=_dataset(folder, chosen), solver=work(judge, policy), scorer=case_score())


def _dataset(folder: Path, chosen: Sequence[str]) -> MemoryDataset:
    opened = SuiteFolder(folder)
    known = {case.case_id: case for case in opened.suite().cases}
    for case_id in chosen:
        if case_id not in known:
            raise unknown("case", case_id, known, where=str(folder))
    samples = []
    for case_id in chosen or known:
        alias = known[case_id].alias
        case, views = opened.agent_case(alias), reference_pictures(opened.agent_case(alias), opened.agent(alias))
        text = briefing(case, SERVER, pictures=len(views))
        content = [ContentText(text=text), *(ContentImage(image=str(view)) for view in views)]
        samples.append(
            Sample(
                id=case_id,
                input=[ChatMessageUser(content=content)],
                metadata={SUITE: str(folder), "setting": case.setting, "scene": opened.withheld_case(case_id).scene_id},
            )
        )
    return MemoryDataset(samples, name=opened.suite().suite_id)


@solver
def work(judge: str = DEFAULT_JUDGE, policy: str = DEFAULT_POLICY, inner: Solver | None = None) -> Solver:
    """Open the scene of a sample, let the model work on it with c4s's tools, and end the attempt.

    ``inner`` is the solver that does the work, with the tools in its state; the model's own loop of calls without one.
    """

    async def solve(state: TaskState, generate: Generate) -> TaskState:
        driven = await asyncio.to_thread(
            lambda: DrivenTrial.open(
                Path(state.metadata[SUITE]),
                str(state.sample_id),
                harness=HARNESS,
                model=str(state.model),
                policy=policy,
                judge=judge,
                engine=DEFAULT_ENGINE,
            )
        )
        state.metadata[RUN] = str(driven.trial.run)
        endpoint = await asyncio.to_thread(driven.start)
        server = mcp_server_http(
            name=SERVER,
            url=endpoint.url,
            headers={"Authorization": f"Bearer {endpoint.token}"},
            timeout=CONNECT_S,
            sse_read_timeout=ANSWER_S,
        )
        try:
            async with mcp_connection(server):
                state.tools = [*state.tools, *await server.tools()]
                state = await (inner(state, generate) if inner else generate(state))
        finally:
            report = AgentReport(client_version=f"{HARNESS} {version(HARNESS)}", usage=_usage())
            await asyncio.to_thread(driven.finish, report)
        return state

    return solve


@scorer(metrics={"*": [mean()]})
def case_score() -> Scorer:
    """c4s's score of what was saved: ``reward`` and ``valid``; the components stand in the metadata."""

    async def score(state: TaskState, target: Target) -> Score:
        made = await asyncio.to_thread(score_driven, Path(state.metadata[RUN]), Path(state.metadata[SUITE]))
        found = numbers(made)
        return Score(
            value={name: found.pop(name) for name in ("reward", "valid")},
            explanation=made.reason or made.status,
            metadata={**found, "status": made.status, "folder": state.metadata[RUN]},
        )

    return score


def _usage() -> list[dict[str, Any]]:
    """Every model request of this sample as c4s's books have it; unknown counts are null."""
    found = []
    for event in transcript().events:
        usage = event.output.usage if isinstance(event, ModelEvent) else None
        if not isinstance(event, ModelEvent):
            continue
        read, written = (usage.input_tokens_cache_read, usage.input_tokens_cache_write) if usage else (None, None)
        found.append(
            {
                "time": event.timestamp.timestamp(),
                "wire": HARNESS,
                "model": event.model,
                "ending": "ok" if event.error is None else "upstream_error",
                "input_tokens": usage.input_tokens + (read or 0) + (written or 0) if usage else None,
                "fresh_input_tokens": usage.input_tokens if usage else None,
                "cache_read_tokens": (read or 0) if usage else None,
                "cache_write_tokens": (written or 0) if usage else None,
                "output_tokens": usage.output_tokens if usage else None,
                "reasoning_tokens": usage.reasoning_tokens if usage else None,
                "cost_usd": usage.total_cost if usage else None,
            }
        )
    return found
