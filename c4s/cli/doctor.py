"""``c4s doctor``: what this machine has, what is missing, and what that costs."""

from __future__ import annotations

import os
import platform
import shutil
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Annotated

import typer

from c4s import extras
from c4s.agents.base import PROGRAMS, agent_of
from c4s.cli.output import print_json, print_table
from c4s.engine import backend as backend_of
from c4s.engine.confine.sandbox import CHOICE, backend, faults
from c4s.errors import BadInput, MachineryFault
from c4s.home import home, suites_root
from c4s.judge.names import JUDGE_NAMES, judge_configuration
from c4s.records.plan import Configuration
from c4s.run.store import STORE, open_store

LEAST_FREE_GB = 2.0
HOME = "C4S_HOME"


@dataclass(frozen=True)
class Diagnosis:
    """One thing that was looked at. ``needed`` things that are missing stop c4s; others cost what ``text`` says."""

    what: str
    found: bool
    needed: bool
    text: str


def _findings() -> Iterator[Diagnosis]:
    yield _sandbox()
    flags = Path("/proc/cpuinfo").read_text() if Path("/proc/cpuinfo").is_file() else ""
    yield Diagnosis("AVX2", " avx2" in flags, True, f"pictures are drawn on the CPU ({platform.machine()})")
    try:
        place = home()
    except BadInput as fault:
        if HOME in os.environ:
            raise
        yield Diagnosis(HOME, False, True, f"{fault.line()}; all else is looked at from there")
        return
    free = shutil.disk_usage(place if place.exists() else place.parent).free / 1e9
    yield Diagnosis("disk", free > LEAST_FREE_GB, True, f"{free:.0f} GB free for {place}")
    yield Diagnosis(
        "starter suite",
        (suites_root() / "starter/suite.json").is_file(),
        False,
        "built" if (suites_root() / "starter/suite.json").is_file() else "build it: c4s suite build starter",
    )
    yield Diagnosis("sentence model", *_model())
    yield from _store()
    yield from _prefect()
    for what, there, text in backend_of("unreal").findings():
        yield Diagnosis(what, there, False, text)
    yield from _judges()
    yield from _clients()


_COSTS = {
    "bubblewrap": "bubblewrap would hide the names and sizes of files outside too",
    "landlock": "landlock would let agent code ask whether a path outside exists",
}


def _sandbox() -> Diagnosis:
    """Which sandbox engines get here, by the choice of the environment, and what another would cost."""
    try:
        used = backend()
    except (BadInput, MachineryFault) as fault:
        return Diagnosis("sandbox", False, True, fault.line())
    told = [f"{used} confines engine processes" if used != "none" else f"{CHOICE}=none: nothing confines agent code"]
    if os.environ.get(CHOICE):
        told.append(f"asked for by {CHOICE}")
    for name, missing in faults().items():
        if name != used:
            told.append(f"{name} does not work here: {missing}" if missing else _COSTS[name])
    return Diagnosis("sandbox", True, True, "; ".join(told))


def _model() -> tuple[bool, bool, str]:
    """The model of the asset search."""
    from c4s.weights import standing

    there, text = standing()
    return there, False, text


def _judges() -> Iterator[Diagnosis]:
    """The model judges that ship: whether an endpoint and key are there for each. None of them is asked anything."""
    from c4s.judge.model.endpoints import served

    for name in JUDGE_NAMES:
        chosen = judge_configuration(name)
        if chosen.kind == "rule":
            continue
        try:
            place = served(chosen)
        except BadInput as missing:
            yield Diagnosis(f"judge {name}", False, False, missing.line())
            continue
        count = len(place.addresses)
        text = f"{count} address{'' if count == 1 else 'es'}, {place.parallel} requests at once"
        yield Diagnosis(f"judge {name}", True, False, text)


def _clients() -> Iterator[Diagnosis]:
    """The agent clients that are programs of their own: the version that is installed, or how to install it."""
    from c4s.agents.clients.client import ExternalClient

    unusable = faults()["bubblewrap"]
    for name in PROGRAMS:
        agent = agent_of(Configuration(name=name, client=name))
        if not isinstance(agent, ExternalClient):
            continue
        try:
            program = agent.program({})
        except BadInput as missing:
            yield Diagnosis(f"client {name}", False, False, missing.line())
            continue
        where = f"{program.version or 'unknown version'}, {program.path}"
        yield Diagnosis(
            f"client {name}",
            True,
            False,
            where if unusable is None else f"{where}; it cannot be started without bubblewrap: {unusable}",
        )


def _store() -> Iterator[Diagnosis]:
    """The store that machines share, where one is named."""
    if not os.environ.get(STORE):
        return
    try:
        yield Diagnosis("store", True, True, f"{open_store().name} answers")
    except (BadInput, MachineryFault) as fault:
        yield Diagnosis("store", False, True, fault.line())


def _prefect() -> Iterator[Diagnosis]:
    """The Prefect server of ``PREFECT_API_URL`` or of `c4s up`; without one, flows run in the command's process."""
    if not extras.is_installed("service"):
        text = f"Prefect is not installed, flows run in one process ({extras.install('service')})"
        yield Diagnosis("Prefect server", False, False, text)
        return
    from flows.service import Service

    service = Service.read()
    url = os.environ.get("PREFECT_API_URL") or (service.url if service else None)
    if not url:
        text = "none is known (PREFECT_API_URL, `c4s up`): flows run in one process"
        yield Diagnosis("Prefect server", False, False, text)
        return
    from flows.service.health import deployments, health, workers

    if fault := health(url):
        yield Diagnosis("Prefect server", False, False, f"{url}: {fault} (start it, or unset PREFECT_API_URL)")
        return
    yield Diagnosis("Prefect server", True, False, f"{url} answers")
    missing = deployments(url)
    text = f"not deployed: {', '.join(missing)} (`c4s up` deploys them)" if missing else "all flows are deployed"
    yield Diagnosis("Prefect deployments", not missing, False, text)
    for pool, online in workers(url).items():
        text = "no such pool (`c4s up` makes it)" if online is None else f"{online} worker{'' if online == 1 else 's'}"
        yield Diagnosis(f"pool {pool}", bool(online), False, text)


def doctor(json_output: Annotated[bool, typer.Option("--json")] = False) -> int:
    """Say what this machine has and what is missing. Exit 1 when something that c4s needs is missing."""
    found = list(_findings())
    if json_output:
        print_json([asdict(finding) for finding in found])
    else:
        print_table(["what", "found", "needed", ""], [[f.what, f.found, f.needed, f.text] for f in found])
    if any(finding.needed and not finding.found for finding in found):
        raise typer.Exit(1)
    return 0
