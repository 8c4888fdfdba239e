"""Suites, packs and plans on the machine that needs them, where machines share an object store."""

from __future__ import annotations

from pathlib import Path

from c4s.errors import BadInput
from c4s.home import packs_root, runs_root, suites_root
from c4s.names import place_in
from c4s.records.folder import RunFolder
from c4s.records.plan import Plan
from c4s.records.suite import SuiteFolder
from c4s.run.store.opening import open_store


def share_suite(suite: str) -> Path:
    """A suite's folder, with its packs beside it; what is built here is sent, what is not is fetched.

    A suite that is in neither is left to whoever opens it; ``BadInput`` for a pack that is in neither.
    """
    folder, store = place_in(suites_root(), suite, "suite"), open_store()
    if not store.apart:
        return folder
    if not SuiteFolder(folder).record.is_file() and not store.pull(folder):
        return folder
    found = SuiteFolder(folder)
    packs = {pack.pack_id for case in found.suite().cases for pack in found.agent_case(case.alias).packs}
    for pack in sorted(packs):
        place = packs_root() / pack
        if not place.is_dir() and not store.pull(place):
            raise BadInput(f"no pack {pack!r} here or in the store", where=store.name, todo="build it here first")
        store.push(place)
    store.push(folder)
    return folder


def shared_plan(run_id: str) -> tuple[Path, Plan]:
    """A run's folder and its frozen plan; ``BadInput`` where there is none."""
    run = place_in(runs_root(), run_id, "run")
    open_store().pull_files(RunFolder(run).plan)
    if not RunFolder(run).plan.is_file():
        raise BadInput("this run has no plan", where=str(run), todo="start it: c4s run, or the flow evaluate")
    return run, Plan.read(RunFolder(run).plan)
