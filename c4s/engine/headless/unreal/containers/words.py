"""Name and Text: Unreal's own words, which are not ``str``."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


class _Word:
    """An immutable piece of text that compares with ``str`` but is none."""

    __slots__ = ("_text",)

    def __init__(self, value: object = "") -> None:
        if not isinstance(value, (str, _Word)):
            raise TypeError(
                f"{type(self).__name__}: Cannot nativize '{type(value).__name__}' as '{type(self).__name__}'"
            )
        self._text = str(value)
        try:
            self._text.encode()
        except UnicodeEncodeError:
            raise TypeError(f"{type(self).__name__}: Cannot nativize 'str' as '{type(self).__name__}'") from None

    def __str__(self) -> str:
        return self._text

    def __len__(self) -> int:
        return len(self._text)


class Name(_Word):
    """FName: compares without case; the empty name is ``None``."""

    __slots__ = ()

    def __init__(self, value: object = "None") -> None:
        super().__init__(value)
        self._text = self._text or "None"

    @classmethod
    def cast(cls, object: object) -> Name:
        """A name of a name or text."""
        return cls(object)

    def __repr__(self) -> str:
        return f'Name("{self._text}")'

    def __eq__(self, other: object) -> bool:
        return isinstance(other, (str, Name)) and str(other).casefold() == self._text.casefold()

    def __lt__(self, other: object) -> bool:
        return str(other).casefold() > self._text.casefold() if isinstance(other, (str, Name)) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._text.casefold())

    def is_none(self) -> bool:
        """Whether this is the empty name."""
        return self == "None"

    def is_valid(self) -> bool:
        """Whether this is a name; every one made from Python is."""
        return True


class Text(_Word):
    """FText: what people read."""

    __slots__ = ()

    @classmethod
    def cast(cls, object: object) -> Text:
        """A text of a text."""
        return cls(object)

    @classmethod
    def as_number(cls, num: float) -> Text:
        """A number with thousands separators and up to three decimals."""
        return cls(f"{num:,.3f}".rstrip("0").rstrip("."))

    @classmethod
    def as_percent(cls, num: float) -> Text:
        """A fraction as whole percent."""
        return cls(f"{num * 100:,.0f}%")

    @classmethod
    def as_currency(cls, val: int, code: str) -> Text:
        """A sum in hundredths of a currency."""
        return cls(f"{code}{val / 100:,.2f}")

    def __repr__(self) -> str:
        return f'Text("{self._text}")'

    def __eq__(self, other: object) -> bool:
        return isinstance(other, (str, Text)) and str(other) == self._text

    def __hash__(self) -> int:
        return hash(self._text)

    def is_empty(self) -> bool:
        """Whether there is no text."""
        return not self._text

    def is_empty_or_whitespace(self) -> bool:
        """Whether there is nothing to read."""
        return not self._text.strip()

    def is_transient(self) -> bool:
        """Whether the text was made by a conversion; not kept here."""
        return False

    def is_culture_invariant(self) -> bool:
        """Whether the text is the same in all languages; all texts here are."""
        return True

    def is_from_string_table(self) -> bool:
        """String tables do not exist here."""
        return False

    def to_lower(self) -> Text:
        """In lower case."""
        return Text(self._text.lower())

    def to_upper(self) -> Text:
        """In upper case."""
        return Text(self._text.upper())

    def format(self, *args: Any, **named_args: object) -> Text:
        """With ``{0}`` and ``{name}`` replaced."""
        given: dict[str, object] = dict(named_args)
        for index, value in enumerate(args):
            given.update(value if isinstance(value, Mapping) else {str(index): value})
        text = self._text
        for name, value in given.items():
            text = text.replace("{" + name + "}", str(value))
        return Text(text)
