"""Runs inside the sandbox, with the standard library alone: brings the two servers in, then starts the client.

The sandbox has a network of its own with nothing on it. Each ``PORT=SOCKET`` argument is a loopback port here and a
Unix socket that leads to one server outside; the client sees the same addresses as the host. Each ``RESOURCE=VALUE``
argument is a limit of every process of the client. Arguments after ``--`` are its command line.
"""

from __future__ import annotations

import asyncio
import os
import resource
import sys
from collections.abc import Awaitable, Callable
from functools import partial

NICENESS = 5
"""The client yields to the gateway, which serves it, and to the watch over it."""


async def _carry(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    try:
        while portion := await reader.read(1 << 16):
            writer.write(portion)
            await writer.drain()
        writer.write_eof()
    except OSError:
        writer.transport.abort()


MOST_CARRIED = 64
"""Connections through one door at a time; one more is closed at once."""


class Door:
    """Carries the connections of one door to the other side, which ``reach`` opens."""

    def __init__(self, reach: Callable[[], Awaitable[tuple[asyncio.StreamReader, asyncio.StreamWriter]]]) -> None:
        self._reach, self._carried = reach, 0

    async def open(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        """Carry bytes both ways until the server's side has closed, or the client's is gone."""
        if self._carried >= MOST_CARRIED:
            writer.transport.abort()
            return
        self._carried += 1
        try:
            server_reader, server_writer = await self._reach()
            asking = asyncio.ensure_future(_carry(reader, server_writer))
            try:
                await _carry(server_reader, writer)
            finally:
                asking.cancel()
                server_writer.close()
        except OSError:
            pass  # the server takes no more: the client sees its connection closed
        finally:
            self._carried -= 1
            writer.close()


def _limit(limits: list[str]) -> None:
    """Set the limits ``RESOURCE=VALUE`` for good, those of ``resource`` without their ``RLIMIT_``."""
    for limit in ("CORE=0", *limits):
        name, _, value = limit.partition("=")
        kind = getattr(resource, f"RLIMIT_{name}")
        hard = resource.getrlimit(kind)[1]
        bound = int(value) if hard == resource.RLIM_INFINITY else min(int(value), hard)
        resource.setrlimit(kind, (bound, bound))
    os.nice(NICENESS)


async def main(doors: list[str], limits: list[str], command: list[str]) -> None:
    """Open the doors, run the command, end with its exit status (128 + signal where it was killed)."""
    for door in doors:
        port, _, path = door.partition("=")
        await asyncio.start_server(
            Door(partial(asyncio.open_unix_connection, path)).open, "127.0.0.1", int(port), backlog=MOST_CARRIED
        )
    process = await asyncio.create_subprocess_exec(*command, preexec_fn=lambda: _limit(limits))
    status = await process.wait()
    os._exit(status if status >= 0 else 128 - status)


if __name__ == "__main__":
    split = sys.argv.index("--")
    told = sys.argv[1:split]
    asyncio.run(
        main(
            [one for one in told if one[0].isdigit()], [one for one in told if one[0].isalpha()], sys.argv[split + 1 :]
        )
    )
