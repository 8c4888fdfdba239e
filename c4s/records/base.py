"""The base of all records: strict, frozen, and read with one clear line when they are wrong."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any, ClassVar, Self

from pydantic import BaseModel, ConfigDict, ValidationError

from c4s.errors import BadInput
from c4s.files import digest, read_json, read_written_json, write_json

SEAL = "sha256"
"""Key of a sealed record's own digest in its file."""


MOST_FAULTS = 100
"""A record with more is not looked into: to list a million faults takes minutes."""
_LONGEST_PLACE = 200
_WORDS = {
    "missing": "it is missing",
    "extra_forbidden": "there is no such field",
    "model_type": "it is no mapping of names to values",
    "model_attributes_type": "it is no mapping of names to values",
    "dict_type": "it is no mapping of names to values",
    "recursion_loop": "it is nested too deep",
}
"""What pydantic's messages say with names of classes in them."""


def first_fault(error: ValidationError) -> tuple[str, str]:
    """The first wrong field of a record, and what is wrong with it."""
    if error.error_count() > MOST_FAULTS:
        return "value", f"{error.error_count():,} fields are wrong"
    first = error.errors(include_url=False, include_input=False, include_context=False)[0]
    place = ".".join(str(part) for part in first["loc"])[:_LONGEST_PLACE] or "value"
    return place, _WORDS.get(first["type"]) or first["msg"].removeprefix("Value error, ")


class Record(BaseModel):
    """A typed record with a JSON form. Unknown fields are refused."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    @classmethod
    def parse(cls, value: Any, *, where: str = "") -> Self:
        """Validate plain data; raises ``BadInput`` that names the first wrong field."""
        try:
            return cls.model_validate(value)
        except ValidationError as error:
            field, message = first_fault(error)
            raise BadInput(f"{cls.called()} field {field!r}: {message}", where=where) from None

    @classmethod
    def read(cls, path: Path) -> Self:
        """Read and validate a JSON file."""
        return cls.parse(read_json(path, what=cls.called(), plain=True), where=str(path))

    @classmethod
    def called(cls) -> str:
        """What such a record is called in messages: the words of its class's name."""
        return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", cls.__name__).lower()

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
        return cls.opened(read_written_json(path, what=cls.called(), todo=cls.REMEDY), where=str(path))

    @classmethod
    def opened(cls, value: Any, *, where: str) -> Self:
        """Compare plain data with the digest in it, and validate; ``BadInput`` for data that was changed."""
        seal = value.get(SEAL) if isinstance(value, dict) else None
        if seal is None:
            raise BadInput(f"this {cls.called()} holds no digest of itself", where=where, todo=cls.REMEDY)
        own = {key: part for key, part in value.items() if key != SEAL}
        if seal != digest(own):
            raise BadInput("the file has changed since it was written", where=where, todo=cls.REMEDY)
        return cls.parse(own, where=where)

    def write(self, path: Path) -> None:
        """Write as JSON with the digest at its end, atomically."""
        value = self.plain()
        write_json(path, {**value, SEAL: digest(value)})
