"""Which pages there are, in the order of the navigation."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Final

ROOT: Final = Path(__file__).resolve().parents[1]
SECTIONS: Final[tuple[tuple[str, tuple[str, ...]], ...]] = (
    ("Start", ("README.md", "docs/installation.md", "docs/userlands.md")),
    (
        "Tutorials",
        (
            "docs/tutorials/agent-builder.md",
            "docs/tutorials/operator.md",
            "docs/tutorials/analyst.md",
            "docs/tutorials/case-author.md",
        ),
    ),
    ("Agents", ("docs/agents.md", "docs/sandbox.md")),
    ("Running", ("docs/operations.md", "docs/scale.md", "docs/faults.md", "docs/unreal.md", "docs/limits.md")),
    (
        "How the numbers are made",
        (
            "docs/scoring.md",
            "docs/statistics.md",
            "docs/rule-judge.md",
            "docs/judge.md",
            "docs/human-study.md",
            "docs/embodied-utility.md",
            "docs/cheats.md",
            "docs/reproduction.md",
        ),
    ),
    (
        "Cases and content",
        (
            "docs/authors.md",
            "docs/requirements.md",
            "docs/packs.md",
            "docs/content.md",
            "docs/published-tasks.md",
            "docs/open-190.md",
            "docs/open-190-texts.md",
        ),
    ),
    (
        "Coming from",
        ("docs/from-inspect.md", "docs/from-harbor.md", "docs/from-published-scorer.md", "docs/published-scorer.md"),
    ),
    (
        "Reference",
        ("reference/commands.md", "docs/tools.md", "docs/warehouse.md", "reference/formats.md", "docs/versions.md"),
    ),
    ("How it is built", ("docs/design.md", "CONTRIBUTING.md")),
)
"""Titles, and for each page its Markdown by its path in the checkout; ``reference/`` is made from the code. The
design pages beside the code follow."""


@dataclass(frozen=True)
class ManualPage:
    """A page: where its Markdown lies or would lie, and where its HTML goes, both from the root."""

    source: str
    section: str

    @property
    def target(self) -> str:
        """Path of the HTML below the site's folder."""
        return "index.html" if self.source == "README.md" else self.source.removesuffix(".md").lower() + ".html"


def pages() -> list[ManualPage]:
    """All pages, in order."""
    listed = [ManualPage(source, title) for title, sources in SECTIONS for source in sources]
    return listed + [ManualPage(source, SECTIONS[-1][0]) for source in design_pages()]


def design_pages() -> list[str]:
    """The design pages that lie beside the code."""
    packages = (path.parent for path in ROOT.glob("[!.]*/__init__.py"))
    return sorted(path.relative_to(ROOT).as_posix() for package in packages for path in package.rglob("DESIGN.md"))
