"""One script in an engine of its own, under the limits of an agent's script: what it printed and what it changed."""

from __future__ import annotations

import re
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from c4s.bounds import BOUNDS
from c4s.cli.changed import changes
from c4s.cli.levels import ScriptGround, held_paths
from c4s.engine import Engine, EngineCallError, EngineDied, backend, open_engine
from c4s.engine.answers import ask, ask_picture
from c4s.engine.bridge import FAILED, BridgeFault
from c4s.engine.content import content_fault
from c4s.errors import BadInput, C4SError
from c4s.files import read_plain_text, write_bytes
from c4s.packs.store import object_path
from c4s.records.level import Level
from c4s.toolbox.pictures import read_picture
from c4s.toolbox.refusal import ToolRefused
from c4s.toolbox.workbench import JobLimits

STDIN = Path("-")
SAVED_SCENES, SUFFIX, PICTURE = "/Game/SavedScenes", ".level.json", "picture.png"
PLAIN_NAME = re.compile(r"[A-Za-z0-9_-]{1,100}")
WIDTH, HEIGHT = 1280, 720
Status = Literal["ok", "error", "running", "died"]


@dataclass
class Ran:
    """What came of a script."""

    status: Status
    """``running``: it was given up on after the limit of a job; ``died``: it ended the engine, or made it unusable."""
    output: list[str]
    error: str = ""
    level: str = ""
    """Package of the level that is open at the end."""
    found: dict[str, Any] = field(default_factory=dict)
    """``c4s.cli.changed.changes`` of that level; empty where nothing can be asked any more."""
    saved: Path | None = None
    left_out: list[str] = field(default_factory=list)
    """Assets that the saved level names and that are in no pack: the script made them, and they are not kept."""
    picture: Path | None = None

    def fail(self, status: Status, error: str) -> None:
        """Note what went wrong; what was noted first is what counts."""
        if self.status == "ok":
            self.status, self.error = status, error


def read_script(file: Path) -> str:
    """The source, from a file or from standard input (``-``); ``BadInput`` for what is no text of a bearable size."""
    if file != STDIN:
        return read_plain_text(file, "script")
    bound = BOUNDS["document_bytes"]
    data = sys.stdin.buffer.read(bound.most + 1)
    bound.hold(len(data), where="standard input")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise BadInput("the script is no text in UTF-8", where="standard input") from error


def save_package(file: Path) -> str:
    """The package that a level is saved as, by its file's name; ``BadInput`` for a name that no level can have."""
    name = file.name.removesuffix(SUFFIX)
    if name == file.name or not PLAIN_NAME.fullmatch(name):
        raise BadInput("no name for a level", where=str(file), todo=f"letters, digits, _ and -, then {SUFFIX}")
    return f"{SAVED_SCENES}/{name}"


def run_script(script: str, ground: ScriptGround, *, engine: str, save: Path | None, picture: Path | None) -> Ran:
    """Run a script as an agent's is run: same confinement, same limits. What it does wrong is in the answer."""
    with tempfile.TemporaryDirectory(prefix="c4s-python-") as folder:
        content, scratch = Path(folder, "Project", "Content"), Path(folder, "Project", "Saved")
        levels = [ground.level] if ground.level is not None else []
        with open_engine(
            engine, packs=ground.packs, content=content, scratch=scratch, levels=levels, start_map=ground.package
        ) as session:
            before = ask(session, "snapshot.export_snapshot")
            camera = session.call("capture.viewport_camera")
            ran = Ran("ok", [])
            try:
                _execute(session, script, ran)
                after = ask(session, "snapshot.export_snapshot")
                ran.level, ran.found = after["map_path"], changes(before, after)
                if picture is not None:
                    write_bytes(picture, _picture(session, scratch, camera))
                    ran.picture = picture
                if save is not None:
                    _save(session, content, save)
                    ran.saved = save
            except EngineDied as error:
                ran.output += error.lines
                ran.fail("died", error.line())
            except (BridgeFault, EngineCallError, ToolRefused, _Unsaved) as error:
                ran.fail("error", error.line())
        if ran.saved is not None:
            known = {path for pack in ground.packs for path in held_paths(pack)}
            named = backend(engine).asset_paths(ran.saved)
            ran.left_out = [path for path in named if path.startswith("/Game/") and object_path(path) not in known]
    return ran


class _Unsaved(C4SError):
    """The script left no level that can be kept."""


def _execute(session: Engine, script: str, ran: Ran) -> None:
    reply = session.execute(script, JobLimits.script_s)
    ran.output += reply.get("result", {}).get("python_logs", [])
    if reply["status"] == "running":
        ran.fail("running", f"it ran for more than {JobLimits.script_s:.0f} s and was given up on")
    elif reply["status"] in FAILED:
        ran.fail("error", str(reply.get("error")))


def _picture(session: Engine, scratch: Path, camera: Any) -> bytes:
    """What the viewport shows; where the script left its camera alone, the whole level."""
    if session.call("capture.viewport_camera") == camera:
        session.call("capture.frame_level")
    reply = ask_picture(session, {"filepath": PICTURE, "width": WIDTH, "height": HEIGHT}, timeout_s=JobLimits.script_s)
    if reply.status in FAILED:
        raise ToolRefused(f"no picture was taken: {reply.error or reply.missing}")
    return read_picture(Path(reply.filepath), scratch)


def _save(session: Engine, content: Path, save: Path) -> None:
    package = save_package(save)
    if ask(session, "scene_tools.save_scene", package=package)["package"] != package:
        raise _Unsaved("the level was saved as another package than the one that was asked for")
    fault = content_fault(content)
    if fault is not None:
        raise _Unsaved(f"the saved level cannot be read: {fault}")
    try:
        level = Level.read(content / f"{package[1:]}{SUFFIX}")
    except BadInput as error:
        raise _Unsaved(f"the saved level cannot be read: {error.what}") from error
    level.write(save)
