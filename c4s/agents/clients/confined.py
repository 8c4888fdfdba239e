"""A client process under bubblewrap: its own HOME, an explicit environment, two servers, and nothing else.

What it sees: the system's programs and libraries, its own installation (all read-only), ``/home/agent`` and an empty
``/tmp``. What it reaches: the run's tool gateway and model meter, through Unix sockets. It has no other network, no
other process, no capability, and it dies with this process. What it may use of the machine stands in ``limits.py``.
"""

from __future__ import annotations

import asyncio
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import BinaryIO
from urllib.parse import urlsplit

from c4s.agents.clients import inside
from c4s.agents.clients.limits import ClientLimits, ClientWatch
from c4s.engine.confine import leftovers, seccomp
from c4s.engine.confine.sandbox import faults
from c4s.errors import AgentFault, MachineryFault

HOME = Path("/home/agent")
LOOK_S = 0.2
"""Seconds between two looks at what a client uses, and at whether its run goes on."""
_INSIDE = Path("/run/c4s")
_ETC = {
    "passwd": "agent:x:1000:1000:agent:/home/agent:/bin/sh\n",
    "group": "agent:x:1000:\n",
    "hosts": "127.0.0.1 localhost\n",
    "nsswitch.conf": "passwd: files\ngroup: files\nhosts: files\n",
}
_LINKED = ("/bin", "/sbin", "/lib", "/lib64", "/usr")
_NAMESPACES = (
    "--unshare-all",
    "--unshare-user",
    "--disable-userns",
    "--uid",
    "1000",
    "--gid",
    "1000",
    "--die-with-parent",
    "--new-session",
    "--cap-drop",
    "ALL",
    "--hostname",
    "agent",
    "--clearenv",
    "--proc",
    "/proc",
    "--dev",
    "/dev",
)


@dataclass(frozen=True)
class Command:
    """What is run: the command line as seen inside, its environment, its input, and what it needs to read."""

    arguments: Sequence[str]
    environment: Mapping[str, str]
    read_only: Sequence[Path] = ()
    stdin: bytes = b""


def check() -> None:
    """``MachineryFault`` when this machine cannot confine a client: none is started without its sandbox."""
    fault = faults()["bubblewrap"]
    if fault is not None:
        raise MachineryFault(
            f"agent clients run in bubblewrap, which is unusable here: {fault}",
            todo="install bubblewrap (Debian and Ubuntu: apt-get install bubblewrap)",
        )


def run(
    command: Command,
    home: Path,
    out: Path,
    *,
    servers: Sequence[str] = (),
    stop: Callable[[float], bool] = lambda seconds: threading.Event().wait(seconds),
    limits: ClientLimits | None = None,
) -> int:
    """Run a command to its end, or until ``stop`` says so; its exit status, or -9 where it was killed.

    One that passes a limit is killed with all that it started: ``AgentFault``. What it leaves in its home is kept up to
    ``leftovers.KEPT``, else removed, with a note beside its output.

    Args:
        command: what to run.
        home: host folder that is ``/home/agent`` inside.
        out: file name without suffix: output goes to ``.stdout`` and ``.stderr``.
        servers: addresses on loopback that it may reach, under the same address.
        stop: waits up to so many seconds; True ends the process.
        limits: what it may use of the machine.
    """
    limits = limits or ClientLimits()
    check()
    with (
        _doors(servers) as (folder, doors),
        out.with_suffix(".stdout").open("wb") as told,
        out.with_suffix(".stderr").open("wb") as errors,
    ):
        process = _start(command, home, folder, doors, limits, told, errors)
        watch = ClientWatch(process.pid, home, limits)
        feeder = threading.Thread(target=_feed, args=(process, command.stdin), name="client-input", daemon=True)
        feeder.start()
        try:
            while process.poll() is None:
                if stop(LOOK_S):
                    break
                breach = watch.breach()
                if breach is not None:
                    raise AgentFault(f"the client was ended: {breach}")
        finally:
            process.kill()
            status = process.wait()
            feeder.join()
            leftovers.trim(home, out.with_name("home.trimmed.json"))
        return -signal.SIGKILL if status < 0 else status


def _start(
    command: Command,
    home: Path,
    folder: Path,
    doors: Mapping[int, Path],
    limits: ClientLimits,
    told: BinaryIO,
    errors: BinaryIO,
) -> subprocess.Popen[bytes]:
    line = [shutil.which("bwrap") or "bwrap", *_NAMESPACES]
    for place in ("/tmp", "/dev/shm"):
        line += ["--size", str(limits.temporary), "--tmpfs", place]
    for name in map(Path, _LINKED):
        if name.is_symlink():
            line += ["--symlink", str(name.readlink()), str(name)]
        elif name.exists():
            line += ["--ro-bind", str(name), str(name)]
    for file, text in _ETC.items():
        (folder / file).write_text(text)
        line += ["--ro-bind", str(folder / file), f"/etc/{file}"]
    starter = _INSIDE / "inside.py"
    line += ["--ro-bind", inside.__file__, str(starter)]
    python = Path(sys.executable).resolve()
    visible = list(command.read_only)
    if not python.is_relative_to("/usr"):
        visible.append(Path(sys.base_prefix))
    for path in dict.fromkeys(visible):
        line += ["--ro-bind", str(path.resolve()), str(path)]
    line += ["--bind", str(home), str(HOME)]
    for path in doors.values():
        line += ["--bind", str(path), str(_INSIDE / path.name)]
    for key, value in {
        "PATH": "/usr/local/bin:/usr/bin:/bin",
        "HOME": str(HOME),
        "LANG": "C.UTF-8",
        "USER": "agent",
        "TMPDIR": "/tmp",
        **command.environment,
    }.items():
        line += ["--setenv", key, value]
    line += ["--remount-ro", "/dev", "--remount-ro", "/", "--chdir", str(HOME)]
    line += ["--", str(python), "-I", "-S", str(starter)]
    line += [f"{port}={_INSIDE / path.name}" for port, path in doors.items()]
    line += [
        f"CPU={limits.cpu_s}",
        f"DATA={limits.data}",
        f"FSIZE={limits.file_size}",
        f"NOFILE={limits.open_files}",
        f"NPROC={2 * limits.threads}",
    ]
    (folder / "filter").write_bytes(seccomp.client_program())
    with (folder / "filter").open("rb") as program:
        line[1:1] = ["--seccomp", str(program.fileno())]
        return subprocess.Popen(
            [*line, "--", *command.arguments],
            stdin=subprocess.PIPE,
            stdout=told,
            stderr=errors,
            env={},
            pass_fds=[program.fileno()],
            start_new_session=True,
        )


def _feed(process: subprocess.Popen[bytes], text: bytes) -> None:
    """Write a process's input through a pipe (some clients read no file) and close it; one that ended reads no more."""
    assert process.stdin is not None
    with suppress(BrokenPipeError), process.stdin as pipe:
        pipe.write(text)


@contextmanager
def _doors(servers: Sequence[str]) -> Iterator[tuple[Path, dict[int, Path]]]:
    """A Unix socket for each server, carried to it while the context is open: the folder, and socket by port."""
    with tempfile.TemporaryDirectory(prefix="c4s-client-") as name:
        folder, started, stopping = Path(name), threading.Event(), threading.Event()
        ports = [port for server in servers if (port := urlsplit(server).port) is not None]
        doors = {port: folder / f"{port}.sock" for port in ports}
        thread = threading.Thread(
            target=lambda: asyncio.run(_carry(doors, started, stopping)), name="client-doors", daemon=True
        )
        thread.start()
        try:
            if not started.wait(10):
                raise MachineryFault("the client's way to its servers did not open", where=name)
            yield folder, doors
        finally:
            stopping.set()
            thread.join()


async def _carry(doors: Mapping[int, Path], started: threading.Event, stopping: threading.Event) -> None:
    """Carry connections to the Unix sockets on to the ports until ``stopping`` is set."""
    open_doors: set[asyncio.Task[None]] = set()

    def opener(port: int) -> Callable[[asyncio.StreamReader, asyncio.StreamWriter], None]:
        door = inside.Door(partial(asyncio.open_connection, "127.0.0.1", port))

        def opened(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
            task = asyncio.ensure_future(door.open(reader, writer))
            open_doors.add(task)
            task.add_done_callback(open_doors.discard)

        return opened

    servers = [
        await asyncio.start_unix_server(opener(port), path, backlog=inside.MOST_CARRIED) for port, path in doors.items()
    ]
    started.set()
    await asyncio.to_thread(stopping.wait)
    for server in servers:
        server.close()
    for task in open_doors:
        task.cancel()
    await asyncio.gather(*open_doors, return_exceptions=True)
