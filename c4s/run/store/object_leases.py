"""Leases as objects: one is made only where there is none of its name (a conditional put)."""

from __future__ import annotations

import errno
import json
import uuid
from typing import Any

from c4s.errors import BadInput
from c4s.records.lease import Lease
from c4s.run.store.reach import reached, without_password


class ObjectLeases:
    """The leases under a key. A sign of life is the object written anew; the clock is the store's."""

    def __init__(self, fs: Any, key: str, name: str) -> None:
        self._fs, self._key, self._name = fs, key, name

    @property
    def where(self) -> str:
        return f"{self._name} ({without_password(self._key)})"

    def _object(self, number: int) -> str:
        return f"{self._key}/{number:06}.json"

    def numbers(self) -> list[int]:
        with reached(self._name):
            try:
                found = self._fs.ls(self._key, detail=False, refresh=True)
            except FileNotFoundError:
                return []
        names = [str(key).rpartition("/")[2].removesuffix(".json") for key in found]
        return [int(name) for name in names if name.isdigit()]

    def newest(self) -> int | None:
        return max(self.numbers(), default=None)

    def read(self, number: int) -> Lease | None:
        with reached(self._name):
            try:
                data = self._fs.cat_file(self._object(number))
            except FileNotFoundError:
                return None
        try:
            return Lease.parse(json.loads(data), where=self._object(number))
        except (BadInput, ValueError):
            return None

    def take(self, number: int, lease: Lease) -> bool:
        with reached(self._name):
            try:
                self._fs.pipe_file(self._object(number), _data(lease), mode="create")
            except FileExistsError:
                return False
            except OSError as error:
                if error.errno != errno.EINVAL or not self._fs.exists(self._object(number)):
                    raise
                return False
        return True

    def replace(self, number: int, lease: Lease) -> None:
        with reached(self._name):
            self._fs.pipe_file(self._object(number), _data(lease))

    def renew(self, number: int, lease: Lease) -> None:
        if self.newest() == number:
            self.replace(number, lease)

    def sign(self, number: int) -> float | None:
        return self._written(self._object(number))

    def now(self) -> float:
        fresh = f"{self._key}/now-{uuid.uuid4().hex}"
        with reached(self._name):
            self._fs.pipe_file(fresh, b"")
        written = self._written(fresh)
        self._remove(fresh)
        return written or 0.0

    def remove(self, number: int) -> None:
        self._remove(self._object(number))

    def _written(self, key: str) -> float | None:
        with reached(self._name):
            try:
                return float(self._fs.modified(key).timestamp())
            except FileNotFoundError:
                return None

    def _remove(self, key: str) -> None:
        with reached(self._name):
            try:
                self._fs.rm_file(key)
            except FileNotFoundError:
                return


def _data(lease: Lease) -> bytes:
    return json.dumps(lease.plain()).encode()
