"""The work pools and the deployments of the server."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import flows
from c4s.errors import MachineryFault
from c4s.files import digest_bytes, digest_file
from flows.service.health import prefect_yaml
from flows.service.names import POOLS
from flows.service.settings import environment


def make_pools(url: str) -> list[str]:
    """Make the pools that are not there; their names."""
    from prefect.client.orchestration import get_client
    from prefect.client.schemas.actions import WorkPoolCreate
    from prefect.exceptions import ObjectAlreadyExists
    from prefect.settings import PREFECT_API_URL, temporary_settings

    made = []
    with temporary_settings({PREFECT_API_URL: url}), get_client(sync_client=True) as client:
        for name, what in POOLS.items():
            try:
                client.create_work_pool(WorkPoolCreate(name=name, type="process", description=what))
            except ObjectAlreadyExists:
                continue
            made.append(name)
    return made


def declared_digest() -> str:
    """Digest of all that a deployment is made of: the declarations, and the flows with their parameters."""
    places = [prefect_yaml(), *sorted(Path(flows.__file__).parent.rglob("*.py"))]
    return digest_bytes("".join(map(digest_file, places)).encode())


def deploy(url: str) -> None:
    """Deploy every flow of ``prefect.yaml``. ``MachineryFault`` with what Prefect said where it refuses."""
    declared = prefect_yaml()
    told = subprocess.run(
        [sys.executable, "-m", "flows.program", "prefect", "--no-prompt", "deploy", "--all"],
        cwd=declared.parent,
        env=environment(url),
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
    )
    if told.returncode:
        last = " ".join((told.stdout + told.stderr).split())[-600:]
        raise MachineryFault(f"the flows were not deployed: {last}", where=str(declared))
