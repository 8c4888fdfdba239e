"""Agent configurations by name: the six baselines, and any from a YAML file."""

from __future__ import annotations

from pathlib import Path

from c4s.errors import unknown
from c4s.files import read_yaml
from c4s.protocol.baselines import BASELINES, CHEATS, VALIDATING
from c4s.records.plan import Configuration


def configuration(name: str) -> Configuration:
    """A baseline by name, or the configuration in a ``.yaml`` file. ``BadInput`` for anything else."""
    if name in (*BASELINES, *CHEATS):
        return Configuration(name=name, client=name)
    if Path(name).suffix in (".yaml", ".yml"):
        return Configuration.parse(read_yaml(Path(name), what="file"), where=name)
    raise unknown(
        "agent", name, (*BASELINES, *CHEATS), todo="or give the YAML file of a configuration (docs/agents.md)"
    )


def is_ranked(chosen: Configuration) -> bool:
    """Whether results of this configuration may have a rank."""
    return all(one.client not in VALIDATING for one in chosen.everyone())
