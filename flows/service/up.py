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
from urllib.parse import urlsplit

from c4s.errors import BadInput, MachineryFault
from c4s.home import home
from c4s.records.lease import Owner
from c4s.run.owner import owner_of
from flows.service.health import deployments, health
from flows.service.pools import declared_digest, deploy, make_pools
from flows.service.settings import environment, prefect_home
from flows.service.state import Service, alone, runs

DEFAULT_HOST: Final = "127.0.0.1"
DEFAULT_PORT: Final = 4200
POSTGRES_PORT: Final = 5432
_ANSWER_S: Final = 5.0
_START_S: Final = 180.0
_END_S: Final = 30.0
_LOOK_S: Final = 0.25


@dataclass(frozen=True)
class ServiceAsked:
    """What is asked for.

    Args:
        slots: how many slots each pool has here; a pool without slots gets no worker.
        host: address that the server listens on (default: as before, else 127.0.0.1, which lets no other machine in).
        port: its port (default: as before, else 4200).
        database: URL of a PostgreSQL database for the server; none: an SQLite file under ``C4S_HOME``.
        url: address of a server that runs elsewhere; none is started then.
    """

    slots: Mapping[str, int]
    host: str | None = None
    port: int | None = None
    database: str | None = None
    url: str | None = None


def up(asked: ServiceAsked, tell: Callable[[str], None]) -> Service:
    """Start what is missing: server, pools, workers, deployments. What runs stays as it is.

    ``BadInput`` where what was started here before is not what is asked for: one home has one service.
    """
    with alone(tell):
        found = Service.read()
        if found is not None:
            _check_same(asked, found)
        default = f"http://{asked.host or DEFAULT_HOST}:{asked.port or DEFAULT_PORT}/api"
        service = found or Service(asked.url or default, _kind(asked.database))
        own = asked.url is None and (found is None or found.server is not None)
        missing = own and not runs(service.server)
        if missing:
            _check_port(service.url)
            _check_database(asked.database)
            tell(f"starting the server at {service.ui}")
            service.server = _start_server(asked.database, service)
            service.write()
        _wait_for(service)
        for name in make_pools(service.url):
            tell(f"made the work pool {name!r}")
        for pool, slots in asked.slots.items():
            if slots and not runs(service.workers.get(pool)):
                service.workers[pool] = _start_worker(pool, slots, service.url)
                service.write()
                tell(f"started {slots} slot{'s' if slots > 1 else ''} of the pool {pool!r}")
                missing = True
        if service.deployed != (wanted := declared_digest()) or deployments(service.url):
            tell("deploying the flows")
            deploy(service.url)
            service.deployed = wanted
        elif not missing:
            tell("nothing was missing")
        service.write()
        return service


def _check_same(asked: ServiceAsked, found: Service) -> None:
    """``BadInput`` for a request that the service on record does not meet. What is not named is as before."""
    end, at = "end it first with `c4s down`", urlsplit(found.url)
    url = asked.url or f"http://{asked.host or at.hostname}:{asked.port or at.port}/api"
    if (asked.url or asked.host or asked.port) and url != found.url:
        raise BadInput(f"the server of {found.url} is used here", where="--url", todo=end)
    if asked.database is not None and _kind(asked.database) != found.database:
        raise BadInput(f"the server of this home keeps its records in {found.database}", where="--database", todo=end)
    if found.database != "sqlite" and asked.database is None and found.server is not None and not runs(found.server):
        raise BadInput(
            "the server that ran here kept its records in PostgreSQL, at an address that is not on record",
            where="--database",
            todo="give --database again, or begin anew after `c4s down`",
        )


def down(tell: Callable[[str], None]) -> int:
    """End what ``up`` started here; how many processes that were. What is done is kept: run folders remember."""
    with alone(tell):
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


def _check_database(database: str | None) -> None:
    """``BadInput`` where nothing listens at the database's address."""
    if database is None:
        return
    at = urlsplit(database)
    host, port = at.hostname or "127.0.0.1", at.port or POSTGRES_PORT
    try:
        socket.create_connection((host, port), timeout=_ANSWER_S).close()
    except OSError as error:
        raise BadInput(
            f"no database answers at {host}:{port}: {error.strerror or error}",
            where="--database",
            todo="start PostgreSQL there, or leave --database out for an SQLite file",
        ) from None


def _check_port(url: str) -> None:
    at = urlsplit(url)
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((at.hostname, at.port))
        except OSError as error:
            raise BadInput(
                f"the server cannot listen on {at.hostname}:{at.port}: {error.strerror}",
                where="--port",
                todo="choose another --port, or end what listens there",
            ) from None


def _start_server(database: str | None, service: Service) -> Owner:
    made, at = environment(service.url), urlsplit(service.url)
    if database is not None:
        _, _, rest = database.partition("://")
        made["PREFECT_SERVER_DATABASE_CONNECTION_URL"] = f"postgresql+asyncpg://{rest}"
    command = [sys.executable, "-m", "flows.program", "prefect", "server", "start"]
    return _start([*command, "--host", str(at.hostname), "--port", str(at.port)], made, "server")


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
