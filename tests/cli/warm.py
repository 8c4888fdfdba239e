"""``c4s`` as a real process for each call, without its start: a process with everything imported forks for each.

The child has its own working directory, environment and standard streams, and calls the ``main`` of the console script.
"""

from __future__ import annotations

import atexit
import functools
import gc
import importlib
import json
import os
import pkgutil
import resource
import signal
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any, NoReturn, Self

LIMIT_S = 60
CPU_S, MOST_BYTES = 120, 6 << 30
"""What a call may use, so that one that runs away harms nobody."""
HUNG = -1
ENVIRONMENT = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
"""Of the process: what was set before any test changed it."""
IMPORTED = ("c4s", "cases", "catalog", "warehouse", "reports")
LEFT_OUT = (
    *("c4s.engine.headless.", "c4s.engine.unreal.boot.", "c4s.engine.unreal.standin.", "c4s.editor"),
    "c4s.harness.inspecting",
)
"""What runs beside agent code in processes of its own, and what Inspect imports where it is installed."""


@dataclass(frozen=True)
class Done:
    """How a call ended. ``code`` is ``HUNG`` when it took too long; another number below zero is a signal."""

    code: int
    out: str
    err: str


class Warm:
    """The process that forks. Use it as a context manager."""

    def __enter__(self) -> Self:
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tests.cli.warm"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            cwd=Path(__file__).parents[2],
            env=ENVIRONMENT,
        )
        self._folder = tempfile.TemporaryDirectory(prefix="c4s-warm-")
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        assert self._process.stdin is not None and self._process.stdout is not None
        self._process.stdin.close()
        self._process.wait()
        self._process.stdout.close()
        self._folder.cleanup()

    def call(
        self, arguments: Sequence[str], *, cwd: Path, environment: Mapping[str, str | None], limit_s: int = LIMIT_S
    ) -> Done:
        """``c4s ARGUMENTS``; a variable that is None is unset. Lone surrogates in arguments stand for raw bytes."""
        out, err = Path(self._folder.name, "out"), Path(self._folder.name, "err")
        request = {"arguments": list(arguments), "cwd": str(cwd), "environment": dict(environment), "limit_s": limit_s}
        assert self._process.stdin is not None and self._process.stdout is not None
        self._process.stdin.write(json.dumps({**request, "out": str(out), "err": str(err)}).encode() + b"\n")
        self._process.stdin.flush()
        code = int(self._process.stdout.readline())
        return Done(code, out.read_text(errors="backslashreplace"), err.read_text(errors="backslashreplace"))


@functools.cache
def warm_process() -> Warm:
    """The one of this process, until it ends."""
    with ExitStack() as stack:
        warm = stack.enter_context(Warm())
        atexit.register(stack.pop_all().close)
    return warm


def _serve() -> None:
    from c4s.cli.main import command, main

    command()
    for root in IMPORTED:
        for module in pkgutil.walk_packages(importlib.import_module(root).__path__, f"{root}."):
            if not module.name.startswith(LEFT_OUT) and not module.name.endswith("__main__"):
                importlib.import_module(module.name)
    gc.freeze()
    answers = os.fdopen(os.dup(1), "w")
    for line in sys.stdin.buffer:
        request = json.loads(line)
        child = os.fork()
        if not child:
            _become(request, main)
        answers.write(f"{_ended(child, request['limit_s'])}\n")
        answers.flush()
    os._exit(0)  # without what libraries say of themselves at an end


def _become(request: Mapping[str, Any], main: Any) -> NoReturn:
    """The rest of the child's life."""
    code = 1
    try:
        os.setpgid(0, 0)
        resource.setrlimit(resource.RLIMIT_CPU, (CPU_S, CPU_S))
        resource.setrlimit(resource.RLIMIT_AS, (MOST_BYTES, MOST_BYTES))
        for name, target in (("out", 1), ("err", 2)):
            handle = os.open(request[name], os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
            os.dup2(handle, target)
            os.close(handle)
        null = os.open(os.devnull, os.O_RDONLY)
        os.dup2(null, 0)
        os.chdir(request["cwd"])
        for name, value in request["environment"].items():
            os.environ.pop(name, None) if value is None else os.environ.__setitem__(name, value)
        sys.argv = ["c4s", *request["arguments"]]
        main()
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else 1
    except BaseException:
        sys.excepthook(*sys.exc_info())
    finally:
        try:
            sys.stdout.flush()
            sys.stderr.flush()
        except (OSError, ValueError):
            code = 120
        os._exit(code)


def _ended(child: int, limit_s: int) -> int:
    """Its exit code; a child that is not done after ``limit_s`` is ended with all that it started."""
    signal.signal(signal.SIGALRM, lambda *_: os.killpg(child, signal.SIGKILL))
    signal.alarm(limit_s)
    _, status = os.waitpid(child, 0)
    left = signal.alarm(0)
    return HUNG if os.WIFSIGNALED(status) and not left else os.waitstatus_to_exitcode(status)


if __name__ == "__main__":
    _serve()
