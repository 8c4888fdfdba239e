"""Suites, packs and plans on the machine that needs them, where machines share an object store."""

from __future__ import annotations

from pathlib import Path

from c4s.errors import BadInput
from c4s.home import packs_root, runs_root, suites_root
from c4s.names import place_in
from c4s.records.folder import RunFolder
from c4s.records.pack import MANIFEST
from c4s.records.plan import Plan
from c4s.records.suite import SuiteFolder
from c4s.run.store.base import Store
from c4s.run.store.opening import open_store


def share_suite(suite: str) -> Path:
    """A suite's folder, with its packs beside it; what is not here is fetched, and nothing is sent.

    A suite that is in neither place is left to whoever opens it; ``BadInput`` for a pack that is in neither.
    """
    folder, store = place_in(suites_root(), suite, "suite"), open_store()
    if not store.apart:
        return folder
    if not _is_here(folder, SuiteFolder(folder).record, store):
        return folder
    for pack in _packs(SuiteFolder(folder)):
        place = packs_root() / pack
        if not _is_here(place, place / MANIFEST, store):
            raise BadInput(f"no pack {pack!r} here or in the store", where=store.name, todo="build it here first")
    return folder


def send_suite(suite: str) -> None:
    """Put a suite that is here, and its packs, in place of what the store has: for who builds it or starts a run."""
    folder, store = share_suite(suite), open_store()
    if store.apart and SuiteFolder(folder).record.is_file():
        for pack in _packs(SuiteFolder(folder)):
            store.push(packs_root() / pack)
        store.push(folder)


def shared_plan(run_id: str) -> tuple[Path, Plan]:
    """A run's folder and its frozen plan, whose suite is here: for who works on it, and sends no suite.

    ``BadInput`` where there is no plan, and where the suite is another one than it froze.
    """
    run = place_in(runs_root(), run_id, "run")
    open_store().pull_files(RunFolder(run).plan)
    if not RunFolder(run).plan.is_file():
        raise BadInput("this run has no plan", where=str(run), todo="start it: c4s run, or the flow evaluate")
    plan = Plan.read(RunFolder(run).plan)
    suite = SuiteFolder(share_suite(plan.suite_id))
    if not suite.record.is_file():
        raise BadInput(f"the suite of the run {run_id!r} is not here", where=str(suite.root), todo="build it first")
    if suite.suite().sha256() != plan.suite_digest:
        raise BadInput(
            f"this is another suite than the run {run_id!r} was planned with",
            where=str(suite.root),
            todo="restore that one; where machines share a store, move this one away and it is fetched",
        )
    return run, plan


def _is_here(folder: Path, record: Path, store: Store) -> bool:
    """Whether a suite or a pack is here, or was fetched: its record last, so that a fetch that is cut off is none."""
    if record.is_file():
        return True
    store.pull(folder, lambda name: name != record.name)
    store.pull(folder, lambda name: name == record.name)
    return record.is_file()


def _packs(suite: SuiteFolder) -> list[str]:
    return sorted({pack.pack_id for case in suite.suite().cases for pack in suite.agent_case(case.alias).packs})
