"""What ``c4s analyze --help`` says of defaults and of who takes what is what the studies take."""

from __future__ import annotations

import inspect
import re

from c4s.cli.analyze import analyze
from c4s.stats.bootstrap import DRAWS, LEVEL, SEED
from warehouse.analyses import STUDIES


def told(option: str) -> str:
    (found,) = (
        one.help
        for one in inspect.signature(analyze, eval_str=True).parameters[option].annotation.__metadata__
        if one.help
    )
    return str(found)


def test_the_help_tells_defaults_and_takers() -> None:
    assert f"(default: {DRAWS:,})" in told("draws") and f"(default: {LEVEL})" in told("level")
    assert f"mostly {SEED})" in told("seed")
    for option in ("pool", "holm"):
        takers = {name for name, study in STUDIES.items() if option in study.takes}
        (listed,) = re.findall(r"\(([a-z-]+(?:, [a-z-]+)*)\)$", told(option))
        assert set(listed.split(", ")) == takers
