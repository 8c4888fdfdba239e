"""What all enums have; ``str()`` gives ``<LightUnits.CANDELAS: 1>`` as in Unreal's Python."""

from __future__ import annotations

from enum import Enum, unique
from typing import Any

from c4s.engine.headless.unreal.containers import Text
from c4s.engine.headless.unreal.core.checks import TYPES, public


class EnumBase(Enum):
    """Base of all enums."""

    def __str__(self) -> str:
        return f"<{type(self).__name__}.{self.name}: {self.value}>"

    __repr__ = __str__

    @classmethod
    def cast(cls, object: object) -> Any:
        """A member of a member or its number; ``TypeError`` for anything else."""
        if isinstance(object, cls):
            return object
        if isinstance(object, int) and any(member.value == object for member in cls):
            return cls(object)
        raise TypeError(f"Cannot cast type '{type(object).__name__}' to '{cls.__name__}'")

    @classmethod
    def static_enum(cls) -> Any:
        """The enum as an object."""
        return TYPES["Enum"]._make(cls.__name__, None)  # type: ignore[attr-defined]

    def get_display_name(self) -> Text:
        """Name as the editor shows it."""
        return Text(self.name.replace("_", " ").title())


@public
@unique
class PropertyAccessChangeNotifyMode(EnumBase):
    """When the editor is told of a change; here at once."""

    DEFAULT = 0
    NEVER = 1
    ALWAYS = 2
