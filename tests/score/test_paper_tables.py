"""The paper's printed numbers come out of these functions, within what its printed digits allow."""

from __future__ import annotations

import csv
from itertools import pairwise
from typing import Any

import pytest

from c4s.protocol.case import i2s_case, t2s_case
from c4s.score.aggregate import aggregate
from tests.shared import SHARED

TABLES = SHARED / "reference" / "tables"
HALF_UNIT = 0.0005
pytestmark = pytest.mark.skipif(not TABLES.is_dir(), reason=f"no tables of the paper at {TABLES}")


def table(name: str) -> list[dict[str, str]]:
    with (TABLES / name).open(newline="") as lines:
        return list(csv.DictReader(lines))


def near(found: float, printed: str, parts: float = 1.0) -> bool:
    """Whether the printed three decimals allow a number made of parts that were printed with three decimals too."""
    return abs(found - float(printed)) <= HALF_UNIT * (1 + parts) + 1e-9


def test_the_running_cases() -> None:
    rows = table("running_cases.csv")
    assert len(rows) == 8
    for row in rows:
        if row["setting"] == "T2S":
            made = t2s_case(
                valid=True,
                detailed=float(row["detailed"]),
                overview=float(row["overview"]),
                physics=float(row["physics"]),
            )
        else:
            made = i2s_case(valid=True, repair_f1=float(row["f1"]), physics=float(row["physics"]))
            tp, fp, fn = (int(row[name]) for name in ("tp", "fp", "fn"))
            assert near(2 * tp / (2 * tp + fp + fn), row["f1"])
        assert near(made["score"], row["s_case"]), row["case"]


@pytest.mark.parametrize(
    ("name", "indoor", "outdoor"), [("main_results_public.csv", 25, 50), ("main_results_private.csv", 55, 30)]
)
def test_the_leaderboards(name: str, indoor: int, outdoor: int) -> None:
    """Settings as one case each: the pooled means, the model score and the order are the printed ones."""
    printed = {row["agent"]: row for row in table(name)}
    rows: list[dict[str, Any]] = []
    for agent, row in printed.items():
        score = {"model": agent, "status": "measured"}
        rows.append(score | {"setting": "text-to-scene", "case_id": "t", "score": row["s_t2s"]})
        for domain, count in (("indoor", indoor), ("outdoor", outdoor)):
            rows += [
                score
                | {
                    "setting": domain,
                    "case_id": f"{domain}{n}",
                    "score": row["s_i2s"],
                    "repair_f1": row["repair_f1"],
                    "physics": row["physical_i2s"],
                }
                for n in range(count)
            ]
    found = {row["model"]: row for row in aggregate(rows)}
    for agent, row in printed.items():
        assert near(found[agent]["model_score"], row["s_model"]), agent
        made = i2s_case(
            valid=True, repair_f1=found[agent]["i2s_f1_case_macro"], physics=found[agent]["i2s_physics_case_macro"]
        )
        assert near(made["score"], row["s_i2s"]), agent
        semantic = 0.8 * float(row["semantic"]) + 0.2 * float(row["physical_t2s"])
        assert near(semantic, row["s_t2s"]), agent
    order = [float(printed[agent]["s_model"]) for agent in found]
    assert all(later - earlier <= 2 * HALF_UNIT for earlier, later in pairwise(order))
