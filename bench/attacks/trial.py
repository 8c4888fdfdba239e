"""Tries the attacks: Python that runs inside an engine, as agent code does."""

from __future__ import annotations

import json
import re
import socket
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from bench.attacks.calls import CALLS
from bench.attacks.endings import ENDED
from bench.attacks.limits import LIMITS
from bench.attacks.names import GUESSING, NAMES
from bench.attacks.network import NETWORK
from bench.attacks.reading import READING
from bench.attacks.row import WALLS, Attack, AttackResult
from bench.attacks.writing import WRITING
from c4s.engine import EngineDied
from c4s.engine.confine.confinement import Backend, Limits
from c4s.engine.confine.sandbox import faults
from c4s.engine.headless.host.session import EngineSession
from c4s.records.pack import Pack

SECRET = "the withheld truth"
REFUSED: dict[str, Attack] = {
    attack.name: attack for theme in (READING, WRITING, NAMES, GUESSING, NETWORK, CALLS, LIMITS) for attack in theme
}
_SMALL = Limits(cpu_s=60, memory=700 << 20, threads=64, files=2000, disk=64 << 20, written=256 << 20)
_SCRIPT = """
import ctypes, fcntl, glob, json, multiprocessing, os, resource, socket, subprocess, sys, time, warnings
import numpy
import c4s
warnings.simplefilter("ignore")  # Python 3.12 warns of forks beside threads, in the same log
libc = ctypes.CDLL(None, use_errno=True)
class Nothing(Exception):
    pass
def fail(result):
    if result == -1: raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))
    return result
def call(number, *arguments):
    return fail(libc.syscall(number, *(ctypes.c_long(a) if isinstance(a, int) else a for a in arguments)))
def did(what):
    if not what: raise Nothing('it changed nothing')
    return what
def see(path):
    return os.listdir(path) if os.path.isdir(path) else open(path, 'rb').read(64)
for name, attack in ATTACKS.items():
    try:
        told = ["done", repr(eval(attack))[:80]]
    except BaseException as error:
        told = ["refused", f"{type(error).__name__}: {error}"]
    print(json.dumps([name, *told]))
"""
"""The names of an attack: ``TRUTH``, ``ROOT``, ``PACK``, ``HOST`` (process), ``LOGS``, ``CONTENT``, ``KERNELS``,
``BRIDGE`` (socket), ``PORT`` (a server of the host); ``call`` and ``fail``, which raise for an error of C; ``did``,
which raises where nothing has changed; ``see``, which reads or lists."""


def refused(backend: Backend, root: Path) -> Iterator[AttackResult]:
    """Try the attacks of ``REFUSED`` in one engine whose case lies under ``root``."""
    truth = root / "withheld" / "case" / "truth.level.json"
    truth.parent.mkdir(parents=True)
    truth.write_text(SECRET)
    (root / "notes.txt").write_text(SECRET)
    (root / "other" / "submission").mkdir(parents=True)
    (root / "other" / "trajectory.jsonl").write_text(SECRET)
    pack, scratch, content = root / "packs" / "empty", root / "agent" / "scratch", root / "agent" / "content"
    Pack(pack_id="empty", content_folder="Empty", title="Empty", license="Apache-2.0", assets=[]).write(
        pack / "pack.json"
    )
    with (
        socket.create_server(("127.0.0.1", 0)) as server,
        EngineSession.start(packs=[pack], content=content, scratch=scratch, use=backend) as engine,
    ):
        names = {
            "TRUTH": str(truth),
            "ROOT": str(root),
            "PACK": str(pack),
            "HOST": _host(engine),
            "LOGS": str(engine.logs),
            "CONTENT": str(content),
            "KERNELS": f"{scratch}/kernels/*/*/*.nb?",
            "BRIDGE": str(engine.bridge.address),
            "PORT": server.getsockname()[1],
            "ATTACKS": {name: attack.code for name, attack in REFUSED.items()},
        }
        reply = engine.execute("\n".join(f"{name} = {value!r}" for name, value in names.items()) + _SCRIPT, 120)
    for line in reply["result"]["python_logs"]:
        name, outcome, told = json.loads(line)
        attack = REFUSED[name]
        reason = attack.known.get(backend)
        stopped = outcome == "refused" and SECRET not in told and re.search(WALLS[attack.wall], told) is not None
        yield AttackResult(name, backend, reason or attack.wall, stopped, reason is not None, told)
    if reply["status"] != "ok":
        yield AttackResult("the script of attacks", backend, "", False, False, str(reply.get("error")))
    if truth.read_text() != SECRET or len(list(truth.parent.iterdir())) != 1:
        yield AttackResult("the withheld folder afterwards", backend, "", False, False, "changed")


def _host(engine: EngineSession) -> int:
    """The process that started the engine."""
    return int(Path(f"/proc/{engine.pid}/stat").read_text().rpartition(")")[2].split()[1])


def ended(attack: str, backend: Backend, root: Path) -> AttackResult:
    """Try an attack of ``ENDED`` in an engine of its own, with small limits."""
    script, reason = ENDED[attack]
    limits = _SMALL if script else replace(_SMALL, cpu_s=4)
    with EngineSession.start(
        packs=[], content=root / "content", scratch=root / "scratch", use=backend, limits=limits
    ) as engine:
        try:
            reply = engine.execute(f"{script}\nwhile True: pass", 60)
        except EngineDied as death:
            return AttackResult(attack, backend, reason, re.search(reason, death.what) is not None, False, death.what)
    return AttackResult(attack, backend, reason, False, False, str(reply.get("error") or reply["status"]))


def results() -> Iterator[AttackResult]:
    """Every attack in every sandbox of this machine."""
    for backend, fault in faults().items():
        if fault is not None:
            continue
        with tempfile.TemporaryDirectory(prefix="c4s-attacks-") as folder:
            yield from refused(backend, Path(folder) / "refused")
            for number, attack in enumerate(ENDED):
                yield ended(attack, backend, Path(folder) / str(number))
