"""A suite file as text that people go on writing in."""

from __future__ import annotations

from typing import Any

import yaml

from cases.workshop.document import SuiteFile

_GUIDE = """\
# One entry a case. Kinds of change: removal, insertion, duplication, replacement, move, rotate, rescale, mirror.
# Lengths in cm, angles in degrees. Build: c4s suite build {name}   Look at it: c4s suite preview {suite}
"""


class _Flow(list[Any]):
    """A list that is written on one line."""


class _Dumper(yaml.SafeDumper):
    """Plain YAML; short lists of numbers on one line."""

    def increase_indent(self, flow: bool = False, indentless: bool = False) -> None:
        super().increase_indent(flow, False)


_Dumper.add_representer(
    _Flow, lambda dumper, value: dumper.represent_sequence("tag:yaml.org,2002:seq", value, flow_style=True)
)


def suite_text(file: SuiteFile, schema: str) -> str:
    """YAML of a suite file with a line that tells editors its schema; values that nobody chose are left out."""
    value = file.model_dump(mode="json", exclude_defaults=True)
    body = yaml.dump(_flowing(value), Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=120)
    return f"# yaml-language-server: $schema={schema}\n{_GUIDE.format(name='suite.yaml', suite=file.suite_id)}{body}"


def _flowing(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _flowing(part) for key, part in value.items()}
    if isinstance(value, list):
        plain = all(isinstance(part, int | float) for part in value)
        return _Flow(value) if plain and value else [_flowing(part) for part in value]
    return value
