"""YAML as JSON has it: no key twice, no tags, no dates, texts as keys."""

from __future__ import annotations

import math
from typing import Any

import yaml

from c4s.bounds import BOUNDS


class _Plain(yaml.SafeLoader):
    """The safe loader without what JSON cannot say."""


def _mapping(loader: _Plain, node: yaml.MappingNode) -> dict[str, Any]:
    loader.flatten_mapping(node)
    made: dict[str, Any] = {}
    for key_node, value_node in node.value:
        key = loader.construct_object(key_node, deep=True)
        line = key_node.start_mark.line + 1
        if not isinstance(key, str):
            raise ValueError(f"the key {key!r} in line {line} is no text")
        if key in made:
            raise ValueError(f"the key {key!r} stands twice, again in line {line}")
        made[key] = loader.construct_object(value_node, deep=True)
    return made


def _text(loader: _Plain, node: yaml.ScalarNode) -> str:
    return str(loader.construct_scalar(node))


_Plain.add_constructor("tag:yaml.org,2002:map", _mapping)
_Plain.add_constructor("tag:yaml.org,2002:timestamp", _text)


def parse_yaml(text: str) -> Any:
    """Plain data of a YAML document. ``ValueError`` for text that is none, ``RecursionError`` for one too deep."""
    try:
        value = yaml.load(text, Loader=_Plain)
    except yaml.MarkedYAMLError as error:
        place = f" in line {error.problem_mark.line + 1}" if error.problem_mark else ""
        raise ValueError(f"{error.problem or error.context}{place}") from None
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
        elif not isinstance(part, bool | int | float | None) or part in (math.inf, -math.inf) or part != part:
            raise ValueError(f"{part!r} is no plain value")
