"""``c4s up``, ``c4s down``, ``c4s worker``: Prefect on this machine, without knowing Prefect."""

from __future__ import annotations

import os
from typing import Annotated

import typer

from c4s import extras
from c4s.cli.output import print_json, say
from c4s.errors import BadInput, unknown
from c4s.stderr import tell

MOST_SLOTS = 1024
Json = Annotated[bool, typer.Option("--json")]


def up(
    engines: Annotated[
        int | None, typer.Option(min=0, max=MOST_SLOTS, help="engine slots here (default: one a core)")
    ] = None,
    verifiers: Annotated[
        int | None, typer.Option(min=0, max=MOST_SLOTS, help="verifier slots here (default: one a core)")
    ] = None,
    judges: Annotated[int, typer.Option(min=0, max=MOST_SLOTS, help="slots for requests to a model judge")] = 1,
    host: Annotated[
        str | None,
        typer.Option(help="address the server listens on (default: 127.0.0.1); 0.0.0.0 lets other machines in"),
    ] = None,
    port: Annotated[int | None, typer.Option(min=1, max=65535, help="port of the server (default: 4200)")] = None,
    database: Annotated[
        str | None, typer.Option(help="PostgreSQL URL for the server (default: an SQLite file)")
    ] = None,
    url: Annotated[str | None, typer.Option(help="use the server at this API address; start none")] = None,
    json_output: Json = False,
) -> None:
    """Start what is missing: a Prefect server, the work pools, the deployments, and workers on this machine.

    Give it again after a change or a crash: what runs stays as it is. `c4s down` ends all of it.
    """
    extras.need("service", "`c4s up`")
    from flows.service import ServiceAsked
    from flows.service import up as start

    cores = os.cpu_count() or 1
    slots = {
        "coordinators": 2,
        "engines": cores if engines is None else engines,
        "verifiers": cores if verifiers is None else verifiers,
        "judges": judges,
    }
    service = start(ServiceAsked(slots, host, port, database, url), tell)
    if json_output:
        print_json({"url": service.url, "ui": service.ui, "database": service.database, "slots": slots})
        return
    say(f"Prefect: {service.ui}")
    say(f"in your shell:  export PREFECT_API_URL={service.url}")
    say("a night:        prefect deployment run evaluate/pools --param suite=starter --watch")
    say(f"more machines:  c4s worker --pool engines --slots 1 --url {service.url}")


def down(json_output: Json = False) -> None:
    """End the server and the workers that `c4s up` started here. What is done stays done: run it again to go on."""
    from flows.service import down as end

    ended = end(tell)
    if json_output:
        print_json({"ended": ended})
    else:
        say(f"{ended} processes ended" if ended else "nothing of c4s runs here")


def worker(
    pool: Annotated[str, typer.Option(help="coordinators, engines, verifiers or judges")],
    slots: Annotated[int, typer.Option(min=1, max=MOST_SLOTS, help="how much it takes at once")] = 1,
    url: Annotated[str | None, typer.Option(help="API address of the server (default: PREFECT_API_URL)")] = None,
) -> None:
    """Take work of a pool on this machine until Ctrl-C. What is in work then is done again elsewhere.

    `C4S_HOME` has to be the folder that the machines share, or `C4S_STORE` the object store.
    """
    extras.need("service", "`c4s worker`")
    from flows.service import POOLS, supervise
    from flows.service.health import health

    if pool not in POOLS:
        raise unknown("work pool", pool, POOLS)
    address = url or os.environ.get("PREFECT_API_URL")
    if not address:
        raise BadInput("no server is named", where="--url", todo="give --url, or set PREFECT_API_URL (see `c4s up`)")
    if fault := health(address):
        raise BadInput(f"the server cannot be used: {fault}", where=address, todo="start it with `c4s up`")
    supervise(pool, slots, address, tell)
