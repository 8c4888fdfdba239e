"""The seam to an engine: what host-side code may use of one, and the one place that opens one.

A backend is a package beside this file whose face has what ``Backend`` asks for. It is imported when it is opened and
nowhere else; everything outside of it knows ``Engine`` and the bridge.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, Protocol, Self, Unpack

from c4s.engine.faults import EngineCallError, EngineDied
from c4s.engine.finding import EngineFinding
from c4s.errors import unknown

if TYPE_CHECKING:
    from c4s.engine.inputs import EngineInputs

__all__ = [
    "DEFAULT_ENGINE",
    "Backend",
    "Calls",
    "Engine",
    "EngineCallError",
    "EngineDied",
    "EngineFinding",
    "backend",
    "engine_kinds",
    "open_engine",
]


class Calls(Protocol):
    """What is asked of an engine while an agent works in it."""

    def request(self, kind: str, params: Mapping[str, Any] | None = None, timeout_s: float = 300.0) -> dict[str, Any]:
        """One bridge request; its reply whatever its status. ``EngineDied`` when the process has ended."""
        ...

    def call(self, function: str, /, *, timeout_s: float = 600.0, **params: Any) -> Any:
        """Run ``c4s.editor.<module>.<function>(**params)`` in the engine and return its value.

        Raises ``EngineCallError`` when the function raised, ``BridgeFault`` when it took longer than ``timeout_s``.
        """
        ...


class Engine(Calls, Protocol):
    """One engine process with one open level. Use it as a context manager, or call ``close``."""

    @property
    def kind(self) -> str:
        """The name in the registry that it was opened under."""
        ...

    @property
    def version(self) -> str:
        """The version that it calls itself, as its snapshots say it."""
        ...

    @property
    def sandbox(self) -> str:
        """What confines the process: ``bubblewrap``, ``landlock``, or ``none`` where that was accepted."""
        ...

    @property
    def alive(self) -> bool:
        """Whether the process runs."""
        ...

    @property
    def logs(self) -> Path:
        """Folder of ``engine.log`` and ``job-<n>.log``, out of the engine's reach."""
        ...

    def execute(self, script: str, timeout_s: float = 600.0) -> dict[str, Any]:
        """Run a script to its end and return the final reply with all its lines under ``result.python_logs``.

        A script that is still running after ``timeout_s`` is abandoned, and its last reply says ``running``.
        """
        ...

    def close(self) -> None:
        """Ask the engine to end, and end it if it does not, or is busy."""
        ...

    def kill(self) -> None:
        """End the process at once; what it printed is kept."""
        ...

    def __enter__(self) -> Self: ...

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None: ...


class Backend(Protocol):
    """The face of a backend's package."""

    version: str
    """Version of the API that its engines follow here."""
    level_suffix: str
    """What the file of a saved level's package ends with, below ``<content>``."""

    def open_session(self, **given: Unpack[EngineInputs]) -> Engine:
        """Start an engine and wait until it serves; see ``open_engine``."""
        ...

    def findings(self) -> Iterable[EngineFinding]:
        """What its engines need of this machine, there or not, without starting one."""
        ...

    def warm(self, packs: Sequence[Path]) -> Path:
        """Make what all later engines only read (compiled kernels, shaders), by a process that runs no agent code.

        Returns the folder that holds it. Raises as ``open_session``.
        """
        ...

    def asset_paths(self, level: Path) -> list[str]:
        """Paths of all assets and Blueprint classes that a saved level names, sorted."""
        ...

    def export_glb(self, level: Path, packs: Sequence[Path], glb: Path, *, walk: bool = False) -> dict[str, Any]:
        """Write a saved level as one GLB file, without an engine process; what it holds by count, and ``unresolved``.

        With ``walk`` where a body can walk is in it, as nodes that ``layers`` names.

        No code of an agent runs, so this is done in the process that asks.
        """
        ...


def _headless() -> Backend:
    from c4s.engine import headless

    return headless


def _unreal() -> Backend:
    from c4s.engine import unreal

    return unreal


def _unreal_standin() -> Backend:
    from c4s.engine.unreal import standin

    return standin


DEFAULT_ENGINE = "headless"
"""The engine that needs nothing but the default install."""
_BACKENDS: dict[str, Callable[[], Backend]] = {
    DEFAULT_ENGINE: _headless,
    "unreal": _unreal,
    "unreal-standin": _unreal_standin,
}


def engine_kinds() -> tuple[str, ...]:
    """The kinds of engine that can be asked for."""
    return tuple(_BACKENDS)


def backend(kind: str) -> Backend:
    """A backend by its kind; ``BadInput`` for one that there is not."""
    if kind not in _BACKENDS:
        raise unknown("engine", kind, _BACKENDS)
    return _BACKENDS[kind]()


def open_engine(kind: str, **given: Unpack[EngineInputs]) -> Engine:
    """Start an engine and wait until it serves.

    Args:
        kind: one of ``engine_kinds()``.
        packs: pack folders, read-only for the engine.
        content: where ``/Game`` lies; writable unless ``content_read_only``.
        scratch: a writable folder for what is no content; the engine's logs lie beside it, where it cannot reach them.
        levels: level documents, read-only, known by their own package name.
        start_map: package to open; without it an untitled empty level is open.
        content_read_only: mount ``content`` read-only.
        offered: meshes and Blueprints of the packs that are there, by path (``c4s.protocol.content``); null for all.

    Raises:
        BadInput: an unknown kind, or what was given cannot be loaded.
        MachineryFault: the engine does not come up, or cannot be run safely on this machine.
    """
    return backend(kind).open_session(**given)
