"""A warehouse of known truth: configurations of planted ability on cases of planted difficulty, by source scenes.

Its shape is the paper's public set: 14 configurations, 20 texts from 20 sources, 25 indoor repairs from 9 levels and 50
outdoor repairs from 10 scenes. It is written as runs write theirs, a part a configuration and table, so everything that
reads a warehouse can be measured and tested on it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from bench.made_verdicts import made_verdicts
from c4s.files import digest
from c4s.meter.prices import COST_CLASSES
from c4s.protocol.case import SEMANTIC
from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR, SETTINGS, Setting, is_construction
from warehouse.database import rebuild
from warehouse.parquet import arrow_schema
from warehouse.records import HEADLINES

SUITE: Final = "made"
PUBLIC_SET: Final[tuple[tuple[Setting, int, int], ...]] = (
    (SETTINGS[0], 20, 20),
    (INDOOR_REPAIR, 25, 9),
    (OUTDOOR_REPAIR, 50, 10),
)
"""Setting, cases, source scenes."""
DIFFICULTIES: Final = ("easy", "medium", "hard")
GROUPS: Final = ("Restore", "Lifecycle", "Layout", "Symmetry", "Transform")
SPREAD_SOURCE, SPREAD_CASE, SPREAD_TRIAL = 0.12, 0.10, 0.08
"""Standard deviations of what a source scene, a case in it, and a trial of it add to a score."""


@dataclass
class MadeWarehouse:
    """What is written, and what was planted."""

    root: Path
    abilities: Sequence[float]
    """Of each configuration: its mean score, before what sources, cases and chance add."""
    shape: Sequence[tuple[Setting, int, int]] = PUBLIC_SET
    repeats: int = 1
    seed: int = 1
    pending: frozenset[tuple[str, str]] = frozenset()
    """Configuration and case of trials that have no outcome."""
    judges: Sequence[str] = ("made-judge",)
    private: frozenset[str] = frozenset()
    """Private cases."""
    zeros: Mapping[tuple[str, str], str] = field(default_factory=dict)
    """Reason codes of trials that are worth zero without being measured, by configuration and case."""
    unpriced: frozenset[tuple[str, str]] = frozenset()
    """Configuration and case of trials whose usage is not known."""
    documents: bool = False
    """Whether verdict documents and scripts are written too (``bench/made_verdicts.py``)."""
    planted: dict[str, np.ndarray[Any, np.dtype[np.float64]]] = field(default_factory=dict)
    """Each configuration's expected score of each case."""

    def names(self) -> list[str]:
        """Configurations, in the order of ``abilities``."""
        return [f"agent-{place:02d}" for place in range(1, len(self.abilities) + 1)]

    def cases(self) -> list[dict[str, Any]]:
        """The facts of each case."""
        found = []
        for setting, count, scenes in self.shape:
            prefix = setting.rpartition("/")[2]
            for place in range(count):
                repair = not is_construction(setting)
                case_id = f"{prefix}-{place + 1:02d}"
                found.append(
                    {
                        "case_id": case_id,
                        "setting": setting,
                        "scene_id": f"{prefix}-scene-{place % scenes + 1:02d}",
                        "title": f"Made {prefix} {place + 1}",
                        "prompt": "A yard.",
                        "operations": "move" if repair else "",
                        "operation_group": GROUPS[place % len(GROUPS)] if repair else None,
                        "difficulty": DIFFICULTIES[place % len(DIFFICULTIES)],
                        "visibility": "private" if case_id in self.private else "public",
                        "proxy_assets": False,
                    }
                )
        return found

    def write(self) -> Path:
        """Write the parts, build the database; returns the warehouse's folder."""
        random = np.random.default_rng(self.seed)
        cases = self.cases()
        scenes = {case["scene_id"]: random.normal(0, SPREAD_SOURCE) for case in cases}
        hardness = np.array([scenes[case["scene_id"]] + random.normal(0, SPREAD_CASE) for case in cases])
        for judge in self.judges:
            for name, ability in zip(self.names(), self.abilities, strict=True):
                self.planted[name] = np.clip(ability + hardness, 0, 1)
                self._configuration(name, judge, cases, random)
        rebuild(self.root)
        return self.root

    def _configuration(
        self, name: str, judge: str, cases: Sequence[dict[str, Any]], random: np.random.Generator
    ) -> None:
        rows: dict[str, list[dict[str, Any]]] = {table: [] for table in _TABLES}
        for place, case in enumerate(cases):
            for repeat in range(1, self.repeats + 1):
                key = self.key(name, judge, case, repeat)
                rows["schedule"].append({**key, **case, **_PLAN, "judge": judge})
                if (name, case["case_id"]) not in self.pending:
                    score = float(np.clip(self.planted[name][place] + random.normal(0, SPREAD_TRIAL), 0, 1))
                    for table, row in _outcome(key, case, judge, score, random):
                        rows[table].append(self._marked(table, row))
                    for table, row in made_verdicts(key, case, random) if self.documents else ():
                        rows[table].append(row)
        for table, found in rows.items():
            schema = arrow_schema(table, partitions=False)
            made = pa.table({column: [row.get(column) for row in found] for column in schema.names}, schema=schema)
            folder = self.root / table / f"suite={SUITE}" / f"configuration={name}"
            folder.mkdir(parents=True, exist_ok=True)
            pq.write_table(made, folder / f"{judge}.parquet", compression="zstd")

    def _marked(self, table: str, row: dict[str, Any]) -> dict[str, Any]:
        """A row with the zero and the gap that are planted for its trial."""
        key = (row["configuration"], row["case_id"])
        if table == "outcomes" and key in self.zeros:
            none = {name: 0.0 for name in ("score", "physics", *HEADLINES) if row.get(name) is not None}
            return {**row, **none, "status": "zero_invalid_candidate", "reason_code": self.zeros[key]}
        if table == "components" and key in self.zeros:
            return {**row, "value": 0.0}
        if table == "attempts" and key in self.unpriced:
            return {**row, **dict.fromkeys(_USAGE), "unpriced_requests": 1}
        return row

    def key(self, name: str, judge: str, case: dict[str, Any], repeat: int) -> dict[str, Any]:
        """What the rows of a trial have in common."""
        return {
            "trial_id": digest([judge, name, case["case_id"], repeat]),
            "run_id": SUITE,
            "suite": SUITE,
            "suite_digest": "d" * 64,
            "configuration": name,
            "configuration_digest": f"{name:0<64}",
            "case_id": case["case_id"],
            "repeat": repeat,
        }


_TABLES: Final = ("schedule", "outcomes", "attempts", "components", "verdicts", "python_submissions")
_PLAN: Final = {
    "planned_at": "2026-01-01T00:00:00",
    "client": "made",
    "model": None,
    "policy": "made-policy",
    "judge_version": "1",
    "engine": "headless",
    "ranked": True,
}


_USAGE: Final = tuple(f"{name}_usd" for name in COST_CLASSES)


def _outcome(
    key: dict[str, Any], case: dict[str, Any], judge: str, score: float, random: np.random.Generator
) -> Iterator[tuple[str, dict[str, Any]]]:
    """A trial's rows: its parts add up to its score by the adopted weights."""
    (usage,) = random.spawn(1)
    physical = float(random.uniform(0.5, 1.0))
    quality = float(np.clip((score - 0.2 * physical) / 0.8, 0, 1))
    score = 0.8 * quality + 0.2 * physical
    calls, python, polling = (int(random.poisson(mean)) for mean in (40, 8, 5))
    parts = {"detailed": quality, "overview": quality} if is_construction(case["setting"]) else _repair(quality)
    shared = {**_PLAN, "judge": judge, "setting": case["setting"], "scene_id": case["scene_id"]}
    yield (
        "outcomes",
        {
            **key,
            **shared,
            **parts,
            "physics": physical,
            "status": "measured",
            "score": score,
            "reason": "",
            "reason_code": "",
            "attempts": 1,
            "retained_attempt": 1,
            "tool_calls": calls + python + polling,
            "attempt_wall_s": float(random.uniform(60, 600)),
            "input_tokens": int(random.integers(10_000, 500_000)),
            "output_tokens": int(random.integers(1_000, 50_000)),
            "cost_usd": float(random.uniform(0.1, 5)),
            "score_sha256": "0" * 64,
        },
    )
    if is_construction(case["setting"]):
        yield "components", {**key, "verifier": SEMANTIC, "name": "score", "value": quality}
    yield (
        "attempts",
        {
            **key,
            "attempt": 1,
            "ended_by": "agent",
            "recorded": True,
            "client": "made",
            "client_version": "1",
            "engine_version": "made",
            "sandbox": "none",
            "submission": "submission",
            "valid": True,
            "tool_calls": calls + python + polling,
            "polling_calls": polling,
            "python_calls": python,
            "failed_calls": 0,
            "named_transform_calls": 0,
            "wall_s": 60.0,
            "requests": 1,
            "unpriced_requests": 0,
            **{name: float(usage.uniform(0.05, 0.5)) for name in _USAGE},
            "message": "",
        },
    )


def _repair(quality: float) -> dict[str, float]:
    return {"repair_f1": quality, "repair_precision": quality, "repair_recall": quality}
