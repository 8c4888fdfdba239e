"""The curate flow: a suite built, checked and audited, before anybody runs on it."""

from __future__ import annotations

from typing import Any, Literal

from prefect import flow
from prefect.artifacts import create_table_artifact

from c4s.errors import BadInput
from c4s.home import packs_root, suites_root
from c4s.names import place_in
from c4s.packs.suite_check import suite_changes
from c4s.records.suite import SuiteFolder
from c4s.run.headroom import print_line
from c4s.run.store import send_suite
from c4s.trees import refuse
from cases.audit import audit, check_blind, mean_f1
from cases.starter.suite import build_starter
from flows.family import die_with_the_worker
from flows.server import tie

tie()


@flow(name="curate", flow_run_name="{suite}")
def curate(suite: str = "starter", build: Literal["if missing", "never"] = "if missing") -> dict[str, Any]:
    """Build a suite where it ships and is missing, compare every byte with what was frozen, and audit it.

    The audit tries to repair every case without looking at a picture; a suite that gives something away fails. Where
    machines share an object store, the suite and its packs are sent there.

    Args:
        suite: id of a suite that is built here, or ships.
        build: whether a suite that ships is built where it is missing.
    """
    die_with_the_worker()
    folder = SuiteFolder(place_in(suites_root(), suite, "suite"))
    if not folder.record.is_file() and suite == "starter" and build == "if missing":
        build_starter(folder.root, packs_root(), print_line)
    if not folder.record.is_file():
        raise BadInput(f"no suite {suite!r} is built", where=str(folder.root), todo="build or import it first")
    read: list[str] = []
    refuse(suite_changes(folder, read.append), todo="restore the files, or build again with --replace")
    rows = list(audit(folder, packs_root()))
    means = mean_f1(rows)
    create_table_artifact(
        [{"way": way, "mean F1": round(value, 4)} for way, value in means.items()]
        or [{"way": "none", "mean F1": None}],
        key=f"audit-{suite}",
        description=f"Repairs without a look at a picture, {len(rows)} cases",
    )
    if rows:
        check_blind(rows)
    send_suite(suite)
    return {"suite": suite, "files": len(read), "repairs": len(rows), "best_blind_f1": max(means.values(), default=0.0)}
