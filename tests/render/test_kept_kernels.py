"""Machine code is made once for the sources, not once a home."""

from __future__ import annotations

from pathlib import Path

import pytest

from c4s.engine.headless.host.kernels import compiled
from tests.work import calls_in


def test_another_home_uses_what_is_compiled_beside_the_sources(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    found = []
    for home in ("first", "second"):
        monkeypatch.setenv("C4S_HOME", str(tmp_path / home))
        calls = calls_in(lambda: found.append(compiled()))
    assert found[0] == found[1] and calls["Popen.__init__"] == 0, "no process compiles"
    notes = [
        [note for note in (tmp_path / home / "cache/kernels").iterdir() if not note.suffix]
        for home in ("first", "second")
    ]
    assert [note.read_text() for (note,) in notes] == [notes[0][0].read_text()] * 2
