"""What the ``unreal`` module and the queries ask of the engine's state, and the one state of this process.

``world.World`` is that state. It is built from the types of the ``unreal`` module, which speak to it through this
protocol; actors, assets and the map are therefore ``Any`` here. The module speaks of "the" editor, so there is one
state at a time.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol

from c4s.engine.headless.log import EngineLog
from c4s.engine.headless.pose import Pose
from c4s.errors import MachineryFault
from c4s.packs.store import PackStore


class Editor(Protocol):
    """The open level, the assets by path, and the editor around them."""

    log: EngineLog
    store: PackStore
    content: Path
    """Where ``/Game`` is saved."""
    scratch: Path
    """The project's ``Saved`` folder."""
    camera: Pose
    """Viewport camera."""
    selection: list[Any]
    transactions: list[str]
    """Descriptions of the open transactions, the outermost first."""
    dirty: bool
    package: str
    """Package of the open level."""
    map: Any
    actors: dict[str, Any]
    """Actors of the open level by object name."""
    created: dict[str, Any]
    """Assets made in this session, and saved ones that were loaded, by object path."""
    folders: set[str]
    """Folders that scripts made."""

    # the open level

    def map_path(self) -> str:
        """Object path of the open map."""
        ...

    def touch(self) -> None:
        """Note that the level has unsaved edits."""
        ...

    def close(self) -> None:
        """Drop the open level; its objects are dead from now on."""
        ...

    def new_map(self, package: str = ...) -> Any:
        """Open an empty level."""
        ...

    def level_file(self, package: str) -> Path | None:
        """Document of a level."""
        ...

    def load_map(self, package: str) -> Any:
        """Open a level; None when there is none."""
        ...

    def copy_map(self, package: str) -> Any:
        """Open an untitled copy of a level; None when there is none."""
        ...

    def save_map(self, package: str) -> bool:
        """Save the open level under a package name."""
        ...

    def references(self) -> list[str]:
        """Object paths that the open level names."""
        ...

    # actors

    def native_class(self, path: str) -> type[Any] | None:
        """The type behind ``/Script/Module.Name``, or None."""
        ...

    def actor_list(self) -> list[Any]:
        """All actors in level order."""
        ...

    def spawn(self, class_path: str, pose: Pose, label: str | None = None) -> Any:
        """Spawn an actor of a class."""
        ...

    def duplicate(self, actor: Any, offset: tuple[float, float, float]) -> Any:
        """Copy an actor."""
        ...

    def destroy(self, actor: Any) -> bool:
        """Take an actor out of the level."""
        ...

    def rename(self, actor: Any, name: str) -> bool:
        """Give an actor another object name."""
        ...

    def relabel(self, actor: Any, label: str) -> None:
        """Give an actor another label."""
        ...

    # assets

    def content_file(self, package: str, suffix: str) -> Path | None:
        """File of a package under the writable content root."""
        ...

    def package_file(self, package: str, kind: str | None = None) -> Path | None:
        """The file that holds a package, of a ``level`` or an ``asset`` only where that is told."""
        ...

    def find(self, path: str) -> Any:
        """The asset or Blueprint class of a path, or None."""
        ...

    def exists(self, path: str) -> bool:
        """Whether there is an asset."""
        ...

    def assets(self) -> list[Any]:
        """All assets."""
        ...

    def create(self, made: Any) -> None:
        """Take in a new asset."""
        ...

    def save(self, asset: Any) -> bool:
        """Save an asset."""
        ...

    def delete(self, path: str) -> bool:
        """Delete an asset."""
        ...

    def move(self, asset: Any, target: str) -> bool:
        """Give an asset another path."""
        ...

    def replace_asset(self, old: Any, new: Any) -> None:
        """Let whatever uses an asset use another one, or none."""
        ...

    def disk_references(self, package: str) -> list[str] | None:
        """Packages that a saved package names; None when there is no such package."""
        ...

    # pictures

    def take_pictures(
        self, cameras: Sequence[Mapping[str, Any]], files: Sequence[str], mode: str, masks: bool
    ) -> list[dict[str, Any]]:
        """Render the open level into PNG files."""
        ...


_current: Editor | None = None


def install(state: Editor) -> None:
    """Make ``state`` the current one; objects of an earlier one are dead."""
    global _current
    if _current is not None:
        _current.close()
    _current = state


def world() -> Editor:
    """The current state; ``MachineryFault`` before ``boot``."""
    if _current is None:
        raise MachineryFault(
            "the headless engine has not been booted", todo="call c4s.engine.headless.process.boot.boot"
        )
    return _current
