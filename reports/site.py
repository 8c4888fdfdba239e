"""The static site: leaderboard, a page an agent, a page a case. Plain files, no script needed to read them."""

from __future__ import annotations

import shutil
from functools import cache
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from c4s.files import digest_bytes, write_bytes, write_text
from c4s.folders import beside, check_own, put_folder
from c4s.names import shown
from c4s.protocol.settings import SETTING_TITLES, is_construction
from c4s.verify.registry import VERIFIERS, headlines_of
from reports import data
from reports.text import number, percent, slug

HERE = Path(__file__).parent
FINDINGS_SHOWN = 60
MARKER = ".c4s-site"
"""In every folder of pages, so that no other folder is taken for one and replaced."""


def _visible(value: Any) -> Any:
    """What a page shows of a value: of a text nothing that turns its direction or cannot be seen."""
    return shown(value, keep="\n\t") if isinstance(value, str) and not isinstance(value, Markup) else value


@cache
def environment() -> Environment:
    """How pages are made of templates: what is shown is escaped, and has a filter a kind of number."""
    made = Environment(
        loader=PackageLoader("reports"),
        autoescape=True,
        finalize=_visible,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    made.filters.update(number=number, percent=percent, slug=slug)
    made.globals.update(
        setting_names=SETTING_TITLES, is_construction=is_construction, headlines=headlines_of, verifiers=VERIFIERS
    )
    return made


def check_place(site: Path) -> None:
    """``BadInput`` where something else lies than pages of c4s."""
    check_own(site, MARKER)


def build_site(warehouse: Path, site: Path) -> Path:
    """Render all pages from the warehouse; returns the leaderboard page. Old pages are replaced.

    ``BadInput`` where the folder holds something else than pages of c4s.
    """
    check_place(site)
    with beside(site) as scratch:
        _write_site(environment(), warehouse, scratch / site.name)
        put_folder(scratch / site.name, site, marker=MARKER)
    return site / "index.html"


def _write_site(environment: Environment, warehouse: Path, fresh: Path) -> None:
    (fresh / "static").mkdir(parents=True)
    write_text(fresh / MARKER, "Pages made by c4s: `c4s report` replaces this folder.\n")
    for path in (HERE / "static").iterdir():
        shutil.copy(path, fresh / "static" / path.name)
    boards = data.boards(warehouse)
    _page(environment, "leaderboard.html.j2", fresh / "index.html", root="", boards=boards)
    for suite in sorted({board.suite for board in boards}):
        _suite_pages(environment, warehouse, fresh, [board for board in boards if board.suite == suite])


def _suite_pages(environment: Environment, warehouse: Path, site: Path, boards: list[data.Board]) -> None:
    """The pages of a suite's latest build, which all ``boards`` are of."""
    suite = boards[0].suite
    pictures = _save_pictures(warehouse, site, boards[0])
    findings, verdicts = data.findings(warehouse, boards[0]), data.verdicts(warehouse, boards[0])
    for board in boards:
        for case in board.cases:
            shown = [
                {
                    "configuration": name,
                    "trial": trial,
                    "pictures": pictures.get((trial["trial_id"], case["case_id"], "submission"), []),
                    "findings": findings.get(trial["trial_id"], []),
                    "verdicts": verdicts.get(trial["trial_id"], []),
                }
                for name, trials in case["scores"].items()
                for trial in trials
            ]
            _page(
                environment,
                "case.html.j2",
                site / "cases" / f"{slug(suite)}--{slug(case['case_id'])}.html",
                root="../",
                board=board,
                case=case,
                shown=shown,
                limit=FINDINGS_SHOWN,
                prompt=data.prompt(warehouse, board, case["case_id"]),
                start=pictures.get(("", case["case_id"], "start"), []),
                truth=pictures.get(("", case["case_id"], "truth"), []),
            )
        for standing in board.standings:
            name = standing["configuration"]
            trials = [
                (case, trial, next(iter(pictures.get((trial["trial_id"], case["case_id"], "submission"), [])), None))
                for case in board.cases
                for trial in case["scores"].get(name, [])
            ]
            _page(
                environment,
                "agent.html.j2",
                site / "agents" / f"{slug(suite)}--{slug(name)}.html",
                root="../",
                board=board,
                standing=standing,
                trials=trials,
            )


def _save_pictures(warehouse: Path, site: Path, board: data.Board) -> dict[tuple[str, str, str], list[dict[str, Any]]]:
    """Write each picture once, named by its digest; by (trial, case, role); a case's own have no trial."""
    saved: dict[tuple[str, str, str], list[dict[str, Any]]] = {}
    for row in data.pictures(warehouse, board):
        name = f"pictures/{digest_bytes(row['jpeg'])[:20]}.jpg"
        if not (site / name).is_file():
            write_bytes(site / name, row["jpeg"])
        saved.setdefault((row["trial_id"], row["case_id"], row["role"]), []).append(
            {"file": name, "view": row["view"], "width": row["width"], "height": row["height"]}
        )
    return saved


def _page(environment: Environment, template: str, path: Path, **values: Any) -> None:
    write_text(path, environment.get_template(template).render(**values))
