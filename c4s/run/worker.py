"""The inside of a worker process: one job at a time, from its parent and back to it.

A message is its length (8 bytes) and a pickle. A job is a function and its arguments, each a pickle; the answer is
whether it returned, what it returned or raised, and how long it took with the import of its code.
"""

from __future__ import annotations

import ctypes
import os
import pickle
import signal
import socket
import struct
import tempfile
import time
import traceback
from pathlib import Path
from typing import Any

from c4s.errors import MachineryFault, OverLimit, shortage

HEADER = struct.Struct(">Q")
PR_SET_PDEATHSIG = 1
PR_SET_CHILD_SUBREAPER = 36


def serve(channel: int, parent: int) -> None:
    """Work off jobs until the channel is closed. Die with the parent, which leaves Ctrl-C to whoever started it.

    The first message is the environment to work in, and is answered with the process id. What a job starts stays this
    process's, also where its own parent has ended, so that all of it can be ended.
    """
    die_with(parent)
    ctypes.CDLL(None, use_errno=True).prctl(PR_SET_CHILD_SUBREAPER, 1)
    with socket.socket(fileno=channel) as connection, connection.makefile("rb") as jobs:
        if header := jobs.read(HEADER.size):
            _work_in(*pickle.loads(jobs.read(HEADER.unpack(header)[0])))
            send(connection, pickle.dumps(os.getpid()))
        while header := jobs.read(HEADER.size):
            send(connection, _done(jobs.read(HEADER.unpack(header)[0])))


def die_with(parent: int) -> None:
    """Let the kernel end this process with its parent; at once where that has ended already."""
    ctypes.CDLL(None, use_errno=True).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:
        os._exit(1)


def _work_in(environment: dict[str, str], folder: str) -> None:
    os.environ.clear()
    os.environ.update(environment)
    tempfile.tempdir = None
    os.chdir(folder)


def send(connection: socket.socket, message: bytes) -> None:
    connection.sendall(HEADER.pack(len(message)) + message)


def _done(job: bytes) -> bytes:
    """Do a job: ``(returned, value or exception, seconds)`` as a pickle.

    A temporary folder that somebody cleaned away is there again for the next job.
    """
    started = time.perf_counter()
    returned, value = False, None
    try:
        Path(tempfile.gettempdir()).mkdir(exist_ok=True)
        code, given = pickle.loads(job)
        function = pickle.loads(code)
        imported = time.perf_counter()
        arguments = pickle.loads(given)
        started += time.perf_counter() - imported
        returned, value = True, function(*arguments)
    except MemoryError:
        value = OverLimit("it asked for more memory than there is")
    except BaseException as error:
        value = _whole(error)
    seconds = time.perf_counter() - started
    try:
        return pickle.dumps((returned, value, seconds))
    except Exception as error:
        return pickle.dumps(
            (False, MachineryFault(f"what a stage returned cannot leave its process: {error}"), seconds)
        )


def _whole(error: BaseException) -> BaseException:
    """The exception with where it was raised; one that cannot cross the border, or would end a process, as a fault.

    What caused it stays behind, so what the machine is short of is told in its place.
    """
    told = "".join(traceback.format_exception(error))
    crosses = isinstance(error, Exception) and _crosses(error)
    whole = shortage(error) or (error if crosses else MachineryFault(f"{type(error).__name__}: {error}"))
    whole.add_note(f"in a worker process:\n{told}")
    return whole


def _crosses(error: Exception) -> bool:
    """Whether the exception is one of its own class on the other side. Its class may do anything when it is copied."""
    try:
        copy: Any = pickle.loads(pickle.dumps(error))
    except Exception:
        return False
    return type(copy) is type(error)
