"""Open questions: what an engine does is put on record (``questions.yaml``), and neither answer fails."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import yaml

from c4s.engine.conformance.check import Check
from c4s.engine.conformance.ground import Ground
from c4s.errors import C4SError

GROUP = "questions"
NOT_ASKED = "not asked: "


def _question(entry: Mapping[str, Any]) -> Check:
    def run(ground: Ground) -> str:
        if not entry.get("asked", True):
            return f"{NOT_ASKED}{entry['reason']}"
        try:
            return json.dumps(ground.facts(entry["script"]))
        except C4SError as error:
            return error.line()

    return Check(entry["name"], GROUP, entry["says"], run)


def _read() -> list[Check]:
    return [_question(entry) for entry in yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text("utf-8"))]


QUESTIONS = _read()
