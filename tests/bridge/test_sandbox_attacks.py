"""What agent code may not do, tried for real in every sandbox that this machine has."""

from __future__ import annotations

from pathlib import Path

import pytest

from bench.attacks import trial as attacks
from bench.attacks.row import AttackResult
from c4s.engine.confine import sandbox
from c4s.engine.confine.confinement import Backend
from c4s.engine.headless.host.session import EngineSession
from c4s.errors import BadInput, MachineryFault


@pytest.fixture(
    scope="module",
    params=[
        pytest.param(name, marks=pytest.mark.skipif(fault is not None, reason=f"{name}: {fault}"))
        for name, fault in sandbox.faults().items()
    ],
)
def attacked(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> list[AttackResult]:
    """What became of the attacks that one engine survives."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("OPENAI_API_KEY", attacks.SECRET)
        return list(attacks.refused(request.param, tmp_path_factory.mktemp("attacked")))


def test_every_attack_is_refused(attacked: list[AttackResult]) -> None:
    assert {result.attack for result in attacked} == set(attacks.REFUSED)
    assert [result for result in attacked if not result.failed and not result.known] == []
    assert [result for result in attacked if result.failed and result.known] == [], "a wall that has come to hold"


@pytest.mark.parametrize("attack", attacks.ENDED)
def test_an_attack_that_exhausts_or_breaks_the_engine_ends_it(tmp_path: Path, attack: str) -> None:
    usable = [name for name, fault in sandbox.faults().items() if fault is None]
    backend = usable[list(attacks.ENDED).index(attack) % len(usable)]
    result = attacks.ended(attack, backend, tmp_path)
    assert result.failed, result


def test_the_file_system_outside_cannot_be_altered_in_any_way(tmp_path: Path, backend: Backend) -> None:
    outside = tmp_path / "outside.txt"
    outside.write_text("as it was")
    outside.chmod(0o640)
    before = outside.stat()
    with EngineSession.start(
        packs=[], content=tmp_path / "content", scratch=tmp_path / "scratch", use=backend
    ) as engine:
        reply = engine.execute(f"""
import os
for attack in ('os.chmod(P, 0o777)', 'os.utime(P, (1, 1))', 'os.chown(P, 1, 1)', 'os.unlink(P)', 'os.truncate(P, 0)',
               'os.rename(P, "stolen")', 'os.setxattr(P, "user.x", b"1")', 'open(P, "w")'):
    try: eval(attack, {{'os': os, 'P': {str(outside)!r}}})
    except OSError: pass
open('mine', 'w').write('kept'); os.chmod('mine', 0o600); os.rename('mine', 'renamed')
print(open('renamed').read())""")
    assert reply["result"]["python_logs"] == ["kept"]
    after = outside.stat()
    assert outside.read_text() == "as it was"
    assert (after.st_mode, after.st_mtime_ns, after.st_uid) == (before.st_mode, before.st_mtime_ns, before.st_uid)


def test_threads_and_numbers_work_inside(tmp_path: Path, backend: Backend) -> None:
    with EngineSession.start(
        packs=[], content=tmp_path / "content", scratch=tmp_path / "scratch", use=backend
    ) as engine:
        reply = engine.execute(
            "from concurrent.futures import ThreadPoolExecutor\nimport numpy as np, tempfile\n"
            "print(sum(ThreadPoolExecutor(8).map(lambda n: n * n, range(10))), np.eye(3).trace())\n"
            "with tempfile.TemporaryFile() as f: print(f.write(b'abc'))"
        )
    assert reply["result"]["python_logs"] == ["285 3.0", "3"]


def test_without_a_sandbox_nothing_starts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sandbox, "faults", lambda: {"bubblewrap": "not installed", "landlock": "no Landlock"})
    with pytest.raises(
        MachineryFault,
        match=r"bubblewrap: not installed; landlock: no Landlock \(install bubblewrap"
        r".*C4S_SANDBOX=none",
    ):
        EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s")
    assert not (tmp_path / "s.logs" / "engine.log").exists()


@pytest.mark.parametrize("name", ["bubblewrap", "landlock"])
def test_a_sandbox_is_chosen_and_its_lack_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.setattr(sandbox, "faults", lambda: {"bubblewrap": None, "landlock": None} | {name: "broken"})
    other = {"bubblewrap": "landlock", "landlock": "bubblewrap"}[name]
    assert sandbox.backend() == other
    monkeypatch.setenv("C4S_SANDBOX", other)
    assert sandbox.backend() == other
    monkeypatch.setenv("C4S_SANDBOX", name)
    with pytest.raises(MachineryFault, match=f"{name}: broken"):
        EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s")
    monkeypatch.setenv("C4S_SANDBOX", "wishful")
    with pytest.raises(BadInput, match="no sandbox is called 'wishful'"):
        sandbox.backend()


def test_the_risk_can_be_accepted_and_the_limits_stay(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sandbox, "faults", lambda: {"bubblewrap": "no", "landlock": "no"})
    monkeypatch.setenv("C4S_SANDBOX", "none")
    (tmp_path / "seen.txt").write_text("open")
    with EngineSession.start(packs=[], content=tmp_path / "c", scratch=tmp_path / "s") as engine:
        reply = engine.execute(f"print(open({str(tmp_path / 'seen.txt')!r}).read())")
        assert reply["result"]["python_logs"] == ["open"]
        assert engine.execute("bytearray(64 << 30)")["fault"] == "MemoryError"


def test_the_submission_cannot_be_changed_by_the_evaluator_engine(tmp_path: Path, backend: Backend) -> None:
    content = tmp_path / "content"
    content.mkdir()
    (content / "kept.json").write_text("{}")
    with EngineSession.start(
        packs=[], content=content, scratch=tmp_path / "s", use=backend, content_read_only=True
    ) as engine:
        reply = engine.execute(f"open({str(content / 'kept.json')!r}, 'w')")
    assert reply["status"] == "error" and [path.name for path in content.iterdir()] == ["kept.json"]
