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


async def join(
    reader: asyncio.StreamReader, writer: asyncio.StreamWriter, other: tuple[asyncio.StreamReader, asyncio.StreamWriter]
) -> None:
    """Carry bytes both ways until both directions are closed; an end that is gone closes the other."""
    other_reader, other_writer = other
    await asyncio.gather(_carry(reader, other_writer), _carry(other_reader, writer))
    writer.close()
    other_writer.close()


def _limit(limits: list[str]) -> None:
    """Set the limits ``RESOURCE=VALUE`` for good, those of ``resource`` without their ``RLIMIT_``."""
    for limit in ("CORE=0", *limits):
        name, _, value = limit.partition("=")
        kind = getattr(resource, f"RLIMIT_{name}")
        hard = resource.getrlimit(kind)[1]
        bound = int(value) if hard == resource.RLIM_INFINITY else min(int(value), hard)
        resource.setrlimit(kind, (bound, bound))
    os.nice(NICENESS)


async def main(doors: list[str], limits: list[str], command: list[str]) -> int:
    """Open the doors, run the command, return its exit status (128 + signal where it was killed)."""
    for door in doors:
        port, _, path = door.partition("=")

        async def open_door(reader: asyncio.StreamReader, writer: asyncio.StreamWriter, path: str = path) -> None:
            await join(reader, writer, await asyncio.open_unix_connection(path))

        await asyncio.start_server(open_door, "127.0.0.1", int(port))
    process = await asyncio.create_subprocess_exec(*command, preexec_fn=lambda: _limit(limits))
    status = await process.wait()
    return status if status >= 0 else 128 - status


if __name__ == "__main__":
    split = sys.argv.index("--")
    told = sys.argv[1:split]
    os._exit(
        asyncio.run(
            main(
                [one for one in told if one[0].isdigit()],
                [one for one in told if one[0].isalpha()],
                sys.argv[split + 1 :],
            )
        )
    )
