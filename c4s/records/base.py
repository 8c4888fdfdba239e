"""The base of all records: strict, frozen, and read with one clear line when they are wrong."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any, ClassVar, Self

from pydantic import BaseModel, ConfigDict, PrivateAttr, ValidationError

from c4s.errors import BadInput
from c4s.files import digest, read_json, read_written_json, write_json
from c4s.records.migration import brought_up, is_unsealed

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
        """Validate plain data, of an earlier format too (``c4s.records.migration``); raises ``BadInput`` that names the
        first wrong field.
        """
        try:
            return cls.model_validate(cls._today(value, where))
        except ValidationError as error:
            field, message = first_fault(error)
            raise BadInput(f"{cls.called()} field {field!r}: {message}", where=where) from None

    @classmethod
    def read(cls, path: Path) -> Self:
        """Read and validate a JSON file."""
        return cls.parse(read_json(path, what=cls.called(), plain=True), where=str(path))

    @classmethod
    def _today(cls, value: Any, where: str) -> Any:
        """Plain data in the format that this c4s writes."""
        schema = cls.model_fields.get("schema_version")
        known = schema.default if schema is not None else None
        return brought_up(value, known, what=cls.called(), where=where) if isinstance(known, str) else value

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
    _written_as: str | None = PrivateAttr(default=None)
    """SHA-256 of what was read, where that was of an earlier format: who refers to the record knows it by this."""

    @classmethod
    def read(cls, path: Path) -> Self:
        """Read, compare with the digest in the file, and validate; ``BadInput`` for a file that was changed."""
        return cls.opened(read_written_json(path, what=cls.called(), todo=cls.REMEDY), where=str(path))

    @classmethod
    def opened(cls, value: Any, *, where: str) -> Self:
        """Compare plain data with the digest in it, and validate; ``BadInput`` for data that was changed."""
        seal = value.get(SEAL) if isinstance(value, dict) else None
        if seal is None and not (isinstance(value, dict) and is_unsealed(value)):
            raise BadInput(f"this {cls.called()} holds no digest of itself", where=where, todo=cls.REMEDY)
        own = {key: part for key, part in value.items() if key != SEAL}
        if seal is not None and seal != digest(own):
            raise BadInput("the file has changed since it was written", where=where, todo=cls.REMEDY)
        made = cls.parse(own, where=where)
        if getattr(made, "schema_version", None) != own.get("schema_version"):
            made._written_as = digest(own)
        return made

    def sha256(self) -> str:
        """SHA-256 of the canonical JSON: of one that was read in an earlier format, as it was written."""
        return self._written_as or super().sha256()

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """A copy with other fields; one that was changed is known by its own digest."""
        made = super().model_copy(update=update, deep=deep)
        if update:
            made._written_as = None
        return made

    def write(self, path: Path) -> None:
        """Write as JSON with the digest at its end, atomically."""
        value = self.plain()
        write_json(path, {**value, SEAL: digest(value)})
