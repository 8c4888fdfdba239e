"""Comparisons of two runs, and of leaderboards of the same cases under another policy: what would change."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from bench.made_warehouse import MadeWarehouse
from c4s.protocol.settings import INDOOR_REPAIR, OUTDOOR_REPAIR, SETTINGS
from reports.site import build_site
from tests.built import built_once
from tests.reports.watching import complaints, watched
from warehouse.database import rebuild, rows

if TYPE_CHECKING:
    from playwright.sync_api import Browser

SHAPE = ((SETTINGS[0], 3, 3), (INDOOR_REPAIR, 2, 2), (OUTDOOR_REPAIR, 1, 1))
BETTER, WORSE = "agent-01", "agent-02"
TURNED = "text-to-scene-01"
"""The case whose scores another policy turns: the worse agent gets everything, the better one nothing."""
Row = dict[str, Any]


def make(home: Path) -> None:
    """Two agents twice, the second time in another run; all of it again by another policy."""
    made = MadeWarehouse(home / "warehouse", (0.7, 0.6), shape=SHAPE, repeats=2)
    made.write()

    def second_night(row: Row) -> Row:
        return row | {"run_id": "second" if row["repeat"] == 2 else "first"}

    def other_policy(row: Row) -> Row:
        changed = row | {"trial_id": f"other-{row['trial_id']}"}
        if "policy" in row:
            changed |= {"policy": "other-policy"}
        if "score" in row and row["case_id"] == TURNED:
            changed |= {"score": 1.0 if row["configuration_digest"].startswith(WORSE) else 0.0}
        return changed

    for path in sorted(made.root.rglob("*.parquet")):
        change(path, path, second_night)
        change(path, path.with_name("other.parquet"), other_policy)
    rebuild(made.root)
    build_site(made.root, home / "site")


def change(source: Path, target: Path, by: Callable[[Row], Row]) -> None:
    found = pq.ParquetFile(source).read()
    pq.write_table(pa.Table.from_pylist([by(row) for row in found.to_pylist()], schema=found.schema), target)


@pytest.fixture
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built_once(tmp_path_factory, "compared-site", make)


def pages(home: Path) -> dict[str, Path]:
    """The comparison page of each policy."""
    found = sorted((home / "site/boards").glob("*--compare--*"))
    by = {
        name: path
        for path in found
        for name in ("made-policy", "other-policy")
        if f">policy {name}<" in path.read_text()
    }
    assert len(by) == len(found) == 2
    return by


def means(home: Path, configuration: str, policy: str, run: str) -> float:
    told = f"configuration = '{configuration}' AND policy = '{policy}' AND run_id = '{run}'"
    (row,) = rows(home / "warehouse", f"SELECT avg(score) AS mean FROM outcomes WHERE {told}")
    return float(row["mean"])


def test_two_runs_are_compared_over_the_cases_of_both(browser: Browser, home: Path) -> None:
    with watched(browser, pages(home)["made-policy"]) as page:
        shown = [row.split("\t") for row in page.locator("#runs tbody tr").all_inner_texts()]
        assert complaints(page) == []
    assert [row[:4] for row in shown] == [[name, "first", "second", "6"] for name in (BETTER, WORSE)]
    for name, _, _, _, first, second, difference in shown:
        ours = [means(home, name, "made-policy", run) for run in ("first", "second")]
        assert [float(first), float(second)] == pytest.approx(ours, abs=5e-4)
        assert float(difference.replace("−", "-")) == pytest.approx(100 * (ours[1] - ours[0]), abs=5e-3)


def test_another_policy_tells_what_would_change(browser: Browser, home: Path) -> None:
    with watched(browser, pages(home)["made-policy"]) as page:
        section = page.locator("section[id^=other-]")
        assert section.locator("h2").inner_text() == "Another policy"
        assert "made-policy here, other-policy there" in section.locator("p").first.inner_text()
        told = {row[0]: row for row in (text.split("\t") for text in section.locator("tbody tr").all_inner_texts())}
        assert [told[BETTER][1:5], told[WORSE][1:5]] == [["1", "2", "6", "1"], ["2", "1", "6", "1"]]
        assert told[BETTER][7].startswith("−") and told[WORSE][7].startswith("+")
        section.locator("summary").press("Enter")
        most = section.locator("li").all_inner_texts()
        assert len(most) == 2 and all(TURNED in line for line in most)
        assert any(WORSE in line and "1.000 there" in line for line in most)
        section.locator("p a").first.click()
        assert page.url.startswith((home / "site/index.html").as_uri() + "#board-")


def test_each_policy_tells_of_the_other(browser: Browser, home: Path) -> None:
    with watched(browser, pages(home)["other-policy"]) as page:
        told = {
            row.split("\t")[0]: row.split("\t")
            for row in page.locator("section[id^=other-] tbody tr").all_inner_texts()
        }
        assert [told[name][1:3] for name in (WORSE, BETTER)] == [["1", "2"], ["2", "1"]]
