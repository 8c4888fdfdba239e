"""Runs inside the sandbox, with the standard library alone: brings the two servers in, then starts the client.

The sandbox has a network of its own with nothing on it. Each ``PORT=SOCKET`` argument is a loopback port here and a
Unix socket that leads to one server outside; the client sees the same addresses as the host. Arguments after ``--`` are
the client's command line.
"""

from __future__ import annotations

import asyncio
import os
import resource
import sys

MOST_FILE_BYTES = 1 << 30


async def _carry(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    try:
        while portion := await reader.read(1 << 16):
            writer.write(portion)
            await writer.drain()
        writer.write_eof()
    except OSError:
        writer.transport.abort()


async def join(reader: asyncio.StreamReader, writer: asyncio.StreamWriter,
               other: tuple[asyncio.StreamReader, asyncio.StreamWriter]) -> None:
    """Carry bytes both ways until both directions are closed; an end that is gone closes the other."""
    other_reader, other_writer = other
    await asyncio.gather(_carry(reader, other_writer), _carry(other_reader, writer))
    writer.close()
    other_writer.close()


async def main(doors: list[str], command: list[str]) -> int:
    """Open the doors, run the command, return its exit status (128 + signal where it was killed)."""
    for door in doors:
        port, _, path = door.partition("=")

        async def open_door(reader: asyncio.StreamReader, writer: asyncio.StreamWriter, path: str = path) -> None:
            await join(reader, writer, await asyncio.open_unix_connection(path))
        await asyncio.start_server(open_door, "127.0.0.1", int(port))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (MOST_FILE_BYTES, MOST_FILE_BYTES))
    process = await asyncio.create_subprocess_exec(*command)
    status = await process.wait()
    return status if status >= 0 else 128 - status


if __name__ == "__main__":
    split = sys.argv.index("--")
    os._exit(asyncio.run(main(sys.argv[1:split], sys.argv[split + 1:])))
