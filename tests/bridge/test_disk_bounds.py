"""What an engine may take of the disk, in every sandbox: no way of writing gets around the bound or outlives it."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from c4s.engine import EngineDied
from c4s.engine.confine import leftovers
from c4s.engine.confine.confinement import Backend, Limits
from c4s.engine.confine.sandbox import faults
from c4s.engine.confine.watch import overfull
from c4s.engine.headless.host.session import EngineSession
from c4s.engine.host import jobs

SMALL = Limits(disk=48 << 20, files=500, file_size=64 << 20, written=256 << 20)
MIB = "bytes(1 << 20)"
OVER = {
    "opened and unlinked": f"""
held = []
for n in range(5):
    held.append(open(f'h{{n}}', 'wb')); os.unlink(f'h{{n}}')
    for _ in range(16): held[-1].write({MIB})
    held[-1].flush()""",
    "mapped, unlinked and closed": f"""
libc = ctypes.CDLL(None, use_errno=True)
libc.mmap.restype = ctypes.c_void_p
for n in range(5):
    with open(f'h{{n}}', 'w+b') as file:
        for _ in range(16): file.write({MIB})
        file.flush(); os.unlink(f'h{{n}}')
        assert libc.mmap(None, ctypes.c_size_t(4096), 1, 2, file.fileno(), ctypes.c_long(0)) != 2**64 - 1""",
    "written through a map of a sparse file": """
file = open('sparse', 'w+b'); file.truncate(60 << 20)
held = mmap.mmap(file.fileno(), 60 << 20)
for at in range(0, 60 << 20, 4096): held[at] = 1""",
    "half in the content, half in scratch": f"""
for folder in (CONTENT, '.'):
    with open(os.path.join(folder, 'big'), 'wb') as file:
        for _ in range(30): file.write({MIB})""",
    "empty files in both": """
for n in range(600): open(os.path.join((CONTENT, '.')[n % 2], f'f{n}'), 'w').close()""",
    "written, given away and written again": f"""
while True:
    with open('again', 'wb') as file:
        for _ in range(32): file.write({MIB})
        file.flush(); os.fsync(file.fileno())
    os.unlink('again')""",
}


def session_in(tmp_path: Path, backend: Backend, limits: Limits = SMALL) -> EngineSession:
    return EngineSession.start(
        packs=[], content=tmp_path / "content", scratch=tmp_path / "scratch", use=backend, limits=limits
    )


def script(tmp_path: Path, text: str) -> str:
    return f"import ctypes, mmap, os\nCONTENT = {str(tmp_path / 'content')!r}\n{text}\nwhile True: pass"


@pytest.mark.parametrize("how", OVER)
def test_more_of_the_disk_than_the_bound_ends_the_engine(tmp_path: Path, how: str) -> None:
    usable = [name for name, fault in faults().items() if fault is None]
    backend = usable[list(OVER).index(how) % len(usable)]
    with (
        session_in(tmp_path, backend) as session,
        pytest.raises(EngineDied, match=r"files take|wrote more than|in all"),
    ):
        session.execute(script(tmp_path, OVER[how]), 60)


def test_space_is_not_reserved_at_once(tmp_path: Path, backend: Backend) -> None:
    with session_in(tmp_path, backend, Limits()) as session:
        reply = session.execute("""
import ctypes, fcntl, os, struct
libc = ctypes.CDLL(None, use_errno=True)
handle = os.open('reserved', os.O_RDWR | os.O_CREAT)
for mode in (0, 1, 0x10, 0x11):
    print(libc.fallocate(handle, mode, ctypes.c_long(0), ctypes.c_long(12 << 30)), ctypes.get_errno())
for call in (0x40305828, 0x4030582A, 0x40305839):
    try: fcntl.ioctl(handle, call, struct.pack('hhqqiI4q', 0, 0, 0, 12 << 30, 0, 0, 0, 0, 0, 0))
    except OSError as error: print('refused', error.errno)
print(os.fstat(handle).st_blocks)
""")
    assert reply["result"]["python_logs"] == ["-1 95"] * 4 + ["refused 1"] * 3 + ["0"]


def test_what_is_left_in_scratch_is_bounded_and_what_went_is_told(
    tmp_path: Path, backend: Backend, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(leftovers, "KEPT", Limits(files=100))
    with session_in(tmp_path, backend) as session:
        content = str(tmp_path / "content")
        session.execute(
            f"import os\nfor n in range(101): open(f'f{{n}}', 'w').close()\nopen({content!r} + '/kept', 'w')"
        )
    assert list((tmp_path / "scratch").iterdir()) == []
    assert (tmp_path / "content" / "kept").exists()
    told = json.loads((tmp_path / "scratch.logs" / "trimmed.json").read_text())
    assert told == {"why": "it wrote more than 100 files", "removed": "everything"}


def test_no_depth_is_too_deep_to_be_removed_or_to_be_seen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    left, outside = tmp_path / "left", tmp_path / "outside"
    outside.mkdir()
    left.mkdir()
    (outside / "file").touch()
    (left / "link").symlink_to(outside)
    monkeypatch.chdir(left)
    for _ in range(300):
        Path("deep" * 10).mkdir()
        os.chdir("deep" * 10)
    Path("deepest").touch()
    Path("link").symlink_to(outside)
    os.chdir(tmp_path)
    assert overfull([left], Limits()) == "its files cannot be looked at: File name too long"
    leftovers.trim(left, tmp_path / "note.json")
    assert list(left.iterdir()) == [] and (outside / "file").exists()


def test_what_keeps_the_bound_is_left_in_scratch(tmp_path: Path, backend: Backend) -> None:
    with session_in(tmp_path, backend) as session:
        session.execute("open('mine', 'w').write('kept')")
    assert (tmp_path / "scratch" / "mine").read_text() == "kept"
    assert not (tmp_path / "scratch.logs" / "trimmed.json").exists()


def test_what_all_jobs_print_together_is_bounded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(jobs, "MAX_PRINTED_BYTES", 20 << 20)
    with (
        EngineSession.start(packs=[], content=tmp_path / "content", scratch=tmp_path / "scratch") as session,
        pytest.raises(EngineDied, match="printed more than 20 MiB in all"),
    ):
        for _ in range(5):
            assert session.execute("import os\nfor _ in range(80): os.write(1, b'x' * 65536)")["status"] == "ok"
