"""What ``c4s up`` started here, on record, so that ``c4s down`` ends just that."""

from __future__ import annotations

import fcntl
import json
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field
from pathlib import Path

from c4s.errors import BadInput
from c4s.files import read_json, write_json
from c4s.home import home
from c4s.records.lease import Owner
from c4s.run.owner import is_gone, is_near


@dataclass
class Service:
    """The server and the workers of this machine."""

    url: str
    """Address of the API: ``http://host:port/api``."""
    database: str = "sqlite"
    """``sqlite``, or ``postgresql`` at an address that is no part of this record: it may hold a password."""
    server: Owner | None = None
    workers: dict[str, Owner] = field(default_factory=dict)
    """By pool."""
    deployed: str = ""
    """Digest of what the server was last told of the flows."""

    @property
    def ui(self) -> str:
        """Address of the pages for people."""
        return self.url.removesuffix("/api")

    def write(self) -> None:
        """Put it on record."""
        plain = asdict(self)
        plain["server"] = self.server.plain() if self.server else None
        plain["workers"] = {name: owner.plain() for name, owner in self.workers.items()}
        write_json(_path(), json.loads(json.dumps(plain)))

    @classmethod
    def read(cls) -> Service | None:
        """What is on record; None where nothing was started."""
        if not _path().is_file():
            return None
        found = read_json(_path(), what="record of what runs")
        try:
            server = found["server"]
            return cls(
                str(found["url"]),
                str(found["database"]),
                Owner.parse(server, where=str(_path())) if server else None,
                {str(name): Owner.parse(owner, where=str(_path())) for name, owner in found["workers"].items()},
                str(found.get("deployed", "")),
            )
        except (KeyError, TypeError, AttributeError):
            raise BadInput(
                "this is no record of what runs", where=str(_path()), todo="end what runs, remove it"
            ) from None

    @staticmethod
    def forget() -> None:
        """Take the record away."""
        _path().unlink(missing_ok=True)


@contextmanager
def alone(tell: Callable[[str], None]) -> Iterator[None]:
    """The block changes what runs here, while no other process does."""
    lock = os.open(next(place for place in (home(), *home().parents) if place.is_dir()), os.O_RDONLY)
    try:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            tell("waiting for another `c4s up` or `c4s down` of this home")
            fcntl.flock(lock, fcntl.LOCK_EX)
        yield
    finally:
        os.close(lock)


def runs(owner: Owner | None) -> bool:
    """Whether a process that was started here is still there."""
    return owner is not None and is_near(owner) and not is_gone(owner)


def _path() -> Path:
    return home() / "service.json"
