"""Stored evidence once more: the flows rejudge and curate on a run of the suite ``small``."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from tests.run.conftest import apart, environment, trial_in
from tests.run.handed_on import baselines_home, hand_on
from tests.run.test_evaluate import OFFLINE
from warehouse.database import rows

CASE = "text-flat-family"
FLOWS = """
import asyncio, json
from flows.again import rejudge
from flows.curate import curate
print(json.dumps([asyncio.run(rejudge("small")), curate("small")]))
"""


def test_evidence_is_judged_anew_without_an_engine(
    home: Path, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    own = apart(tmp_path / "home", home)
    hand_on(baselines_home(tmp_path_factory), own, ["oracle", "noop"], [CASE])
    question = "SELECT configuration, score FROM outcomes ORDER BY configuration"
    before = rows(own / "warehouse", question)
    trial = trial_in(own, "small", "oracle", CASE)
    kept = trial.verdict("detailed").read_bytes()
    told = subprocess.run(
        [sys.executable, "-c", FLOWS],
        env=environment(own) | OFFLINE | {"PREFECT_HOME": str(tmp_path / "prefect")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert told.returncode == 0, told.stderr[-3000:]
    changed, curated = json.loads(told.stdout.splitlines()[-1])
    assert changed == [] and rows(own / "warehouse", question) == before
    spatial = rows(own / "warehouse", "SELECT * FROM conditional_spatial WHERE configuration = 'oracle'")
    assert {row["predicate_type"]: (row["requirements"], row["kept"]) for row in spatial} == {
        "composition": (2, 0),
        "distribution": (1, 0),
        "spatial_relation": (12, 0),
    }
    aside = list(trial.verdict("detailed").parent.glob("detailed.json.outdated-*"))
    assert [path.read_bytes() for path in aside] == [kept]
    assert curated["suite"] == "small" and curated["repairs"] == 2 and curated["files"] > 10
