"""What the site states besides results: what is measured and how, what that does not say, and where the data are."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any, Final

from c4s.protocol.criteria import SPLIT_SEED
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.version import code_version
from c4s.stats import bootstrap, human
from c4s.verify.registry import VERIFIERS
from reports.frame import SiteContext, SitePage, links
from reports.statements import CAVEATS, COVERAGE, RELATED, cheat_tables, manual_tables, put_downloads, weight_tables
from warehouse.analyses import STUDIES
from warehouse.manual import told_question
from warehouse.tables import questions

TITLES: Final[Mapping[str, str]] = {
    links.ABOUT: "What is measured",
    links.LIMITS: "Limits and impact",
    links.CHEATS: "Cheats",
    links.METHODS: "Intervals",
    links.RELATED: "Related benchmarks",
    links.DATA: "Data",
    links.RELEASE: "Release",
}
"""The statement pages, in the order in which they link to each other."""
NAVIGATION: Final[Mapping[str, str]] = {links.ABOUT: "About", links.DATA: "Data"}
"""Those that every page links to."""


def pages(site: SiteContext) -> Iterator[SitePage]:
    """A page a statement."""
    values: Mapping[str, Callable[[SiteContext], dict[str, Any]]] = {
        links.ABOUT: _about,
        links.LIMITS: lambda site: {"caveats": CAVEATS},
        links.CHEATS: lambda site: {"tables": cheat_tables(site.warehouse, site.boards)},
        links.METHODS: _methods,
        links.RELATED: lambda site: {"related": RELATED, "coverage": COVERAGE},
        links.DATA: _data,
        links.RELEASE: lambda site: {"version": code_version()},
    }
    for path, title in TITLES.items():
        yield SitePage(
            path=path,
            template=f"statements/{path}.j2",
            values=partial(_values, values[path], site, title),
            made_of=site.stamp(),
            navigation=NAVIGATION.get(path, ""),
        )


def _values(ask: Callable[[SiteContext], dict[str, Any]], site: SiteContext, title: str) -> dict[str, Any]:
    return {"title": title, "titles": TITLES, **ask(site)}


def _about(site: SiteContext) -> dict[str, Any]:
    return {
        "policies": weight_tables([DEFAULT_POLICY, *(board.policy for board in site.boards)]),
        "shown_verifiers": VERIFIERS.values(),
        "caveats": CAVEATS,
    }


def _methods(site: SiteContext) -> dict[str, Any]:
    return {
        "boards": [(board, site.answer(board, "main-results")) for board in site.boards],
        "studies": STUDIES.values(),
        "draws": bootstrap.DRAWS,
        "seed": bootstrap.SEED,
        "level": bootstrap.LEVEL,
        "least": bootstrap.LEAST_CLUSTERS,
        "modest": bootstrap.MODEST_CLUSTERS,
        "human_draws": human.DRAWS,
        "alpha_draws": human.ALPHA_DRAWS,
        "split_seed": SPLIT_SEED,
    }


def _data(site: SiteContext) -> dict[str, Any]:
    return {
        "tables": manual_tables(site.warehouse),
        "questions": {name: told_question(name) for name in questions()},
        "downloads": put_downloads(site),
    }
