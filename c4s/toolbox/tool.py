"""What a tool is: a name, a described argument schema, and a function over the run's workbench."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from c4s.toolbox.size import ANSWER_SIZE, AROUND, ASKED_SIZE, rows_that_fit

if TYPE_CHECKING:
    from c4s.toolbox.workbench import Workbench

Schema = dict[str, Any]
Arguments = Mapping[str, Any]


@dataclass(frozen=True)
class ToolResult:
    """What a tool gives back: JSON-able data and, for a few tools, one PNG picture."""

    data: dict[str, Any]
    image: bytes | None = None


@dataclass(frozen=True)
class Tool:
    """One of the shared tools (paper, Coding-Agent Interface, table of agent tools)."""

    name: str
    group: str
    description: str
    run: Callable[[Workbench, Arguments], ToolResult]
    properties: Mapping[str, Schema] = field(default_factory=dict)
    required: tuple[str, ...] = ()
    instant: bool = False
    """It looks up a few things in memory and never waits: it runs where its call arrives, without a thread."""
    asks: str = ""
    """The argument by which a caller asks for a long answer."""

    @property
    def input_schema(self) -> Schema:
        """JSON Schema of the arguments; unknown arguments are refused."""
        return {
            "type": "object",
            "properties": dict(self.properties),
            "required": list(self.required),
            "additionalProperties": False,
        }

    @property
    def most(self) -> int:
        """Bytes of text of the longest answer that can be asked for."""
        return ASKED_SIZE if self.asks else ANSWER_SIZE

    def bound(self, arguments: Arguments) -> int:
        """Bytes of text that the answer to a call may have."""
        return self.most if self.asks in arguments else ANSWER_SIZE


def text(description: str, **more: Any) -> Schema:
    """Schema of a string that is not empty."""
    return {"type": "string", "minLength": 1, "description": description, **more}


LABEL_CHARACTERS = 200
"""Longest label that a tool gives an actor."""
MOST_OFFSET = 1_000_000_000
"""Where a part of a list or of an output may begin: beyond any that there is."""
MOST_CM = 1.0e7
"""Largest coordinate, scale or angle that a tool takes: 100 km."""


def label(description: str) -> Schema:
    """Schema of the label of a new actor: a line of printable characters."""
    return text(
        f"{description} At most {LABEL_CHARACTERS} characters, no control characters.",
        maxLength=LABEL_CHARACTERS,
        pattern="^[^\\x00-\\x1f\\x7f-\\x9f\\u2028\\u2029]+$",
    )


def page(default: int, most: int) -> dict[str, Schema]:
    """Schemas of the two arguments that ask for a part of a long list."""
    return {
        "offset": {
            "type": "integer",
            "minimum": 0,
            "maximum": MOST_OFFSET,
            "description": "Where to go on: the `next` of the last answer (default 0).",
        },
        "limit": {
            "type": "integer",
            "minimum": 1,
            "maximum": most,
            "description": f"How many at most (default {default}).",
        },
    }


def asked_page(most: int) -> dict[str, Schema]:
    """Schemas of the two arguments that ask for a part of a long list, as many rows as an answer holds by default."""
    arguments = page(most, most)
    arguments["limit"]["description"] = (
        f"How many at most (default: as many as {ANSWER_SIZE:,} characters hold). With a limit an answer has up to "
        f"{ASKED_SIZE:,} characters, which some clients cut."
    )
    return arguments


def paged(key: str, rows: list[Any], total: int, offset: int, bound: int = ANSWER_SIZE) -> dict[str, Any]:
    """A part of a list: the rows that an answer of ``bound`` bytes holds, how many there are in all, and the offset of
    the next part, null at the end."""
    kept = rows_that_fit(rows, bound - AROUND)
    end = offset + len(kept)
    return {key: kept, "count": len(kept), "total": total, "next": end if end < total else None}


def number(description: str, **more: Any) -> Schema:
    """Schema of a number."""
    return {"type": "number", "description": description, **more}


def vector(description: str) -> Schema:
    """Schema of three numbers."""
    return {"type": "array", "items": COORDINATE, "minItems": 3, "maxItems": 3, "description": description}


def names(description: str) -> Schema:
    """Schema of a list of names."""
    return {"type": "array", "items": {"type": "string", "minLength": 1}, "description": description}


COORDINATE: Schema = {"type": "number", "minimum": -MOST_CM, "maximum": MOST_CM}
LOCATION = vector("World location [x, y, z] in cm: left-handed, Z up.")
ROTATION = vector("World rotation [pitch, yaw, roll] in degrees.")
SCALE: Schema = {
    "description": "Scale factors [x, y, z], or one number for all three.",
    "anyOf": [COORDINATE, {"type": "array", "items": COORDINATE, "minItems": 3, "maxItems": 3}],
}
ACTOR = text("The actor's label (or, where no label fits, its object name).")


def kind(schema: Schema) -> str:
    """What an argument may be, in a few words, with its limits."""
    if "anyOf" in schema:
        return " or ".join(kind(one) for one in schema["anyOf"])
    if "enum" in schema:
        return " / ".join(f"`{value}`" for value in schema["enum"])
    kinds = schema["type"]
    words = " or ".join(kinds) if isinstance(kinds, list) else str(kinds)
    if words == "array":
        low, high = schema.get("minItems"), schema.get("maxItems")
        size = "" if high is None else f"{high} " if low == high else f"up to {high} "
        first, _, rest = kind(schema["items"]).partition(" ")
        return f"list of {size}{first}s {rest}".strip()
    low, high = schema.get("minimum", schema.get("exclusiveMinimum")), schema.get("maximum")
    if low is not None or high is not None:
        over = "> " if "exclusiveMinimum" in schema else ""
        words += f" ({over}{low:g} ...)" if high is None else f" ({over}{low:g} to {high:g})"
    return words + (f", up to {schema['maxLength']} characters" if "maxLength" in schema else "")
