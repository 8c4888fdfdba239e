"""What a Prefect server has of what c4s needs."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any, Final

import flows
from c4s.errors import MachineryFault
from c4s.files import read_yaml
from c4s.proxies import check_proxies
from flows.service.names import POOLS

_TIMEOUT_S: Final = 10.0
_ERROR_NUMBER: Final = re.compile(r"\[Errno -?\d+\] ")


def health(url: str) -> str:
    """What is wrong with the server of a URL; empty where it answers."""
    import httpx

    check_proxies()
    try:
        answer = httpx.get(f"{url.rstrip('/')}/health", timeout=_TIMEOUT_S)
    except (httpx.HTTPError, httpx.InvalidURL) as error:
        return f"it does not answer: {_ERROR_NUMBER.sub('', str(error))}"
    return "" if answer.is_success else f"it answers {answer.status_code}"


def workers(url: str) -> dict[str, int | None]:
    """How many workers of each pool are online; None for a pool that is not there."""
    there = {str(pool["name"]) for pool in _ask(url, "work_pools/filter")}
    return {
        pool: sum(one["status"] == "ONLINE" for one in _ask(url, f"work_pools/{pool}/workers/filter"))
        if pool in there
        else None
        for pool in POOLS
    }


def deployments(url: str) -> list[str]:
    """The deployments of ``prefect.yaml`` that the server does not have, ``flow/name`` each."""
    flows_by_id = {one["id"]: one["name"] for one in _ask(url, "flows/filter")}
    there = {f"{flows_by_id.get(one['flow_id'])}/{one['name']}" for one in _ask(url, "deployments/filter")}
    asked = read_yaml(prefect_yaml(), what="deployments")["deployments"]
    return sorted({f"{one['entrypoint'].rpartition('.')[2]}/{one['name']}" for one in asked} - there)


def prefect_yaml() -> Path:
    """Where the deployments are declared."""
    return Path(flows.__file__).resolve().parent / "prefect.yaml"


def _ask(url: str, what: str) -> list[dict[str, Any]]:
    import httpx

    try:
        answer = httpx.post(f"{url.rstrip('/')}/{what}", json={}, timeout=_TIMEOUT_S)
        answer.raise_for_status()
        found: list[dict[str, Any]] = answer.json()
    except (httpx.HTTPError, ValueError) as error:
        raise MachineryFault(f"the Prefect server does not say what it has: {error}", where=url) from error
    return found
