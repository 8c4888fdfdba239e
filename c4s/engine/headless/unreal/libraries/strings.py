"""Strings: ``StringLibrary``."""

from __future__ import annotations

import fnmatch
import re
from collections.abc import Sequence
from enum import unique

from c4s.engine.headless.unreal.containers import Array, Name
from c4s.engine.headless.unreal.core import EnumBase, Object, api, public
from c4s.engine.headless.unreal.structs import LinearColor, Rotator, Transform, Vector, Vector2D


@public
@unique
class SearchCase(EnumBase):
    """Whether letters of another case are the same."""

    CASE_SENSITIVE = 0
    IGNORE_CASE = 1


@public
@unique
class SearchDir(EnumBase):
    """Where a search begins."""

    FROM_START = 0
    FROM_END = 1


_IGNORE, _START = SearchCase.IGNORE_CASE, SearchDir.FROM_START
_NUMBER = re.compile(r"[+-]?([0-9]+[.]?[0-9]*|[.][0-9]+)")


def _flags(case: SearchCase) -> re.RegexFlag:
    return re.IGNORECASE if case is _IGNORE else re.RegexFlag(0)


def _place(text: str, part: str, use_case: bool, from_end: bool, start: int = -1) -> int:
    if not use_case:
        text, part = text.casefold(), part.casefold()
    if from_end:
        return text.rfind(part) if start < 0 else text.rfind(part, 0, start)
    return text.find(part, max(0, start))


def _number(text: str) -> float:
    found = _NUMBER.match(text.strip())
    return float(found[0]) if found else 0.0


def _fields(text: str, names: str) -> list[float] | None:
    """Numbers of ``X=1 Y=2``, or None when one is missing."""
    found = [re.search(rf"\b{name}\s*=\s*([-+.0-9eE]+)", text) for name in names.split()]
    return [float(one[1]) for one in found if one] if all(found) else None


def _joined(names: str, numbers: Sequence[float]) -> str:
    return " ".join(f"{name}={number:.3f}" for name, number in zip(names.split(), numbers, strict=True))


@public
class StringLibrary(Object):
    """Functions on strings."""

    @classmethod
    @api
    def trim(cls, source_string: str) -> str:
        """Without space before it."""
        return str(source_string).lstrip()

    @classmethod
    @api
    def trim_trailing(cls, source_string: str) -> str:
        """Without space behind it."""
        return str(source_string).rstrip()

    @classmethod
    @api
    def to_upper(cls, source_string: str) -> str:
        """In upper case."""
        return str(source_string).upper()

    @classmethod
    @api
    def to_lower(cls, source_string: str) -> str:
        """In lower case."""
        return str(source_string).lower()

    @classmethod
    @api
    def reverse(cls, source_string: str) -> str:
        """From its end to its start."""
        return str(source_string)[::-1]

    @classmethod
    @api
    def len(cls, s: str) -> int:
        """Number of characters."""
        return str(s).__len__()

    @classmethod
    @api
    def is_empty(cls, string: str) -> bool:
        """Whether there is nothing."""
        return not str(string)

    @classmethod
    @api
    def is_numeric(cls, source_string: str) -> bool:
        """Whether it is a number."""
        return _NUMBER.fullmatch(str(source_string)) is not None

    @classmethod
    @api
    def concat_str_str(cls, a: str, b: str) -> str:
        """One behind the other."""
        return str(a) + str(b)

    @classmethod
    @api
    def equal_equal_str_str(cls, a: str, b: str) -> bool:
        """Whether two are the same."""
        return str(a) == str(b)

    @classmethod
    @api
    def not_equal_str_str(cls, a: str, b: str) -> bool:
        """Whether two differ."""
        return str(a) != str(b)

    @classmethod
    @api
    def equal_equal_stri_stri(cls, a: str, b: str) -> bool:
        """Whether two are the same, whatever the case."""
        return str(a).casefold() == str(b).casefold()

    @classmethod
    @api
    def not_equal_stri_stri(cls, a: str, b: str) -> bool:
        """Whether two differ in more than the case."""
        return str(a).casefold() != str(b).casefold()

    @classmethod
    @api
    def starts_with(cls, source_string: str, prefix: str, search_case: SearchCase = SearchCase.IGNORE_CASE) -> bool:
        """Whether it begins so."""
        return re.match(re.escape(str(prefix)), str(source_string), _flags(search_case)) is not None

    @classmethod
    @api
    def ends_with(cls, source_string: str, suffix: str, search_case: SearchCase = SearchCase.IGNORE_CASE) -> bool:
        """Whether it ends so."""
        return re.search(re.escape(str(suffix)) + r"\Z", str(source_string), _flags(search_case)) is not None

    @classmethod
    @api
    def contains(cls, search_in: str, substring: str, use_case: bool = False, search_from_end: bool = False) -> bool:
        """Whether it holds another."""
        return _place(str(search_in), str(substring), use_case, search_from_end) >= 0

    @classmethod
    @api
    def find_substring(
        cls,
        search_in: str,
        substring: str,
        use_case: bool = False,
        search_from_end: bool = False,
        start_position: int = -1,
    ) -> int:
        """Where it holds another, -1 for nowhere."""
        return _place(str(search_in), str(substring), use_case, search_from_end, start_position)

    @classmethod
    @api
    def matches_wildcard(
        cls, source_string: str, wildcard: str, search_case: SearchCase = SearchCase.IGNORE_CASE
    ) -> bool:
        """Whether it fits a pattern of ``*`` and ``?``."""
        pattern = fnmatch.translate(str(wildcard).replace("[", "[[]"))
        return re.match(pattern, str(source_string), _flags(search_case)) is not None

    @classmethod
    @api
    def replace(cls, source_string: str, from_: str, to: str, search_case: SearchCase = SearchCase.IGNORE_CASE) -> str:
        """With one string for another."""
        if not str(from_):
            return str(source_string)
        return re.sub(re.escape(str(from_)), lambda _: str(to), str(source_string), flags=_flags(search_case))

    @classmethod
    @api
    def split(
        cls,
        source_string: str,
        str: str,
        search_case: SearchCase = SearchCase.IGNORE_CASE,
        search_dir: SearchDir = SearchDir.FROM_START,
    ) -> tuple[str, str] | None:
        """What lies before and behind another string; None when it is not there."""
        text, part = source_string, str
        place = _place(text, part, search_case is not _IGNORE, search_dir is not _START)
        return (text[:place], text[place + part.__len__() :]) if part and place >= 0 else None

    @classmethod
    @api
    def parse_into_array(cls, source_string: str, delimiter: str = " ", cull_empty_strings: bool = True) -> Array:
        """The parts between delimiters."""
        parts = str(source_string).split(str(delimiter)) if str(delimiter) else [str(source_string)]
        return Array._of("str", [part for part in parts if part or not cull_empty_strings])

    @classmethod
    @api
    def join_string_array(cls, source_array: Sequence[str], separator: str = " ") -> str:
        """All of an array with a separator between."""
        return str(separator).join(str(part) for part in source_array)

    @classmethod
    @api
    def left(cls, source_string: str, count: int) -> str:
        """The first characters."""
        return str(source_string)[: max(0, count)]

    @classmethod
    @api
    def left_chop(cls, source_string: str, count: int) -> str:
        """Without the last characters."""
        text = str(source_string)
        return text[: max(0, text.__len__() - max(0, count))]

    @classmethod
    @api
    def right(cls, source_string: str, count: int) -> str:
        """The last characters."""
        text = str(source_string)
        return text[max(0, text.__len__() - max(0, count)) :]

    @classmethod
    @api
    def right_chop(cls, source_string: str, count: int) -> str:
        """Without the first characters."""
        return str(source_string)[max(0, count) :]

    @classmethod
    @api
    def mid(cls, source_string: str, start: int, count: int) -> str:
        """Characters from a place."""
        return str(source_string)[max(0, start) :][: max(0, count)]

    @classmethod
    @api
    def get_substring(cls, source_string: str, start_index: int = 0, length: int = 1) -> str:
        """Characters from a place; nothing where there are not so many."""
        text = str(source_string)
        fits = start_index >= 0 and length > 0 and start_index + length <= text.__len__()
        return text[start_index : start_index + length] if fits else ""

    @classmethod
    @api
    def left_pad(cls, source_string: str, ch_count: int) -> str:
        """With space before it up to a length."""
        return str(source_string).rjust(ch_count)

    @classmethod
    @api
    def right_pad(cls, source_string: str, ch_count: int) -> str:
        """With space behind it up to a length."""
        return str(source_string).ljust(ch_count)

    # of numbers and structs

    @classmethod
    @api
    def conv_string_to_int(cls, string: str) -> int:
        """The number that it begins with, or 0."""
        return int(_number(str(string)))

    @classmethod
    @api
    def conv_string_to_double(cls, string: str) -> float:
        """The number that it begins with, or 0."""
        return _number(str(string))

    @classmethod
    @api
    def conv_string_to_name(cls, string: str) -> Name:
        """As a name."""
        return Name(str(string))

    @classmethod
    @api
    def conv_string_to_vector(cls, string: str) -> tuple[Vector, bool]:
        """``X=1 Y=2 Z=3`` as a vector, and whether it is one."""
        found = _fields(str(string), "X Y Z")
        return (Vector(*found), True) if found else (Vector(), False)

    @classmethod
    @api
    def conv_string_to_rotator(cls, string: str) -> tuple[Rotator, bool]:
        """``P=1 Y=2 R=3`` as a rotation, and whether it is one."""
        found = _fields(str(string), "P Y R")
        return (Rotator(pitch=found[0], yaw=found[1], roll=found[2]), True) if found else (Rotator(), False)

    @classmethod
    @api
    def conv_int_to_string(cls, int: int) -> str:
        """A whole number."""
        return str(int)

    @classmethod
    @api
    def conv_double_to_string(cls, double: float) -> str:
        """A number, with a decimal at least."""
        text = f"{double:.6f}".rstrip("0")
        return text + "0" if text.endswith(".") else text

    @classmethod
    @api
    def conv_bool_to_string(cls, bool: bool) -> str:
        """``true`` or ``false``."""
        return "true" if bool else "false"

    @classmethod
    @api
    def conv_name_to_string(cls, name: Name | str) -> str:
        """A name."""
        return str(name)

    @classmethod
    @api
    def conv_object_to_string(cls, obj: Object | None) -> str:
        """The name of an object."""
        return "None" if obj is None else str(obj.get_name())

    @classmethod
    @api
    def conv_vector_to_string(cls, vec: Vector) -> str:
        """``X=1.000 Y=2.000 Z=3.000``."""
        return _joined("X Y Z", vec._triple())

    @classmethod
    @api
    def conv_vector2d_to_string(cls, vec: Vector2D) -> str:
        """``X=1.000 Y=2.000``."""
        return _joined("X Y", (vec.x, vec.y))

    @classmethod
    @api
    def conv_rotator_to_string(cls, rot: Rotator) -> str:
        """``P=1.000000 Y=2.000000 R=3.000000``."""
        return f"P={rot.pitch:.6f} Y={rot.yaw:.6f} R={rot.roll:.6f}"

    @classmethod
    @api
    def conv_color_to_string(cls, color: LinearColor) -> str:
        """``(R=1.000000,G=2.000000,B=3.000000,A=4.000000)``."""
        return color.export_text()

    @classmethod
    @api
    def conv_transform_to_string(cls, trans: Transform) -> str:
        """Translation, rotation and scale."""
        turn = trans.rotation.rotator()
        return (
            f"Translation: {cls.conv_vector_to_string(trans.translation)} "
            f"Rotation: {cls.conv_rotator_to_string(turn)} Scale: {cls.conv_vector_to_string(trans.scale3d)}"
        )
