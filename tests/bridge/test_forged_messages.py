"""What agent code writes on the engine's own channel, or how it ends the process: the host tells it at once."""

from __future__ import annotations

from pathlib import Path

import pytest

from c4s.engine.confine.confinement import Backend
from c4s.engine.faults import EngineDied
from c4s.engine.headless.host.session import EngineSession
from c4s.errors import Unforeseen

SEND = """
import os, stat, struct
for f in range(3, 256):
    try:
        if stat.S_ISSOCK(os.fstat(f).st_mode):
            break
    except OSError:
        pass
for job in range(1, 60):
    message = {}
    os.write(f, struct.pack("!Q", len(message)) + message)
"""
MESSAGES = {
    "a deep error": """b'{"job":%d,"error":' % job + b"[" * 1000 + b"]" * 1000 + b"}\\nnull\"""",
    "an error in numbers": """b'{"job":%d,"error":7}\\nnull' % job""",
    "a fault in lists": """b'{"job":%d,"error":"x","fault":[]}\\nnull' % job""",
    "a list": """b'[%d]\\nnull' % job""",
    "no JSON": """b'\\xff\\xfe%d' % job""",
    "a number of thousands of digits": """b'{"job":' + b"9" * 5000 + b"}\\n1\"""",
    "a long head": """b'{"job":%d,"error":"' % job + b"x" * (1 << 20) + b'"}\\nnull'""",
}
TIMER = """
import ctypes
libc, event, timer, spec = ctypes.CDLL(None), (ctypes.c_int * 16)(), ctypes.c_int(), (ctypes.c_long * 4)(0, 0, 0, 1)
event[2] = 40
libc.syscall(222, 1, event, ctypes.byref(timer))
libc.syscall(223, timer.value, 0, spec, 0)
while True:
    pass
"""
"""timer_create and timer_settime: a real-time signal, which has no name."""


def died(engine: EngineSession, script: str) -> str:
    """How the engine ended by a script, as it and the next call are told."""
    told = []
    for source in (script, "print('again')"):
        with pytest.raises(EngineDied) as caught:
            engine.execute(source, 30.0)
        told.append(caught.value.line())
    assert told[0] == told[1] and not engine.alive
    return told[0]


@pytest.mark.parametrize("name", MESSAGES)
def test_a_forged_message_ends_the_engine_at_once(tmp_path: Path, backend: Backend, name: str) -> None:
    with EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s", use=backend) as engine:
        assert "SIGKILL" in died(engine, SEND.format(MESSAGES[name]))


def test_what_the_host_did_not_foresee_is_told_as_its_own_fault(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s") as engine:

        def broken(*_: object) -> None:
            raise KeyError("unheard of")

        monkeypatch.setattr("c4s.engine.host.jobs._object", broken)
        for _ in range(2):
            with pytest.raises(Unforeseen, match="KeyError: 'unheard of'"):
                engine.execute("print(1)", 30.0)


def test_a_signal_without_a_name_is_told_by_its_number(tmp_path: Path) -> None:
    with EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s", use="landlock") as engine:
        assert "signal 40" in died(engine, TIMER)
