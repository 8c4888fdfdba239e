"""Cases of c4s as a taskset of verifiers: ``vf-eval c4s_cases``. c4s itself is a program of another environment."""

from __future__ import annotations

import base64
import json
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import verifiers.v1 as vf
from pydantic import Field
from verifiers.v1.tasksets.harbor.toolset import HarborMCPConfig, HarborMCPToolset

__all__ = ["CasesTaskset"]

HARNESS = "verifiers"
ATTEMPT = "attempt"
"""Folder of the attempt in the rollout's working directory."""


class CaseData(vf.TaskData):
    """A case as its agent meets it, and its id for the scorer."""

    case_id: str


class CaseConfig(vf.TaskConfig):
    """What of c4s is used."""

    c4s: str = "c4s"
    """The program."""
    suite: str = "starter"
    """Id of a built suite."""
    judge: str = "rule"
    """As ``c4s grade --judge`` has it."""
    case_id: str = ""
    """Of the task; set from its data."""


class CasesConfig(vf.TasksetConfig):
    """Which cases there are."""

    task: CaseConfig = CaseConfig()
    cases: list[str] = Field(default_factory=list)
    """Case ids; all of the suite where there are none."""


class CaseTask(vf.Task[CaseData, vf.State, CaseConfig]):
    """One case: its gateway is started beside the agent, and what it saved is graded when the agent is done."""

    def __init__(self, data: CaseData, config: CaseConfig | None = None) -> None:
        super().__init__(data, config)
        self.config = self.config.model_copy(update={"case_id": data.case_id})

    @classmethod
    def toolsets(cls, config: CaseConfig) -> list[vf.Toolset]:
        """The case's gateway, over standard input and output."""
        serve = ["serve", config.case_id, "--suite", config.suite, "--stdio", "--out", ATTEMPT, "--harness", HARNESS]
        server = {"name": "c4s", "transport": "stdio", "command": config.c4s, "args": serve}
        return [HarborMCPToolset(HarborMCPConfig(colocated=True, server=server))]

    @vf.reward
    async def reward(self, trace: vf.Trace, runtime: vf.Runtime) -> float:
        """The case score; the other numbers are recorded as metrics."""
        config = self.config
        grade = [config.c4s, "grade", ATTEMPT, "--case", config.case_id, "--suite", config.suite]
        done = await runtime.run([*grade, "--judge", config.judge, "--harness", HARNESS], {})
        if done.exit_code:
            raise vf.TaskError(f"c4s grade: {(done.stderr or done.stdout).strip()[-500:]}")
        numbers: dict[str, float] = json.loads(done.stdout)
        trace.record_metrics({name: value for name, value in numbers.items() if name != "reward"})
        return numbers["reward"]


class CasesTaskset(vf.Taskset[CaseTask, CasesConfig]):
    """The cases of a built suite."""

    def load(self) -> Iterator[CaseTask]:
        """A task a case, in the suite's order."""
        config = self.config.task
        suite = json.loads(_told(config.c4s, "suite", "show", config.suite, "--json"))
        with tempfile.TemporaryDirectory(prefix="c4s-cases-") as folder:
            chosen = [option for case in self.config.cases for option in ("--case", case)]
            _told(config.c4s, "suite", "export-harbor", config.suite, "--out", f"{folder}/cases", *chosen)
            for case in suite["cases"]:
                exported = Path(folder, "cases", case["alias"])
                if exported.is_dir():
                    data = CaseData(
                        id=case["alias"], name=case["alias"], prompt=_prompt(exported), case_id=case["case_id"]
                    )
                    yield CaseTask(data, config)


def _prompt(exported: Path) -> vf.Messages:
    """What the case says, with its reference pictures."""
    pictures = sorted((exported / "environment/case/references").glob("*.png"))
    parts: list[Any] = [vf.TextContentPart(text=(exported / "instruction.md").read_text(encoding="utf-8"))]
    for picture in pictures:
        data = base64.b64encode(picture.read_bytes()).decode()
        parts.append(vf.ImageUrlContentPart(image_url=vf.ImageUrlSource(url=f"data:image/png;base64,{data}")))
    return [vf.UserMessage(content=parts)]


def _told(*command: str) -> str:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise ValueError(done.stderr.strip() or f"{' '.join(command)} exited {done.returncode}")
    return done.stdout
