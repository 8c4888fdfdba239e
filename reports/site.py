"""The static site: leaderboard, a page an agent, a page a case. Plain files, no script needed to read them."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined

from c4s.files import digest_bytes, write_bytes, write_text
from c4s.protocol.settings import SETTING_TITLES, is_construction
from c4s.verify.registry import VERIFIERS, headlines_of
from reports import data
from reports.text import number, percent, slug

HERE = Path(__file__).parent
FINDINGS_SHOWN = 60


def _environment() -> Environment:
    environment = Environment(
        loader=PackageLoader("reports"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters.update(number=number, percent=percent, slug=slug)
    environment.globals.update(
        setting_names=SETTING_TITLES, is_construction=is_construction, headlines=headlines_of, verifiers=VERIFIERS
    )
    return environment


def build_site(warehouse: Path, site: Path) -> Path:
    """Render all pages from the warehouse; returns the leaderboard page. Old pages are replaced."""
    environment = _environment()
    fresh = site.with_name(f".{site.name}.new")
    shutil.rmtree(fresh, ignore_errors=True)
    (fresh / "static").mkdir(parents=True)
    for path in (HERE / "static").iterdir():
        shutil.copy(path, fresh / "static" / path.name)
    boards = data.boards(warehouse)
    _page(environment, "leaderboard.html.j2", fresh / "index.html", root="", boards=boards)
    for suite in sorted({board.suite for board in boards}):
        _suite_pages(environment, warehouse, fresh, suite, [board for board in boards if board.suite == suite])
    old = site.with_name(f".{site.name}.old")
    shutil.rmtree(old, ignore_errors=True)
    if site.exists():
        site.rename(old)
    fresh.rename(site)
    shutil.rmtree(old, ignore_errors=True)
    return site / "index.html"


def _suite_pages(environment: Environment, warehouse: Path, site: Path, suite: str, boards: list[data.Board]) -> None:
    pictures = _save_pictures(warehouse, site, suite)
    findings, verdicts = data.findings(warehouse, suite), data.verdicts(warehouse, suite)
    for board in boards:
        for case in board.cases:
            shown = [
                {
                    "configuration": name,
                    "trial": trial,
                    "pictures": pictures.get((case["case_id"], name, trial["repeat"], "submission"), []),
                    "findings": findings.get((case["case_id"], name, trial["repeat"]), []),
                    "verdicts": verdicts.get((case["case_id"], name, trial["repeat"]), []),
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
                prompt=data.prompt(warehouse, suite, case["case_id"]),
                start=pictures.get((case["case_id"], "_case", 0, "start"), []),
                truth=pictures.get((case["case_id"], "_case", 0, "truth"), []),
            )
        for standing in board.standings:
            name = standing["configuration"]
            trials = [
                (
                    case,
                    trial,
                    next(iter(pictures.get((case["case_id"], name, trial["repeat"], "submission"), [])), None),
                )
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


def _save_pictures(warehouse: Path, site: Path, suite: str) -> dict[tuple[str, str, int, str], list[dict[str, Any]]]:
    """Write each picture once, named by its digest; by (case, configuration, repeat, role)."""
    saved: dict[tuple[str, str, int, str], list[dict[str, Any]]] = {}
    for row in data.pictures(warehouse, suite):
        name = f"pictures/{digest_bytes(row['jpeg'])[:20]}.jpg"
        if not (site / name).is_file():
            write_bytes(site / name, row["jpeg"])
        saved.setdefault((row["case_id"], row["configuration"], row["repeat"], row["role"]), []).append(
            {"file": name, "view": row["view"], "width": row["width"], "height": row["height"]}
        )
    return saved


def _page(environment: Environment, template: str, path: Path, **values: Any) -> None:
    write_text(path, environment.get_template(template).render(**values))
