"""A trial in work: held here and nowhere else, and kept whole in the store that machines share."""

from __future__ import annotations

import asyncio
import os
from collections.abc import AsyncIterator, Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import asynccontextmanager, suppress
from functools import cache, partial
from typing import Any, TypeVar, TypeVarTuple

from c4s.records.plan import Plan
from c4s.run.lease import BEAT_S, WAIT_S, Held, LeaseLost, take
from c4s.run.limits import Stage
from c4s.run.plan import Trial
from c4s.run.store import FolderLeases, Store, StoreFault, open_store
from c4s.run.torn import settle
from c4s.run.trial import Do

Args = TypeVarTuple("Args")
R = TypeVar("R")


class Sending:
    """Puts a trial's folder in the store after each stage, so that a machine that is lost costs the stage in work."""

    def __init__(self, trial: Trial, store: Store, held: Held) -> None:
        self._trial, self._store, self._held = trial, store, held
        self._one_at_a_time = asyncio.Lock()

    def sending(self, do: Do) -> Do:
        """``do``, and what it made is sent before the next stage begins."""
        if not self._store.apart:
            return do

        async def sent(stage: Stage, *arguments: Any) -> Any:
            made = await do(stage, *arguments)
            await self.send()
            return made

        return sent

    async def send(self) -> None:
        """Send the folder as it is. ``LeaseLost`` where it is another's by now: what that one sent stays."""
        if self._store.apart:
            async with self._one_at_a_time:
                await asyncio.to_thread(self._store.push, self._trial.folder.root, self._held.check)


@cache
def _desk(process: int) -> ThreadPoolExecutor:
    """Where trials are taken in the order in which they are asked for: one a process, also after a fork."""
    return ThreadPoolExecutor(1, "leases")


async def in_order(function: Callable[[*Args], R], *arguments: *Args) -> R:
    """Run a short function beside the event loop, after those that were asked for before."""
    return await asyncio.get_running_loop().run_in_executor(_desk(os.getpid()), partial(function, *arguments))


@asynccontextmanager
async def while_held(held: Held) -> AsyncIterator[None]:
    """The block is ended as soon as the lease is lost, with ``LeaseLost``."""
    working, lost = asyncio.current_task(), list[LeaseLost]()

    async def watch() -> None:
        while not lost:
            await asyncio.sleep(BEAT_S)
            try:
                with suppress(StoreFault):
                    await held.check_beside()
            except LeaseLost as error:
                lost.append(error)
                if working is not None:
                    working.cancel()

    watching = asyncio.ensure_future(watch())
    try:
        yield
    except asyncio.CancelledError:
        if lost and working is not None and working.uncancel() == 0:
            raise lost[0] from None
        raise
    finally:
        watching.cancel()


@asynccontextmanager
async def holding_trial(trial: Trial) -> AsyncIterator[tuple[Held, Sending, bool]]:
    """Hold the lease of a trial for the block, once nobody else does, with its folder as the store has it.

    Gives the lease, what sends the folder, and whether somebody else was waited for.
    """
    store, waited = open_store(), False
    place = store.leases(trial.folder.leases)
    while not isinstance(held := await in_order(take, place, "trial"), Held):
        waited = True
        await asyncio.sleep(WAIT_S)
    try:
        if store.apart:
            await asyncio.to_thread(store.pull, trial.folder.root)
        yield held, Sending(trial, store, held), waited or store.apart
    finally:
        await in_order(held.give_back)


def settle_free(trial: Trial, plan: Plan) -> list[str]:
    """Settle a trial that nobody works on; what was set aside, a line each. ``BadInput`` as ``settle``."""
    if open_store().apart or not trial.folder.root.is_dir():
        return []
    held = take(FolderLeases(trial.folder.leases), "trial")
    if not isinstance(held, Held):
        return []
    try:
        return settle(trial, plan)
    finally:
        held.give_back()
