"""The faults that ``bench.faults`` does: each a name, whether the run is done before it, and what it does."""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from bench.waiting import until
from c4s.errors import C4SError
from c4s.folders import remove_tree
from c4s.protocol.rules import GATE
from c4s.records.folder import RunFolder, TrialFolder
from c4s.records.suite import SuiteFolder

CASE = "indoor-flat-01-mirrored-bath"
AGENT = "noop"
COMMAND = ("run", "small", "-a", AGENT, "-c", CASE)
FLOW = (
    "import asyncio; from flows.evaluate import evaluate; "
    f"asyncio.run(evaluate('small', [{AGENT!r}], cases=[{CASE!r}]))"
)
LIMIT_S = 900.0
_AWAY = re.compile(r"move (\S+) away")


@dataclass
class Scene:
    """A home, its temporary folder, and the commands that run in it."""

    home: Path
    temporary: Path
    settings: dict[str, str]
    mark: str
    kept: dict[Path, bytes] = field(default_factory=dict)
    """Files that the operator can restore."""
    undo: list[Callable[[], object]] = field(default_factory=list)

    @property
    def folder(self) -> RunFolder:
        """The run."""
        return RunFolder(self.home / "runs/small")

    @property
    def trial(self) -> TrialFolder:
        """The only trial."""
        return self.folder.trial(AGENT, SuiteFolder(self.home / "suites/small").case(CASE).alias, 1)

    def start(self, *command: str) -> subprocess.Popen[str]:
        """Start the command (or a program of one's own) and do not wait."""
        given = command or (sys.executable, "-m", "c4s.cli", *COMMAND)
        pipe = subprocess.PIPE
        return subprocess.Popen(
            given, env=self.settings, text=True, stdout=subprocess.DEVNULL, stderr=pipe, start_new_session=True
        )

    def run(self) -> subprocess.CompletedProcess[str]:
        """The command, to its end."""
        process = self.start()
        _, told = process.communicate(timeout=LIMIT_S)
        return subprocess.CompletedProcess(process.args, process.returncode, "", told)

    def obey(self, told: str) -> None:
        """Do what a refusal asks for: restore the file, or move the trial away; and take away what the fault is."""
        for path, data in self.kept.items():
            path.write_bytes(data)
        self.kept.clear()
        self.close()
        if away := _AWAY.search(told):
            Path(away[1]).rename(self.home / "away")

    def close(self) -> None:
        """Take away what the fault is, where it lasts."""
        while self.undo:
            self.undo.pop()()


@dataclass(frozen=True)
class Fault:
    """``do`` does the fault; before a run is done it starts the run itself, and returns how that ended."""

    name: str
    after: bool
    do: Callable[[Scene], object]


Moment = Callable[[Scene], Path]
MOMENTS: dict[str, Moment] = {
    "the lease": lambda scene: scene.folder.leases / "000001.json",
    "the plan": lambda scene: scene.folder.plan,
    "the attempt's folder": lambda scene: scene.trial.attempt(1).root,
    "the attempt's engine": lambda scene: scene.trial.attempt(1).manifest,
    "the first call": lambda scene: scene.trial.attempt(1).trajectory,
    "the saved scene": lambda scene: scene.trial.attempt(1).saves,
    "the outcome": lambda scene: scene.trial.attempt(1).outcome,
    "the snapshot": lambda scene: scene.trial.evidence.snapshot,
    "the gate's verdict": lambda scene: scene.trial.attempt(1).integrity,
    "the pictures": lambda scene: scene.trial.evidence.captures_index,
    "the contacts": lambda scene: scene.trial.evidence.contacts,
    "the score": lambda scene: scene.trial.score,
    "the rows": lambda scene: scene.home / "warehouse/outcomes",
}


def below(process: int) -> dict[int, str]:
    """The processes below one, with their command lines, parents first."""
    found: dict[int, str] = {}
    waiting = [process]
    for parent in waiting:
        with suppress(OSError):
            for task in Path(f"/proc/{parent}/task").iterdir():
                for child in map(int, (task / "children").read_text().split()):
                    found[child] = Path(f"/proc/{child}/cmdline").read_bytes().replace(b"\0", b" ").decode()
                    waiting.append(child)
    return found


def wait_for(process: subprocess.Popen[str], path: Path) -> bool:
    """Wait until a file is there, or the run has ended."""
    until(lambda: process.poll() is not None or path.exists())
    return process.poll() is None


def _ended(process: subprocess.Popen[str]) -> int:
    process.communicate(timeout=LIMIT_S)
    return process.returncode


def _kill(process: subprocess.Popen[str], who: str) -> None:
    """Kill the driver, or the processes below it whose command line holds a word."""
    chosen = [process.pid] if who == "driver" else [p for p, line in below(process.pid).items() if WHO[who] in line]
    for one in chosen:
        with suppress(ProcessLookupError):
            os.kill(one, signal.SIGKILL)


WHO = {"workers": "c4s.run.template", "engine": "c4s.engine", "Prefect server": "uvicorn"}


def _killed(who: str, moment: str, *program: str) -> Fault:
    def do(scene: Scene) -> int:
        process = scene.start(*program)
        if wait_for(process, MOMENTS[moment](scene)):
            _kill(process, who)
        return _ended(process)

    driver = "flow" if program and who == "driver" else who
    return Fault(f"kill -9 of the {driver} at {moment}", False, do)


def _signalled(name: str, *signals: signal.Signals) -> Fault:
    def do(scene: Scene) -> int:
        process = scene.start()
        if wait_for(process, scene.trial.attempt(1).manifest):
            for one in signals:
                with suppress(ProcessLookupError):
                    os.killpg(process.pid, one)
        return _ended(process)

    return Fault(name, False, do)


def _while_running(name: str, moment: str, act: Callable[[Scene], object]) -> Fault:
    def do(scene: Scene) -> int:
        process = scene.start()
        if wait_for(process, MOMENTS[moment](scene)):
            act(scene)
        return _ended(process)

    return Fault(name, False, do)


def _two_operators(scene: Scene) -> int:
    first = scene.start()
    wait_for(first, scene.trial.attempt(1).root)
    second = scene.run()
    if second.returncode != 2 or second.stderr.count("\n") != 1:
        raise C4SError("the second operator was not told in one line", where=second.stderr)
    return _ended(first)


def _remove(place: Path) -> None:
    remove_tree(place, inside=place.parent) if place.is_dir() else place.unlink()


def _truncate(path: Path) -> None:
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])


def _garble(path: Path) -> None:
    path.write_bytes(b"\x00\xffgarbage" * 9)


def _edit(path: Path) -> None:
    data = path.read_bytes()
    digit = next(place for place in reversed(range(len(data))) if data[place : place + 1].isdigit())
    path.write_bytes(data[:digit] + bytes([data[digit] ^ 1]) + data[digit + 1 :])


def _full_disk(scene: Scene) -> int:
    """The runs lie on a disk of their own, which is full from the first call until the run has paused."""
    disk = scene.home / "runs"
    disk.mkdir()
    mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=400m", "c4s-fault", disk], check=False)
    if mounted.returncode:
        raise C4SError("nothing can be mounted here", todo="run as root")
    process = scene.start()
    if wait_for(process, scene.trial.attempt(1).manifest):
        _fill(disk)
    until(lambda: process.poll() is not None or not any(WHO["engine"] in line for line in below(process.pid).values()))
    (disk / "filler").unlink()
    code = _ended(process)
    kept = scene.home / "kept"
    shutil.copytree(disk, kept)
    subprocess.run(["umount", disk], check=True)
    kept.rename(disk)
    return code


def _fill(disk: Path) -> None:
    with (disk / "filler").open("wb", buffering=0) as out, suppress(OSError):
        while True:
            out.write(bytes(4096))


def _few_descriptors(scene: Scene) -> int:
    """The command under the usual soft limit, with a lower one than it needs to work in peace."""
    script = 'ulimit -S -n 64; exec "$0" "$@"'
    return _ended(scene.start("sh", "-c", script, sys.executable, "-m", "c4s.cli", *COMMAND))


def _read_only(scene: Scene) -> None:
    subprocess.run(["mount", "--bind", scene.home, scene.home], check=True)
    subprocess.run(["mount", "-o", "remount,bind,ro", scene.home], check=True)
    scene.undo.append(lambda: subprocess.run(["umount", scene.home], check=True))


def _lock_database(scene: Scene) -> None:
    code = "import duckdb, sys; held = duckdb.connect(sys.argv[1]); print(1, flush=True); sys.stdin.read()"
    place = scene.home / "warehouse/c4s.duckdb"
    process = subprocess.Popen([sys.executable, "-c", code, place], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    assert process.stdout and process.stdin
    process.stdout.readline()
    scene.undo.append(lambda: (process.stdin and process.stdin.close(), process.wait()))


def _parts(scene: Scene, table: str) -> list[Path]:
    return sorted((scene.home / "warehouse" / table).rglob("*.parquet"))


Place = Callable[[Scene], Path]
FILES: dict[str, Place] = {
    "outcome": lambda scene: scene.trial.attempt(1).outcome,
    "gate of the attempt": lambda scene: scene.trial.attempt(1).integrity,
    "gate's verdict": lambda scene: scene.trial.verdict(GATE),
    "verdict": lambda scene: max(scene.trial.verdicts.values()),
    "score": lambda scene: scene.trial.score,
    "times": lambda scene: scene.trial.stages,
    "snapshot": lambda scene: scene.trial.evidence.snapshot,
    "picture": lambda scene: min(scene.trial.evidence.captures.glob("*.png")),
    "list of digests": lambda scene: min(scene.trial.evidence.listings()),
    "lease": lambda scene: max(scene.folder.leases.glob("*.json")),
    "outcome rows": lambda scene: _parts(scene, "outcomes")[0],
    "verdict rows": lambda scene: _parts(scene, "verdicts")[0],
    "database": lambda scene: scene.home / "warehouse/c4s.duckdb",
}
BEFORE_SCORE = ("times", "snapshot", "picture", "list of digests")
"""Read only for a trial without a score, so that goes too."""
FOLDERS: dict[str, Place] = {
    "attempt": lambda scene: scene.trial.attempt(1).root,
    "evidence": lambda scene: scene.trial.evidence.root,
    "verdicts": lambda scene: scene.trial.verdict(GATE).parent,
    "trial": lambda scene: scene.trial.root,
    "run": lambda scene: scene.folder.root,
    "warehouse": lambda scene: scene.home / "warehouse",
    "pages": lambda scene: scene.home / "site",
}
KEPT: dict[str, Place] = {
    "plan": lambda scene: scene.folder.plan,
    "trajectory": lambda scene: scene.trial.attempt(1).trajectory,
    "list of saves": lambda scene: scene.trial.attempt(1).saves,
    "edited outcome": lambda scene: scene.trial.attempt(1).outcome,
}


def _spoilt(how: str, act: Callable[[Path], None], what: str) -> Fault:
    def do(scene: Scene) -> None:
        act(FILES[what](scene))
        if what in BEFORE_SCORE:
            scene.trial.score.unlink()

    return Fault(f"{how} {what}", True, do)


def _removed(what: str) -> Fault:
    def do(scene: Scene) -> None:
        _remove(FOLDERS[what](scene))
        if what == "evidence":
            scene.trial.score.unlink()

    return Fault(f"removed {what}", True, do)


def _refused(what: str, *, restore: bool) -> Fault:
    """What can not be made again: the operator restores the file, or moves the trial away as the line says."""

    def do(scene: Scene) -> None:
        path = KEPT[what](scene)
        if restore:
            scene.kept[path] = path.read_bytes()
        (_edit if what == "edited outcome" else _garble)(path)
        if what not in ("plan", "edited outcome"):
            scene.trial.score.unlink()

    return Fault(f"garbled {what}, {'restored' if restore else 'moved away'} as told", True, do)


def _all() -> Iterator[Fault]:
    yield from (_killed("driver", moment) for moment in MOMENTS)
    yield from (
        _killed("workers", moment)
        for moment in ("the attempt's folder", "the attempt's engine", "the outcome", "the gate's verdict", "the score")
    )
    yield from (_killed("engine", moment) for moment in ("the attempt's engine", "the outcome", "the gate's verdict"))
    yield _killed("driver", "the attempt's engine", sys.executable, "-c", FLOW)
    yield _killed("Prefect server", "the attempt's engine", sys.executable, "-c", FLOW)
    yield _signalled("SIGTERM", signal.SIGTERM)
    yield _signalled("SIGINT", signal.SIGINT)
    yield _signalled("SIGINT twice", signal.SIGINT, signal.SIGINT)
    yield _signalled("SIGHUP", signal.SIGHUP)
    yield Fault("two operators", False, _two_operators)
    yield _while_running("lease removed while it is held", "the attempt's engine", lambda s: _remove(s.folder.leases))
    yield _while_running("trial removed while it runs", "the outcome", lambda s: _remove(s.trial.root))
    yield Fault("full disk", False, _full_disk)
    yield Fault("64 descriptors", False, _few_descriptors)
    yield Fault("read-only home", True, _read_only)
    yield Fault("database locked", True, _lock_database)
    for how, act in (("truncated", _truncate), ("garbled", _garble)):
        yield from (_spoilt(how, act, what) for what in FILES if (how, what) != ("garbled", "lease"))
    yield from (_spoilt("edited", _edit, what) for what in ("score", "verdict", "gate of the attempt"))
    yield from (_removed(what) for what in FOLDERS)
    yield from (_refused(what, restore=True) for what in KEPT)
    yield from (_refused(what, restore=False) for what in KEPT if what != "plan")


FAULTS = list(_all())
