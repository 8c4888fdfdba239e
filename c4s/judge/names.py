"""Names of the judges, apart from what they need to judge."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from c4s.errors import BadInput, unknown
from c4s.files import read_yaml
from c4s.records.judge import RULE_JUDGE, JudgeConfiguration

RULE: Final = RULE_JUDGE.name
"""The offline rule judge."""
_SHIPPED: Final = Path(__file__).parent / "shipped"
JUDGE_NAMES: Final = (RULE, *sorted(file.stem for file in _SHIPPED.glob("*.yaml")))
DEFAULT_JUDGE: Final = RULE
"""Needs no network."""


def judge_configuration(name: str) -> JudgeConfiguration:
    """A judge by name, or the one of a ``.yaml`` file. ``BadInput`` for anything else."""
    if name == RULE:
        return RULE_JUDGE
    if name in JUDGE_NAMES:
        return _of_a_model(_SHIPPED / f"{name}.yaml")
    if Path(name).suffix in (".yaml", ".yml"):
        return _of_a_model(Path(name))
    raise unknown("judge", name, JUDGE_NAMES, todo="or give the YAML file of a model judge (docs/judge.md)")


def _of_a_model(file: Path) -> JudgeConfiguration:
    found = JudgeConfiguration.parse(read_yaml(file, what="file"), where=str(file))
    if found.kind != "model" or not found.model:
        raise BadInput("a judge of a file asks a model", where=str(file), todo="give it `kind: model` and `model:`")
    if found.name in JUDGE_NAMES and file.parent != _SHIPPED:
        raise BadInput(f"{found.name!r} is the name of a judge that ships", where=str(file), todo="choose another name")
    return found
