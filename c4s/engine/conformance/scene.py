"""Checks of the scene: scripts as agents write them, with the facts that they must find (``scene.yaml``)."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import yaml

from c4s.engine.conformance.check import Check, need_facts
from c4s.engine.conformance.ground import Ground


def _check(entry: Mapping[str, Any]) -> Check:
    def run(ground: Ground) -> None:
        need_facts(ground.facts(entry["script"]), entry["facts"])

    return Check(entry["name"], entry["group"], entry["says"], run)


def _read() -> list[Check]:
    entries = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8"))
    return [_check(entry) for entry in entries]


CHECKS = _read()
