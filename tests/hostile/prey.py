"""A run that a hostile agent was given: an engine on the small case, whose truth lies beside it, and secrets about."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "toolbox"))
from made_case import START, make_case, make_pack, mesh_actor

from c4s.engine import Engine, open_engine
from c4s.records.level import Level
from c4s.toolbox.catalog import CaseCatalog
from c4s.toolbox.client import GatewayClient
from c4s.toolbox.gateway import Endpoint, Gateway
from c4s.toolbox.gateway_run import Run
from c4s.toolbox.workbench import Workbench

SECRET = "sk-the-real-key-of-the-operator"
TRUTH = "the-globe-stood-here"


@dataclass
class Prey:
    """What the hostile agent attacks."""

    root: Path
    gateway: Gateway
    run: Run
    endpoint: Endpoint
    client: GatewayClient
    engine: Engine

    def python(self, script: str) -> dict[str, Any]:
        """Run a script as the agent does; its state and output."""
        return self.client.call("execute_python_script", script=script, execution_mode="sync").data


@pytest.fixture(scope="module")
def prey(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Prey]:
    root = tmp_path_factory.mktemp("prey")
    pack = make_pack(root / "packs")
    case, agent_folder = make_case(root / "suite", pack, calls=500)
    withheld = root / "suite/withheld/room"
    truth = Level(package="/Game/Oracle/room", actors=[mesh_actor(1, TRUTH, "crate", (0, 0, 0))])
    truth.write(withheld / "truth.level.json")
    truth.write(root / "runs/oracle/truth.level.json")
    with ExitStack() as stack:
        patch = stack.enter_context(pytest.MonkeyPatch.context())
        patch.setenv("OPENROUTER_API_KEY", SECRET)
        patch.setenv("C4S_HOME", str(root))
        engine = stack.enter_context(
            open_engine(
                "headless",
                packs=[pack],
                content=root / "content",
                scratch=root / "scratch",
                levels=[agent_folder / "start.level.json"],
                start_map=START,
            )
        )
        gateway = stack.enter_context(Gateway())
        bench = Workbench(case, agent_folder, CaseCatalog.load(case, [pack]), engine, root / "scratch")
        run = Run("room-1", bench, case.budget, root / "trajectory.jsonl")
        endpoint = gateway.open_run(run)
        yield Prey(root, gateway, run, endpoint, stack.enter_context(GatewayClient(endpoint)), engine)
