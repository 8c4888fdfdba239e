"""``c4s up`` and ``c4s down``: what is missing is started, what was started is ended; each may be given again."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from c4s.errors import BadInput, MachineryFault
from c4s.home import home
from c4s.records.lease import Owner
from c4s.run.owner import owner_of
from flows.service.health import health
from flows.service.pools import deploy, make_pools
from flows.service.settings import environment, prefect_home
from flows.service.state import Service, runs

DEFAULT_PORT: Final = 4200
_START_S: Final = 180.0
_END_S: Final = 30.0
_LOOK_S: Final = 0.25


@dataclass(frozen=True)
class ServiceAsked:
    """What is asked for.

    Args:
        slots: how many slots each pool has here; a pool without slots gets no worker.
        host: address that the server listens on; 127.0.0.1 lets no other machine in.
        port: its port.
        database: URL of a PostgreSQL database for the server; none: an SQLite file under ``C4S_HOME``.
        url: address of a server that runs elsewhere; none is started then.
    """

    slots: Mapping[str, int]
    host: str = "127.0.0.1"
    port: int = DEFAULT_PORT
    database: str | None = None
    url: str | None = None


def up(asked: ServiceAsked, tell: Callable[[str], None]) -> Service:
    """Start what is missing: server, pools, deployments, workers. What runs stays as it is."""
    found = Service.read()
    if found is not None and asked.url and found.url != asked.url:
        raise BadInput(f"the server of {found.url} is used here", where="--url", todo="end it first with `c4s down`")
    service = found or Service(asked.url or f"http://{asked.host}:{asked.port}/api", _kind(asked.database))
    if asked.url is None and not runs(service.server):
        _check_port(asked)
        tell(f"starting the server at {service.ui}")
        service.server = _start_server(asked, service)
        service.write()
    _wait_for(service)
    for name in make_pools(service.url):
        tell(f"made the work pool {name!r}")
    tell("deploying the flows")
    deploy(service.url)
    for pool, slots in asked.slots.items():
        if slots and not runs(service.workers.get(pool)):
            service.workers[pool] = _start_worker(pool, slots, service.url)
            service.write()
            tell(f"started {slots} slot{'s' if slots > 1 else ''} of the pool {pool!r}")
    service.write()
    return service


def down(tell: Callable[[str], None]) -> int:
    """End what ``up`` started here; how many processes that were. What is done is kept: run folders remember."""
    service = Service.read()
    if service is None:
        return 0
    owners = {f"the workers of {name!r}": owner for name, owner in service.workers.items()}
    if service.server is not None:
        owners["the server"] = service.server
    ended = 0
    for what, owner in owners.items():
        if runs(owner):
            tell(f"ending {what}")
            _end(owner, what)
            ended += 1
    Service.forget()
    return ended


def _kind(database: str | None) -> str:
    if database is None:
        return "sqlite"
    if not database.startswith(("postgresql://", "postgresql+asyncpg://", "postgres://")):
        raise BadInput("this is no PostgreSQL URL", where="--database", todo="postgresql://user:password@host/name")
    return "postgresql"


def _check_port(asked: ServiceAsked) -> None:
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((asked.host, asked.port))
        except OSError as error:
            raise BadInput(
                f"the server cannot listen on {asked.host}:{asked.port}: {error.strerror}",
                where="--port",
                todo="choose another --port, or end what listens there",
            ) from None


def _start_server(asked: ServiceAsked, service: Service) -> Owner:
    made = environment(service.url)
    if asked.database is not None:
        _, _, rest = asked.database.partition("://")
        made["PREFECT_SERVER_DATABASE_CONNECTION_URL"] = f"postgresql+asyncpg://{rest}"
    command = [sys.executable, "-m", "prefect", "server", "start", "--host", asked.host, "--port", str(asked.port)]
    return _start(command, made, "server")


def _start_worker(pool: str, slots: int, url: str) -> Owner:
    command = [sys.executable, "-m", "c4s.cli", "worker", "--pool", pool, "--slots", str(slots), "--url", url]
    return _start(command, environment(url), pool)


def _start(command: list[str], made: dict[str, str], name: str) -> Owner:
    """Start a process that outlives this one; what it says goes to its log."""
    prefect_home().mkdir(parents=True, exist_ok=True)
    with log_of(name).open("ab") as log:
        process: subprocess.Popen[Any] = subprocess.Popen(
            command, env=made, cwd="/", stdin=subprocess.DEVNULL, stdout=log, stderr=log, start_new_session=True
        )
    return owner_of(process.pid)


def log_of(name: str) -> Path:
    """Where a process of the service logs: ``server``, or a pool's name."""
    return prefect_home() / f"{name}.log"


def _wait_for(service: Service) -> None:
    deadline = time.monotonic() + _START_S
    while fault := health(service.url):
        if service.server is not None and not runs(service.server):
            raise MachineryFault("the server ended", where=str(log_of("server")), todo="read the end of this log")
        if service.server is None or time.monotonic() > deadline:
            raise MachineryFault(f"the Prefect server: {fault}", where=service.url, todo="see that it runs")
        time.sleep(_LOOK_S)


def _end(owner: Owner, what: str) -> None:
    """Ask a process to end, and end it with its whole session where it does not."""
    with suppress(ProcessLookupError):
        os.kill(owner.pid, signal.SIGTERM)
    deadline = time.monotonic() + _END_S
    while runs(owner):
        if time.monotonic() > deadline:
            with suppress(ProcessLookupError):
                os.killpg(owner.pid, signal.SIGKILL)
            break
        time.sleep(_LOOK_S / 5)
    while runs(owner):
        if time.monotonic() > deadline + _END_S:
            raise MachineryFault(f"{what} (process {owner.pid}) does not end", where=str(home()))
        time.sleep(_LOOK_S / 5)
