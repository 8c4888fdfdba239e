"""Agent configurations by name: the five baselines, and any from a YAML file."""

from __future__ import annotations

from pathlib import Path

import yaml

from c4s.errors import BadInput
from c4s.protocol.baselines import BASELINES, VALIDATING
from c4s.records.plan import Configuration


def configuration(name: str) -> Configuration:
    """A baseline by name, or the configuration in a ``.yaml`` file. ``BadInput`` for anything else."""
    if name in BASELINES:
        return Configuration(name=name, client=name)
    path = Path(name)
    if path.suffix in (".yaml", ".yml") and path.is_file():
        try:
            value = yaml.safe_load(path.read_text())
        except yaml.YAMLError as error:
            raise BadInput(f"this configuration is not YAML: {error}", where=name) from None
        return Configuration.parse(value, where=name)
    raise BadInput(
        f"unknown agent {name!r}", todo=f"use one of {', '.join(BASELINES)}, or a configuration file (docs/agents.md)"
    )


def is_ranked(chosen: Configuration) -> bool:
    """Whether results of this configuration may have a rank."""
    return chosen.client not in VALIDATING
