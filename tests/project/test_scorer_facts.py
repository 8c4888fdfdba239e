"""Every fact about the published scorer that is cited by number stands on its page, and the pages link to it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "published-scorer.md"
PLACES = ("c4s", "cases", "catalog", "warehouse", "reports", "tasks", "flows", "bench", "tests", "docs")
NUMBER = r"\d+(?:\.\d+)?"
CITED = re.compile(rf"scorer\s+facts?\s+({NUMBER}(?:(?:,\s+|\s+and\s+|\s+to\s+){NUMBER})*)")


def cited(text: str) -> Iterator[str]:
    """Numbers of the facts that a text cites; ``3 to 7`` is five of them."""
    for found in CITED.findall(text):
        for part in re.split(r",\s+|\s+and\s+", found):
            first, *last = re.split(r"\s+to\s+", part)
            yield from map(str, range(int(first), int(last[0]) + 1)) if last else [first]


@pytest.mark.parametrize(
    ("text", "numbers"),
    [
        ("(scorer fact 2.7)", ["2.7"]),
        ("scorer facts 2.6\nand 2.7; paper", ["2.6", "2.7"]),
        ("scorer facts 3 to 5.", ["3", "4", "5"]),
        ("scorer facts 3", ["3"]),
    ],
)
def test_citations_are_read(text: str, numbers: list[str]) -> None:
    assert list(cited(text)) == numbers


def test_every_cited_fact_has_its_heading() -> None:
    headings = set(re.findall(rf"^#+ ({NUMBER})\.? ", PAGE.read_text(), re.MULTILINE))
    found = {
        (str(path.relative_to(ROOT)), number)
        for place in PLACES
        for path in (ROOT / place).rglob("*")
        if path.suffix in (".py", ".md", ".sql", ".yaml") and path != Path(__file__).resolve()
        for number in cited(path.read_text())
    }
    assert len({number for _, number in found}) > 10
    assert [place for place in sorted(found) if place[1] not in headings] == []


@pytest.mark.parametrize("page", ["README.md", "CONTRIBUTING.md", "docs/scoring.md"])
def test_the_page_is_linked(page: str) -> None:
    assert "published-scorer.md" in (ROOT / page).read_text()
