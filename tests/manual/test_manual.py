"""The documentation's site: all of ``docs`` is in it, links lead somewhere, the search finds, no request leaves."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import pytest

from c4s.cli.main import command
from c4s.errors import BadInput
from manual import build
from manual.build import build_manual
from manual.contents import ROOT, pages
from manual.text import page_text
from tests.reports.watching import complaints, watched

if TYPE_CHECKING:
    from playwright.sync_api import Browser

LINK = re.compile(r"(?<!!)\]\((?![a-z]+:)([^)#\s]*)")


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of the site."""
    return build_manual(tmp_path_factory.mktemp("manual") / "site").parent


def test_every_document_is_a_page(site: Path) -> None:
    documents = {path.relative_to(ROOT).as_posix() for path in (ROOT / "docs").rglob("*.md")}
    assert documents - {page.source for page in pages()} == set()
    assert all((site / page.target).stat().st_size > 1000 for page in pages())


def test_every_link_of_a_document_leads_to_a_file() -> None:
    sources = [ROOT / page.source for page in pages() if (ROOT / page.source).is_file()]
    dead = [
        f"{path.relative_to(ROOT)}: {link}"
        for path in sources
        for link in LINK.findall(path.read_text(encoding="utf-8"))
        if link and not (path.parent / link).exists()
    ]
    assert len(sources) > 40 and dead == []


def test_a_heading_that_is_not_there_is_refused(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setitem(build.MADE, "README.md", lambda: "# A\n\n[to nothing](docs/scoring.md#no-such-heading)\n")
    with pytest.raises(BadInput, match=r"README.md to docs/scoring.html#no-such-heading"):
        build_manual(tmp_path / "site")
    assert not (tmp_path / "site").exists()


def test_another_folder_is_not_replaced(tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text("mine")
    with pytest.raises(BadInput):
        build_manual(tmp_path)
    assert (tmp_path / "mine.txt").read_text() == "mine"


def test_markup_in_a_text_is_text() -> None:
    page = page_text(
        "a.md", "# <b>bold</b>\n\n<script>alert(1)</script> [x](javascript:alert(1))\n", lambda _: None, lambda _: False
    )
    assert "<script" not in page.html and 'href="javascript' not in page.html and page.title == "<b>bold</b>"


def _leaves(path: tuple[str, ...], one: Any) -> Iterator[tuple[str, ...]]:
    inner = getattr(one, "commands", None)
    if inner is None:
        yield path
    for name, child in (inner or {}).items():
        yield from _leaves((*path, name), child)


def test_the_reference_has_every_command_and_format(site: Path) -> None:
    commands = (site / "reference" / "commands.html").read_text(encoding="utf-8")
    assert [path for path in _leaves(("c4s",), command()) if f">{' '.join(path)}</h2>" not in commands] == []
    formats = (site / "reference" / "formats.html").read_text(encoding="utf-8")
    names = [path.name.removesuffix(".schema.json") for path in (ROOT / "docs" / "schemas").glob("*.schema.json")]
    assert len(names) > 20 and [name for name in names if f">{name}</h2>" not in formats] == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize(
    "target", ["index.html", "docs/tutorials/analyst.html", "reference/commands.html", "docs/scoring.html"]
)
def test_anybody_can_read_it(browser: Browser, site: Path, target: str, scheme: Literal["light", "dark"]) -> None:
    with watched(browser, site / target, scheme=scheme) as page:
        assert complaints(page) == []


def test_the_search_finds_by_keyboard(browser: Browser, site: Path) -> None:
    with watched(browser, site / "docs" / "tutorials" / "analyst.html") as page:
        page.keyboard.press("/")
        page.keyboard.type("rebound-survivor")
        page.wait_for_selector("#found a mark")
        assert "Scoring" in page.inner_text("#found a >> nth=0")
        page.keyboard.press("Enter")
        page.wait_for_url("**/docs/scoring.html#advisories")
        page.fill("#search", "nosuchword <img src=x>")
        assert page.inner_text("#found") == "Nothing has all these words."
