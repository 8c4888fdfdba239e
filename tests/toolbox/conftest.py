"""An engine, a gateway and a run on the small case."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from made_case import make_case, make_pack

from c4s.engine import Engine, open_engine
from c4s.files import json_lines
from c4s.toolbox.catalog import CaseCatalog
from c4s.toolbox.client import GatewayClient
from c4s.toolbox.gateway import Endpoint, Gateway
from c4s.toolbox.gateway_run import Run
from c4s.toolbox.workbench import Workbench


@dataclass
class Opened:
    """A run that is open, with a client."""

    run: Run
    endpoint: Endpoint
    client: GatewayClient
    folder: Path
    engine: Engine
    gateway: Gateway
    pack: Path

    def trajectory(self) -> list[dict[str, Any]]:
        with self.run.trajectory.open() as lines:
            return list(json_lines(lines))


@pytest.fixture(scope="session")
def pack(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return make_pack(tmp_path_factory.mktemp("packs"))


@pytest.fixture(scope="session")
def engines(tmp_path_factory: pytest.TempPathFactory, pack: Path) -> Iterator[Callable[[str], tuple[Engine, Path]]]:
    """One engine a setting, started when it is first asked for."""
    started: dict[str, tuple[Engine, Path]] = {}
    with ExitStack() as stack:

        def engine_for(setting: str) -> tuple[Engine, Path]:
            if setting not in started:
                folder = tmp_path_factory.mktemp("engine")
                case, agent_folder = make_case(folder / "suite", pack, setting=setting)
                started[setting] = (
                    stack.enter_context(
                        open_engine(
                            "headless",
                            packs=[pack],
                            content=folder / "content",
                            scratch=folder / "scratch",
                            levels=[agent_folder / "start.level.json"],
                            start_map=case.start_map,
                        )
                    ),
                    folder,
                )
            return started[setting]

        yield engine_for


@pytest.fixture
def open_run(
    tmp_path: Path, pack: Path, engines: Callable[[str], tuple[Engine, Path]]
) -> Iterator[Callable[..., Opened]]:
    """Open a run on the start level of the small case."""
    with ExitStack() as stack:

        def start(**options: Any) -> Opened:
            tools, limits = options.pop("tools", None), options.pop("limits", None)
            case, agent_folder = make_case(tmp_path / "suite", pack, **options)
            engine, folder = engines(case.setting)
            stack.callback(_idle, engine)
            engine.call("scene_tools.open_level", package=case.start_map)
            gateway = stack.enter_context(Gateway())
            catalog = CaseCatalog.load(case, [pack])
            bench = Workbench(case, agent_folder, catalog, engine, folder / "scratch", limits)
            run = Run("room-1", bench, case.budget, tmp_path / "trajectory.jsonl", tools)
            endpoint = gateway.open_run(run)
            return Opened(run, endpoint, stack.enter_context(GatewayClient(endpoint)), folder, engine, gateway, pack)

        yield start


def _idle(engine: Engine) -> None:
    """Abandon the job that a test left running."""
    status = engine.request("editor_status")
    if status["busy"]:
        engine.request("abandon_job", {"job_id": status["job_id"]})
