"""The base of all records: strict, frozen, and read with one clear line when they are wrong."""

from __future__ import annotations

from pathlib import Path
from typing import Any, ClassVar, Self

from pydantic import BaseModel, ConfigDict, ValidationError

from c4s.errors import BadInput
from c4s.files import digest, read_json, read_written_json, write_json

SEAL = "sha256"
"""Key of a sealed record's own digest in its file."""


class Record(BaseModel):
    """A typed record with a JSON form. Unknown fields are refused."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    @classmethod
    def parse(cls, value: Any, *, where: str = "") -> Self:
        """Validate plain data; raises ``BadInput`` that names the first wrong field."""
        try:
            return cls.model_validate(value)
        except ValidationError as error:
            first = error.errors()[0]
            field = ".".join(str(part) for part in first["loc"]) or "value"
            raise BadInput(f"{cls.__name__} field {field!r}: {first['msg']}", where=where) from None

    @classmethod
    def read(cls, path: Path) -> Self:
        """Read and validate a JSON file."""
        return cls.parse(read_json(path, what=cls.__name__), where=str(path))

    def write(self, path: Path) -> None:
        """Write as JSON, atomically."""
        write_json(path, self.plain())

    def plain(self) -> dict[str, Any]:
        """The record as plain JSON data."""
        return self.model_dump(mode="json")

    def sha256(self) -> str:
        """SHA-256 of the canonical JSON."""
        return digest(self.plain())


class Sealed(Record):
    """A record whose file holds its own digest, so that a file that was changed is refused."""

    REMEDY: ClassVar[str] = ""
    """What to do about a file that was changed."""

    @classmethod
    def read(cls, path: Path) -> Self:
        """Read, compare with the digest in the file, and validate; ``BadInput`` for a file that was changed."""
        value = read_written_json(path, what=cls.__name__, todo=cls.REMEDY)
        seal = value.pop(SEAL, None) if isinstance(value, dict) else None
        if seal is None:
            raise BadInput(f"this {cls.__name__} holds no digest of itself", where=str(path), todo=cls.REMEDY)
        if seal != digest(value):
            raise BadInput("the file has changed since it was written", where=str(path), todo=cls.REMEDY)
        return cls.parse(value, where=str(path))

    def write(self, path: Path) -> None:
        """Write as JSON with the digest at its end, atomically."""
        value = self.plain()
        write_json(path, {**value, SEAL: digest(value)})
