"""YAML as JSON has it: no key twice, no tags, no dates, no merges, texts as keys."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from typing import Any

import yaml

from c4s.bounds import BOUNDS

MOST_DIGITS = 400


class _Refused(ValueError):
    """What YAML has and JSON has not."""


class _Plain(yaml.SafeLoader):
    """The safe loader without what JSON cannot say."""


def _mapping(loader: _Plain, node: yaml.MappingNode) -> dict[str, Any]:
    made: dict[str, Any] = {}
    for key_node, value_node in node.value:
        line = key_node.start_mark.line + 1
        if key_node.tag == "tag:yaml.org,2002:merge":
            raise _Refused(f"the merge key in line {line} is none of JSON: write the fields out")
        key = loader.construct_object(key_node, deep=True)
        if not isinstance(key, str):
            raise _Refused(f"the key {key!r} in line {line} is no text")
        if key in made:
            raise _Refused(f"the key {key!r} stands twice, again in line {line}")
        made[key] = loader.construct_object(value_node, deep=True)
    return made


def _text(loader: _Plain, node: yaml.ScalarNode) -> str:
    return str(loader.construct_scalar(node))


def _number(read: Callable[[_Plain, yaml.ScalarNode], Any]) -> Callable[[_Plain, yaml.ScalarNode], Any]:
    """A reader of numbers; 10:30, which YAML 1.1 takes for one to the base of 60, is a text."""

    def number(loader: _Plain, node: yaml.ScalarNode) -> Any:
        text = _text(loader, node)
        if ":" in text:
            return text
        if len(text) > MOST_DIGITS:
            raise _Refused(f"the number in line {node.start_mark.line + 1} is too long")
        return read(loader, node)

    return number


_Plain.add_constructor("tag:yaml.org,2002:map", _mapping)
_Plain.add_constructor("tag:yaml.org,2002:timestamp", _text)
_Plain.add_constructor("tag:yaml.org,2002:int", _number(_Plain.construct_yaml_int))
_Plain.add_constructor("tag:yaml.org,2002:float", _number(_Plain.construct_yaml_float))


def parse_yaml(text: str) -> Any:
    """Plain data of a YAML document. ``ValueError`` for text that is none, ``RecursionError`` for one too deep."""
    try:
        value = yaml.load(text, Loader=_Plain)
    except yaml.MarkedYAMLError as error:
        place = f" in line {error.problem_mark.line + 1}" if error.problem_mark else ""
        raise ValueError(f"{error.problem or error.context}{place}") from None
    except _Refused as refused:
        raise ValueError(str(refused)) from None
    except (ValueError, OverflowError):
        raise ValueError("a number in it is too long, or is none") from None
    except yaml.YAMLError as error:
        raise ValueError(getattr(error, "reason", None) or str(error)) from None
    _check(value)
    return value


def _check(value: Any) -> None:
    """``ValueError`` for what JSON has no word for: binary data, sets, half a surrogate pair.

    What an alias stands for counts each time: a few lines can hold more than any machine.
    """
    limit, found, waiting = BOUNDS["yaml_values"], 1, [value]
    while waiting:
        part = waiting.pop()
        found += len(part) if isinstance(part, list) else 2 * len(part) if isinstance(part, dict) else 0
        if fault := limit.fault(found):
            raise ValueError(fault)
        if isinstance(part, dict):
            waiting += [*part, *part.values()]
        elif isinstance(part, list):
            waiting += part
        elif isinstance(part, str):
            try:
                part.encode()
            except UnicodeEncodeError:
                raise ValueError("a text in it is half a surrogate pair") from None
        elif isinstance(part, int) and abs(part) > sys.float_info.max:
            raise ValueError("a number in it is too long")
        elif not isinstance(part, bool | int | float | None) or part in (math.inf, -math.inf) or part != part:
            raise ValueError(f"{part!r} is no plain value")
