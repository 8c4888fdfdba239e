"""Slots of one kind: so many jobs at once, and a free slot goes to the waiting job of the earliest trial."""

from __future__ import annotations

import asyncio
import heapq
import itertools
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from c4s.errors import BadInput


class Slots:
    """While a job waits, every slot is taken. Waiting costs no thread."""

    def __init__(self, count: int) -> None:
        if count < 1:
            raise BadInput(f"{count} slots hold no job", todo="give 1 or more")
        self.count = self._free = count
        self._waiting: list[tuple[int, int, asyncio.Future[None]]] = []
        self._arrival = itertools.count()

    @property
    def taken(self) -> int:
        """Slots in use."""
        return self.count - self._free

    @property
    def waiting(self) -> int:
        """Jobs that wait for a slot."""
        return sum(not turn.done() for _, _, turn in self._waiting)

    @asynccontextmanager
    async def slot(self, rank: int) -> AsyncIterator[None]:
        """Hold a slot for the block. The lowest rank goes first, then who came first."""
        if self._free:
            self._free -= 1
        else:
            await self._turn(rank)
        try:
            yield
        finally:
            self._give_back()

    async def _turn(self, rank: int) -> None:
        turn = asyncio.get_running_loop().create_future()
        heapq.heappush(self._waiting, (rank, next(self._arrival), turn))
        try:
            await turn
        except asyncio.CancelledError:
            if turn.done() and not turn.cancelled():
                self._give_back()
            raise

    def _give_back(self) -> None:
        while self._waiting:
            turn = heapq.heappop(self._waiting)[2]
            if not turn.done():
                turn.set_result(None)
                return
        self._free += 1
