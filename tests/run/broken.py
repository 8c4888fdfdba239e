"""Stages that go wrong on chosen trials, run by the real command line: ``python -c 'from tests.run.broken import main;
main()' run ...``. ``BROKEN`` in the environment names ``stage:configuration:case prefix:how``, several by commas."""

from __future__ import annotations

import os
import signal
import threading
from pathlib import Path
from typing import Any, NoReturn

from c4s.run import limits, stages
from c4s.run.limits import Limit
from c4s.run.processes import _family

REAL = {name: getattr(stages, name) for name in ("attempt", "integrity", "look", "verify", "score")}
SECONDS, MEMORY_BYTES = 12.0, 1 << 30


def _never(how: str) -> NoReturn:
    held = []
    while True:
        if how == "dies":
            os.kill(os.getpid(), signal.SIGKILL)
        if how == "grows":
            held.append(bytearray(os.urandom(1) * (32 << 20)))


def _kill_engine(trajectory: Path, before: int | None) -> None:
    """Kill the engine of this process from outside, as soon as the agent has been answered.

    ``before``: the file of the attempt before, which is moved away.
    """
    while _file(trajectory) in (None, before) or b'"event":"call"' not in trajectory.read_bytes():
        threading.Event().wait(0.005)
    for engine in _family(os.getpid())[1:]:
        os.kill(engine, signal.SIGKILL)


def _file(path: Path) -> int | None:
    return path.stat().st_ino if path.is_file() else None


def _stage(name: str, trial: Any, *given: Any) -> Any:
    for broken in filter(None, os.environ.get("BROKEN", "").split(",")):
        stage, configuration, case, how = broken.split(":")
        if (stage, configuration) == (name, trial.configuration.name) and trial.case.case_id.startswith(case):
            if how == "loses-its-engine" and given[-1] == 2:
                continue
            if how == "loses-its-engine":
                trajectory = trial.folder.attempt(1).trajectory
                threading.Thread(target=_kill_engine, args=(trajectory, _file(trajectory)), daemon=True).start()
            else:
                _never(how)
    return REAL[name](trial, *given)


def attempt(*given: Any) -> Any:
    return _stage("attempt", *given)


def integrity(*given: Any) -> Any:
    return _stage("integrity", *given)


def look(*given: Any) -> Any:
    return _stage("look", *given)


def verify(*given: Any) -> Any:
    return _stage("verify", *given)


def score(*given: Any) -> Any:
    return _stage("score", *given)


def main() -> None:
    """The command line with these stages; verifiers end after ``SECONDS``, workers at ``MEMORY_BYTES``."""
    from c4s.cli.main import main as command_line

    for function in (attempt, integrity, look, verify, score):
        setattr(stages, function.__name__, function)
    for name, limit in list(limits.LIMITS.items()):
        seconds = SECONDS if name == "verify" else limit.seconds
        limits.LIMITS[name] = Limit(limit.kind, seconds, limit.of_scene, MEMORY_BYTES)
    command_line()
