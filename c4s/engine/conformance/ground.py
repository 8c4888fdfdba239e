"""Where checks run: an engine on an empty level, opened again when a check has ended it."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from c4s.engine.base import Engine, open_engine
from c4s.engine.bridge import FAILED
from c4s.errors import MachineryFault

PACKAGE = "/Game/C4SConformance/Yard"
"""Where checks save."""
_MARK = "C4S-FACTS "
_PRELUDE = '''\
import json
import unreal

FACTS = {}
actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
levels = unreal.get_editor_subsystem(unreal.LevelEditorSubsystem)
editor = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem)


def plain(value):
    if isinstance(value, unreal.Vector):
        return [value.x, value.y, value.z]
    if isinstance(value, unreal.Rotator):
        return [value.roll, value.pitch, value.yaw]
    if isinstance(value, (unreal.Name, unreal.Text)):
        return str(value)
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    return [plain(item) for item in value]


def fact(name, value):
    FACTS[name] = plain(value)


def raised(function, *args, **kwargs):
    """Name of the exception that a call raises, or None."""
    try:
        function(*args, **kwargs)
    except Exception as error:
        return type(error).__name__
    return None


def place(shape="Cube", x=0.0, y=0.0, z=0.0):
    asset = unreal.EditorAssetLibrary.load_asset("/Engine/BasicShapes/" + shape)
    return actors.spawn_actor_from_object(asset, unreal.Vector(x, y, z))


def clear():
    for actor in actors.get_all_level_actors():
        actors.destroy_actor(actor)


'''
_END = f'\nprint("{_MARK}" + json.dumps(FACTS))\n'


class Ground:
    """The engine that the checks use, and the folders that it was given."""

    def __init__(self, kind: str, folder: Path) -> None:
        self.kind, self.folder = kind, folder
        self.content, self.scratch = folder / "content", folder / "scratch"
        self._engine: Engine | None = None
        self._opened = 0

    @property
    def engine(self) -> Engine:
        """An engine that lives."""
        if self._engine is None or not self._engine.alive:
            self.close()
            self._engine = self.another(self.content)
        return self._engine

    def another(self, content: Path, **options: Any) -> Engine:
        """One more engine; ``options`` are those of ``open_engine``."""
        self._opened += 1
        scratch = self.folder / f"scratch-{self._opened}"
        if content == self.content:
            self.scratch = scratch
        return open_engine(self.kind, packs=[], content=content, scratch=scratch, **options)

    def close(self) -> None:
        """End the engine."""
        if self._engine is not None:
            self._engine.close()
            self._engine = None

    def facts(self, script: str, *, clear: bool = True) -> dict[str, Any]:
        """Run a script of a check on a level without actors: what it said with ``fact(name, value)``.

        ``MachineryFault`` with the end of its traceback when it failed.
        """
        whole = _PRELUDE + ("clear()\n" if clear else "") + script + _END
        return facts_of(self.engine.execute(whole))


def facts_of(reply: Mapping[str, Any]) -> dict[str, Any]:
    """The facts that a script printed."""
    if reply["status"] in FAILED:
        raise MachineryFault(f"the script failed: {str(reply.get('error')).rstrip().rpartition(chr(10))[2]}")
    told = [line.removeprefix(_MARK) for line in reply["result"]["python_logs"] if line.startswith(_MARK)]
    if not told:
        raise MachineryFault(f"the script ended with status {reply['status']} and without its facts")
    found: dict[str, Any] = json.loads(told[-1])
    return found
