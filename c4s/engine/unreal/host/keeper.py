"""A small process between the host and an editor: whatever the editor starts ends with it, and it ends with the host.

``python -m c4s.engine.unreal.host.keeper LIFE RULES PROGRAM ...`` starts the program and ends with its exit code. When
the descriptor LIFE is closed on the other side, because the host has died, or it gets SIGTERM, all that the program
started is killed. Processes that an editor leaves behind become the keeper's children, so none is lost.
"""

from __future__ import annotations

import ctypes
import json
import os
import select
import signal
import subprocess
import sys
import time
from contextlib import suppress
from functools import partial
from pathlib import Path

from c4s.engine.confine import landlock

_SET_PDEATHSIG, _SET_CHILD_SUBREAPER, _SET_NO_NEW_PRIVS = 1, 36, 38
_END_S = 5.0
"""How long killed processes may take to go."""
_LOOK_S = 0.01
KILLED = 128 + signal.SIGKILL


def main() -> None:
    """Entry point."""
    life, rules, program = int(sys.argv[1]), json.loads(sys.argv[2]), sys.argv[3:]
    _prctl(_SET_CHILD_SUBREAPER, 1)
    os.set_inheritable(life, False)
    asked, ask = os.pipe()
    signal.signal(signal.SIGTERM, lambda *_: os.write(ask, b"t"))
    os.environ.pop("PYTHONPATH", None)  # it leads this process to c4s, and an editor's Python to what is not its own
    child = subprocess.Popen(
        program, stdin=subprocess.DEVNULL, start_new_session=True, preexec_fn=partial(_confine, rules)
    )
    code = _wait(child, [life, asked])
    _end_all()
    os._exit(code)


def _wait(child: subprocess.Popen[bytes], asked: list[int]) -> int:
    """Until the program has ended (its code, of a signal 128 and its number) or the host lets go."""
    ended = os.pidfd_open(child.pid)
    ready, _, _ = select.select([ended, *asked], [], [])
    if ended not in ready:
        return KILLED
    code = child.wait()
    return code if code >= 0 else 128 - code


def _end_all() -> None:
    """Kill every process below this one, and wait for them."""
    until = time.monotonic() + _END_S
    while time.monotonic() < until:
        for process in _below(os.getpid()):
            with suppress(ProcessLookupError):
                os.kill(process, signal.SIGKILL)
        try:
            while os.waitpid(-1, os.WNOHANG)[0]:
                pass
        except ChildProcessError:
            return
        time.sleep(_LOOK_S)


def _below(process: int) -> list[int]:
    """The processes that a process started, and theirs."""
    found, waiting = [], [process]
    while waiting:
        with suppress(OSError):
            for task in Path(f"/proc/{waiting.pop()}/task").iterdir():
                children = [int(child) for child in (task / "children").read_text().split()]
                found += children
                waiting += children
    return found


def _confine(rules: dict[str, list[str]] | None) -> None:
    """In the program's process, before it is the program: it dies with the keeper, and keeps to its paths."""
    _prctl(_SET_PDEATHSIG, signal.SIGKILL)
    if rules is not None:
        _prctl(_SET_NO_NEW_PRIVS, 1)
        paths = {name: [Path(path) for path in told] for name, told in rules.items()}
        landlock.restrict((), paths["read_write"], programs=paths["programs"], devices=paths["devices"])


def _prctl(option: int, value: int) -> None:
    ctypes.CDLL(None, use_errno=True).prctl(option, value, 0, 0, 0)


if __name__ == "__main__":
    main()
