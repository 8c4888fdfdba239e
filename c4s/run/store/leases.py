"""Where the leases of one thing lie: numbered records of which the highest is in force."""

from __future__ import annotations

import os
import uuid
from contextlib import suppress
from pathlib import Path
from typing import Protocol

from c4s.errors import BadInput
from c4s.records.lease import Lease


class LeasePlace(Protocol):
    """The leases of a run or of a trial. Times are those of the place's own clock."""

    @property
    def where(self) -> str:
        """The place, for people."""
        ...

    def newest(self) -> int | None:
        """The highest number; None where nobody ever held a lease."""
        ...

    def read(self, number: int) -> Lease | None:
        """A lease; None for one that is gone or is no record: it holds nothing."""
        ...

    def take(self, number: int, lease: Lease) -> bool:
        """Put a lease under a number, unless somebody else did so first."""
        ...

    def replace(self, number: int, lease: Lease) -> None:
        """Write a lease anew under its number."""
        ...

    def renew(self, number: int, lease: Lease) -> None:
        """A sign of life. A lease that is gone is not put there again."""
        ...

    def sign(self, number: int) -> float | None:
        """When the last sign of life was: seconds of the place's clock; None for a lease that is gone."""
        ...

    def now(self) -> float:
        """What the place's clock says."""
        ...

    def remove(self, number: int) -> None:
        """Take a lease away; one that is gone is no fault."""
        ...

    def numbers(self) -> list[int]:
        """All numbers that are there."""
        ...


class FolderLeases:
    """Leases as files of a folder, on a file system that may be shared. A taker links its file under the number."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    @property
    def where(self) -> str:
        return str(self.folder.parent)

    def _file(self, number: int) -> Path:
        return self.folder / f"{number:06}.json"

    def numbers(self) -> list[int]:
        try:
            names = os.listdir(self.folder)  # noqa: PTH208
        except FileNotFoundError:
            return []
        return [int(name[:-5]) for name in names if name.endswith(".json") and name[:-5].isdigit()]

    def newest(self) -> int | None:
        return max(self.numbers(), default=None)

    def read(self, number: int) -> Lease | None:
        try:
            return Lease.read(self._file(number))
        except BadInput:
            return None

    def take(self, number: int, lease: Lease) -> bool:
        fresh = self._fresh()
        lease.write(fresh)
        try:
            os.link(fresh, self._file(number))
        except FileExistsError:
            return False
        finally:
            fresh.unlink(missing_ok=True)
        return True

    def replace(self, number: int, lease: Lease) -> None:
        lease.write(self._file(number))

    def renew(self, number: int, lease: Lease) -> None:
        with suppress(FileNotFoundError):
            os.utime(self._file(number))

    def sign(self, number: int) -> float | None:
        try:
            return self._file(number).stat().st_mtime
        except FileNotFoundError:
            return None

    def now(self) -> float:
        fresh = self._fresh()
        fresh.touch()
        try:
            return fresh.stat().st_mtime
        finally:
            fresh.unlink(missing_ok=True)

    def remove(self, number: int) -> None:
        self._file(number).unlink(missing_ok=True)

    def _fresh(self) -> Path:
        self.folder.mkdir(parents=True, exist_ok=True)
        return self.folder / f".{uuid.uuid4().hex}"
