"""The stand-in's program: an editor from its first log line to its last, by the editor's own command line.

``standin.json`` in the installation's folder says what it does that an editor may do; see ``Behaviour``.
"""

from __future__ import annotations

import faulthandler
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from types import FrameType
from typing import Any, NoReturn

from c4s.engine.unreal.standin.install import BEHAVIOUR, ROOT, VERSION_TEXT
from c4s.engine.unreal.standin.log import EditorLog, streams

_TICK_S = 1 / 60
_PYTHON = "py "


@dataclass(frozen=True)
class Behaviour:
    """What this editor does beside its work."""

    start_s: float = 0.0
    """How long it takes until it runs its start script."""
    hang_at_start: bool = False
    crash_at_start: bool = False
    workers: int = 0
    """Children that compile shaders, and that do not end by themselves."""
    torn_saves: bool = False
    """It crashes while it saves a level, and leaves half of the package."""
    kernels: str = ""
    """The folder of compiled kernels for its pictures."""


class StandIn:
    """One run of the stand-in."""

    def __init__(self, arguments: Sequence[str], behaviour: Behaviour) -> None:
        options = dict(word.lstrip("-").partition("=")[::2] for word in arguments if word.startswith("-"))
        self.project = Path(next((word for word in arguments if not word.startswith("-")), ""))
        self.folder, self.behaviour = self.project.parent, behaviour
        default = self.folder / "Saved" / "Logs" / f"{self.project.stem}.log"
        self.commands = options.get("ExecCmds", "").split(",")
        self.log = EditorLog(Path(options.get("abslog") or default))
        self.quitting = False

    def run(self) -> None:
        """From the start to the end."""
        self.log.write("LogInit", f"Build: {VERSION_TEXT} (a stand-in: no part of this is Epic's)")
        self.log.write("LogInit", f"Command Line: {' '.join(sys.argv[1:])}")
        if not self.project.is_file():
            self.log.write("LogInit", f"Project file not found: {self.project}", "Error")
            sys.exit(1)
        plugins = {one["Name"] for one in json.loads(self.project.read_text())["Plugins"] if one["Enabled"]}
        if self.behaviour.hang_at_start:
            self.log.write("LogShaderCompilers", "Waiting for shaders that never come")
            while True:
                time.sleep(3600)
        for number in range(self.behaviour.workers):
            self.log.write("LogShaderCompilers", f"Started ShaderCompileWorker {number}")
            subprocess.Popen([sys.executable, "-c", "import time; time.sleep(3600)"], start_new_session=True)
        time.sleep(self.behaviour.start_s)
        if self.behaviour.crash_at_start:
            self.crash("Unhandled Exception: the GPU is gone")
        for number in (signal.SIGSEGV, signal.SIGABRT, signal.SIGFPE):
            signal.signal(number, self._signalled)
        tick = self._boot()
        self.log.write("LogInit", "Engine is initialized. Leaving FEngineLoop::Init()")
        for command in self.commands:
            if command.startswith(_PYTHON) and "PythonScriptPlugin" in plugins:
                self._script(Path(command.removeprefix(_PYTHON).strip().strip('"')))
            elif command:
                self.log.write("LogConsoleResponse", f"Command not recognized: {command}", "Warning")
        while not self.quitting:
            self.log.frame += 1
            started = time.monotonic()
            tick()
            time.sleep(max(0.0, _TICK_S - (time.monotonic() - started)))
        self.log.write("LogExit", "Exiting.")

    def _boot(self) -> Callable[[], None]:
        """Install ``unreal`` over the project's content; what to call each tick."""
        from c4s.engine.headless.editor import install
        from c4s.engine.headless.host.kernels import linked
        from c4s.engine.headless.unreal import build, libraries
        from c4s.engine.headless.unreal.asset_tools import editing
        from c4s.engine.headless.unreal.libraries import system
        from c4s.engine.unreal.standin.content import read_content
        from c4s.engine.unreal.standin.world import EditorWorld
        from c4s.packs.store import PackStore

        if self.behaviour.kernels:
            os.environ.update(linked(Path(self.behaviour.kernels), self.folder / "Intermediate"))
        packs = read_content(self.folder / "Content", self.folder / "Intermediate" / "Packs")
        world = EditorWorld(PackStore(packs), self.folder / "Content", _paint, self.log)
        world.scratch, world.crash, world.torn_saves = self.folder / "Saved", self.crash, self.behaviour.torn_saves
        install(world)
        module = build()
        del module.c4s_mesh_facts  # the headless engine's own; an editor has no such function
        for part in (system, editing):
            vars(part)["ENGINE_VERSION"] = VERSION_TEXT
        module.SystemLibrary.quit_editor = staticmethod(self._quit)
        sys.modules["unreal"] = module
        sys.stdout, sys.stderr = streams(self.log)
        self.log.write("LogPython", f"Using Python {sys.version.split()[0]}")

        def tick() -> None:
            world.in_tick = True
            try:
                libraries.tick(_TICK_S)
            except Exception as error:
                self.log.write("LogPython", f"{type(error).__name__}: {error}", "Error")
            finally:
                world.in_tick = False

        return tick

    def _script(self, file: Path) -> None:
        """Run a script as the console command ``py`` does: what it raises is in the log, and the editor goes on."""
        import traceback

        try:
            source = compile(file.read_text(encoding="utf-8"), str(file), "exec")
            exec(source, {"__name__": "__main__", "__file__": str(file)})
        except Exception:
            for line in traceback.format_exc().splitlines():
                self.log.write("LogPython", line, "Error")

    def _quit(self) -> None:
        self.quitting = True

    def _signalled(self, number: int, _: FrameType | None) -> None:
        self.crash(f"Unhandled Exception: {signal.Signals(number).name}", number)

    def crash(self, why: str, number: int = signal.SIGSEGV) -> NoReturn:
        """Leave a crash report and end as a process that was hurt."""
        folder = self.folder / "Saved" / "Crashes" / f"crashinfo-{self.project.stem}-pid-{os.getpid()}"
        folder.mkdir(parents=True, exist_ok=True)
        stack = "\n".join(f"libUnrealEditor-StandIn.so!Frame{depth}() [standin.cpp:{depth}]" for depth in range(3))
        (folder / "CrashContext.runtime-xml").write_text(
            f"<FGenericCrashContext><RuntimeProperties><ErrorMessage>{why}</ErrorMessage>"
            f"<EngineVersion>{VERSION_TEXT}</EngineVersion><CallStack>{stack}</CallStack>"
            "</RuntimeProperties></FGenericCrashContext>\n",
            encoding="utf-8",
        )
        self.log.write("LogCore", "=== Critical error: ===", "Error")
        self.log.write("LogCore", why, "Error")
        faulthandler.disable()
        signal.signal(number, signal.SIG_DFL)
        os.kill(os.getpid(), number)
        os._exit(1)


def _paint(cameras: Sequence[Mapping[str, Any]], files: Sequence[str], mode: str, masks: bool) -> list[dict[str, Any]]:
    from c4s.engine.headless.pictures.take import take

    return take(cameras, files, mode, masks)


def main() -> None:
    """Entry point."""
    told = json.loads((Path(os.environ[ROOT]) / BEHAVIOUR).read_text(encoding="utf-8"))
    known = {field.name for field in fields(Behaviour)}
    StandIn(sys.argv[1:], Behaviour(**{name: value for name, value in told.items() if name in known})).run()
    sys.stdout.flush()
    os._exit(0)
