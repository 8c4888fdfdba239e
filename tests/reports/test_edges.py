"""Sites of warehouses at their edges: each has pages that say what is there and what is not."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from bench.made_warehouse import MadeWarehouse
from c4s.names import MOST_NAME
from c4s.protocol.settings import INDOOR_REPAIR, SETTINGS
from reports.site import build_site
from reports.text import counted, slug
from tests.reports.watching import watched

if TYPE_CHECKING:
    from playwright.sync_api import Browser

TEXT = SETTINGS[0]


class LongNames(MadeWarehouse):
    """Configurations whose names are as long as names may be."""

    def names(self) -> list[str]:
        """They differ in their last letter."""
        return [f"{'long-' * 40}"[: MOST_NAME - 1] + str(place) for place in range(len(self.abilities))]


def built(folder: Path, made: MadeWarehouse) -> Path:
    """The site of a warehouse."""
    made.write()
    return build_site(made.root, folder / "site").parent


def told(browser: Browser, site: Path, page: str) -> str:
    """What a page says, in a narrow window, in which nothing went wrong."""
    (path,) = site.glob(page)
    with watched(browser, path, width=390) as shown:
        assert shown.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
        return shown.inner_text("main")


@pytest.mark.parametrize(
    ("given", "index", "compare"),
    [
        pytest.param(
            {"abilities": (0.6,), "shape": ((TEXT, 1, 1),)},
            ["1 public case · 1 configuration", "of one task only", "No interval is given"],
            ["of 1 configuration here"],
            id="one trial",
        ),
        pytest.param(
            {
                "abilities": (0.6, 0.5),
                "shape": ((TEXT, 2, 2), (INDOOR_REPAIR, 2, 2)),
                "pending": frozenset({("agent-01", "text-to-scene-01"), ("agent-02", "indoor-01")}),
            },
            ["no configuration is complete", "3/4"],
            ["lacks outcomes"],
            id="pending trials",
        ),
        pytest.param(
            {
                "abilities": (0.6, 0.5),
                "shape": ((TEXT, 2, 2), (INDOOR_REPAIR, 2, 2)),
                "zeros": {
                    ("agent-02", case): "forbidden_asset"
                    for case in ("text-to-scene-01", "text-to-scene-02", "indoor-01", "indoor-02")
                },
            },
            ["forbidden asset", "text-to-scene-01, text-to-scene-02"],
            ["agent-01 is better on 4 of 4 cases"],
            id="nothing valid",
        ),
    ],
)
def test_a_site_says_what_is_there(
    browser: Browser, tmp_path: Path, given: dict[str, Any], index: Sequence[str], compare: Sequence[str]
) -> None:
    site = built(tmp_path, MadeWarehouse(tmp_path / "warehouse", documents=True, **given))
    for page, words in (("index.html", index), ("boards/*--compare--*", compare)):
        text = told(browser, site, page)
        assert [word for word in words if word not in text] == []
    assert told(browser, site, "boards/*--diagnostics--*")


def test_long_names_have_pages(browser: Browser, tmp_path: Path) -> None:
    made = LongNames(tmp_path / "warehouse", (0.6, 0.5), shape=((TEXT, 1, 1), (INDOOR_REPAIR, 1, 1)), documents=True)
    site = built(tmp_path, made)
    assert len(list((site / "agents").iterdir())) == 2 and len(list((site / "trials").iterdir())) == 4
    for page in ("index.html", "boards/*--compare--*", "boards/*--cases--*"):
        told(browser, site, page)


def test_a_file_name_fits_a_folder_and_is_of_one_name_alone() -> None:
    names = ["x" * 300 + end for end in "ab"] + ["ok", "o k", "o-k"]
    made = [slug(name) for name in names]
    assert len(set(made)) == len(names) and max(map(len, made)) < 160 and made[2] == "ok"


def test_one_is_no_plural() -> None:
    assert [counted(count, "case") for count in (0, 1, 2_000)] == ["0 cases", "1 case", "2,000 cases"]
