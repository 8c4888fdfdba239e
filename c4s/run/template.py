"""The inside of the process that worker processes are forked from: it has loaded what they work with, and does no work.

It is told to fork by a datagram that carries the worker's end of its channel, and tells how each worker ended:
``ENDED`` with its process id and exit code. When it forks it has one thread, its own: what it loads starts none but
those of OpenBLAS, which ends them before a fork and starts them anew where they are needed.
"""

from __future__ import annotations

import gc
import importlib
import os
import pickle
import selectors
import signal
import socket
import struct
from contextlib import suppress
from typing import Final

from c4s.garbage import put_off
from c4s.run import worker

ENDED = struct.Struct(">qi")
ORDER: Final = b"fork"
LOADED: Final = ("c4s.run.stages", "c4s.run.attempt", "c4s.evidence", "c4s.run.looking", "c4s.toolbox.client", "mcp")


def serve(control: int, parent: int) -> None:
    """Fork workers until the parent closes the control. Die with the parent, and leave Ctrl-C to it."""
    worker.die_with(parent)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with put_off():
        for module in LOADED:
            with suppress(Exception):
                importlib.import_module(module)
    gc.freeze()
    own, channel = os.getpid(), _forked(control)
    if channel is not None:
        worker.serve(channel, own)


def _forked(control: int) -> int | None:
    """In each worker its channel; in the template itself, at its end, None. A worker keeps nothing else of it open."""
    workers: dict[int, int] = {}
    with socket.socket(fileno=control) as orders, selectors.PollSelector() as watched:
        watched.register(orders, selectors.EVENT_READ)
        while True:
            for key, _ in watched.select():
                if key.fd != control:
                    watched.unregister(key.fd)
                    os.close(key.fd)
                    _bury(orders, workers.pop(key.fd))
                    continue
                order, channels, _, _ = socket.recv_fds(orders, len(ORDER), 1)
                if not order:
                    return None
                for channel in channels:
                    process = _fork(channel)
                    if process == 0:
                        for handle in workers:
                            os.close(handle)
                        return channel
                    os.close(channel)
                    if process is not None:
                        handle = os.pidfd_open(process)
                        workers[handle] = process
                        watched.register(handle, selectors.EVENT_READ)


def _fork(channel: int) -> int | None:
    """``os.fork``; where there is no room for it, who asked is told so."""
    try:
        return os.fork()
    except OSError as error:
        with socket.socket(fileno=os.dup(channel)) as connection, suppress(OSError):
            worker.send(connection, pickle.dumps(error))
        return None


def _bury(orders: socket.socket, process: int) -> None:
    code = os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])
    with suppress(OSError):
        orders.send(ENDED.pack(process, code), socket.MSG_DONTWAIT)
