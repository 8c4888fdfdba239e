"""Building a site again: what nothing has changed in stays, what something has is written."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from bench.made_warehouse import MadeWarehouse
from c4s.protocol.settings import INDOOR_REPAIR, SETTINGS
from reports.site import build_site
from reports.site.ledger import ledger_of
from tests.reports.made_site import relabel
from warehouse.database import rebuild


def written(site: Path) -> dict[str, int]:
    """Each page, and which file it is."""
    return {str(path.relative_to(site)): path.stat().st_ino for path in site.rglob("*.html")}


def test_a_second_build_writes_what_changed(tmp_path: Path) -> None:
    made = MadeWarehouse(tmp_path / "warehouse", (0.7, 0.5), shape=((SETTINGS[0], 4, 4), (INDOOR_REPAIR, 4, 4)))
    made.write()
    build_site(made.root, tmp_path / "site")
    first = written(tmp_path / "site")
    build_site(made.root, tmp_path / "site")
    assert written(tmp_path / "site") == first
    relabel(made.root, "title", "indoor-02", "A dark hall")
    rebuild(made.root)
    build_site(made.root, tmp_path / "site")
    again = written(tmp_path / "site")
    others = {name for name, file in again.items() if file != first[name] and name.startswith("cases/")}
    assert len(others) == 1 and "A dark hall" in (tmp_path / "site" / others.pop()).read_text()
    assert again["index.html"] != first["index.html"]


def test_a_page_that_is_gone_is_written_again(tmp_path: Path) -> None:
    made = MadeWarehouse(tmp_path / "warehouse", (0.7, 0.5), shape=((SETTINGS[0], 3, 3),))
    made.write()
    page = build_site(made.root, tmp_path / "site")
    page.unlink()
    assert build_site(made.root, tmp_path / "site").is_file()


def test_what_a_page_shows_and_is_gone_is_written_again(tmp_path: Path) -> None:
    made = MadeWarehouse(tmp_path / "warehouse", (0.7, 0.5), shape=((SETTINGS[0], 3, 3),))
    made.write()
    site = build_site(made.root, tmp_path / "site").parent
    shown = {name for page in (ledger_of(site) or pytest.fail("no ledger")).pages.values() for name in page.files}
    shown |= {f"static/{path.name}" for path in (site / "static").glob("*.css")}
    assert len(shown) > 5
    for name in shown:
        (site / name).unlink()
    build_site(made.root, site)
    assert all((site / name).is_file() for name in shown)


def test_more_trials_move_no_page(tmp_path: Path) -> None:
    """Addresses that others wrote down stay: a build with another agent and more repeats has every page of before."""
    shape = ((SETTINGS[0], 3, 3), (INDOOR_REPAIR, 3, 3))
    MadeWarehouse(tmp_path / "warehouse", (0.6, 0.5), shape=shape).write()
    site = build_site(tmp_path / "warehouse", tmp_path / "site").parent
    before, anchors = set(written(site)), anchors_of(site)
    MadeWarehouse(tmp_path / "warehouse", (0.6, 0.5, 0.9), shape=shape, repeats=2).write()
    build_site(tmp_path / "warehouse", site)
    assert before < set(written(site))
    assert all(anchors[name] <= anchors_of(site)[name] for name in before)


def anchors_of(site: Path) -> dict[str, set[str]]:
    """What a link to each page may name after its ``#``."""
    return {
        str(path.relative_to(site)): set(re.findall(r' id="([^"]+)"', path.read_text()))
        for path in site.rglob("*.html")
    }
