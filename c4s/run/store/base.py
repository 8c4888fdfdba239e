"""What a store can do; and a folder as one."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Final, Protocol

from c4s.run.store.leases import FolderLeases, LeasePlace

STORE: Final = "C4S_STORE"
"""URL of the object store, such as ``s3://bucket/prefix``. Unset: ``C4S_HOME`` itself is what machines share."""
Only = Callable[[str], bool]


class Store(Protocol):
    """Folders and files of ``C4S_HOME`` as all machines have them. A path is one below this machine's ``C4S_HOME``.

    ``MachineryFault`` where the store is not reached or does not hold what it names.
    """

    @property
    def name(self) -> str:
        """The URL or the folder, for people. It holds no secret."""
        ...

    @property
    def apart(self) -> bool:
        """Whether what is written here is elsewhere only after a push."""
        ...

    def leases(self, folder: Path) -> LeasePlace:
        """The leases that a folder of ``C4S_HOME`` stands for."""
        ...

    def pull(self, folder: Path, only: Only | None = None) -> bool:
        """Make a folder what the last push of it was; whether there was one. What lies there beside it is set aside.

        ``only``: no other file than those whose relative names it takes, and nothing is set aside.
        """
        ...

    def push(self, folder: Path, check: Callable[[], None] | None = None) -> None:
        """Put a folder as it is in place of its last push: all of it at once, or nothing.

        ``check`` is called when all has been sent and nothing replaced: what it raises leaves the last push in place.
        """
        ...

    def pull_files(self, place: Path, only: Only | None = None) -> list[Path]:
        """Fetch a file, or all files below a folder, that were pushed since; those that were fetched.

        ``only``: of a folder, no other file than those whose relative names it takes.
        """
        ...

    def push_files(self, place: Path) -> None:
        """Put a file, or each file below a folder, under its own name, where it differs from what was put there."""
        ...

    def put(self, path: Path, place: Path) -> None:
        """Put a file as it is under the name of another place."""
        ...


class SharedFolder:
    """``C4S_HOME`` is a folder that all machines see (or there is one machine): nothing is sent anywhere."""

    apart = False
    name = "C4S_HOME"

    def leases(self, folder: Path) -> LeasePlace:
        return FolderLeases(folder)

    def pull(self, folder: Path, only: Only | None = None) -> bool:
        return folder.is_dir()

    def push(self, folder: Path, check: Callable[[], None] | None = None) -> None:
        return

    def pull_files(self, place: Path, only: Only | None = None) -> list[Path]:
        return []

    def push_files(self, place: Path) -> None:
        return

    def put(self, path: Path, place: Path) -> None:
        return
