"""The release bundle: what others need to check and repeat published numbers, by an allow-list, and nothing else.

::

    code/        sources of the packages, data files of known kinds beside them, the lock file of a checkout
    suites/      public cases of each suite, as `c4s suite export --public` writes them
    runs/        of each run: its configurations, judge, policy, engine and versions; nothing of its cases
    agents/      the skill text and the tools as agents are told them
    schemas/     JSON Schemas of the file formats
    judge/       instructions of the model judge, and judges that ship
    analyses/    answers of studies
    digests.json SHA-256 of every other file

Before it is put in its place it is looked through for what private cases hold and for keys of this environment.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path

import c4s
from c4s.errors import MachineryFault
from c4s.files import digest_file, write_json
from c4s.records.plan import Plan
from c4s.records.schemas import write_schemas
from c4s.records.suite import DIGESTS, SuiteFolder
from c4s.toolbox.skill import skill_text
from warehouse.release.leaks import refuse_leaks
from warehouse.release.secrets import PRIVATE, Secrets
from warehouse.release.words import pieces

PACKAGES = ("c4s", "cases", "catalog", "flows", "reports", "tasks", "warehouse")
CODE = frozenset({".py", ".sql", ".j2", ".css", ".js", ".yaml", ".json", ".md", ".txt", ".typed"})
"""Kinds of files of a package that are packed."""
BESIDE = ("requirements.lock", "requirements-run.lock", "pyproject.toml", "LICENSE", "README.md", "CHANGELOG.md")
ANSWERS = frozenset({".json", ".csv", ".svg", ".md", ".xlsx"})
"""Kinds of files of an analysis that are packed."""
LEAST_KEY = 12
"""Letters of a variable's value from which it is looked for as a key."""


def pack_release(
    folder: Path, *, runs: Mapping[str, Plan], analyses: Path, private: Iterable[SuiteFolder], secrets: Secrets
) -> dict[str, str]:
    """Fill a folder that holds ``suites/`` already, and look it through; the digest of every file.

    Args:
        folder: where the bundle is made.
        runs: plans by the id of their run.
        analyses: answers of studies; it need not be there.
        private: the suites, private cases included, whose names must stand nowhere.
        secrets: what private cases of the warehouse hold.

    ``MachineryFault`` where something that is private or a key stands in it.
    """
    root = Path(c4s.__file__).parents[1]
    for package in PACKAGES:
        _copy(root / package, folder / "code" / package, CODE)
    for name in BESIDE:
        if (root / name).is_file():
            shutil.copyfile(root / name, folder / "code" / name)
    for run, plan in runs.items():
        write_json(_place(folder / "runs" / f"{run}.json"), _of_run(plan))
    from c4s.toolbox.registry import ALL_TOOLS

    _place(folder / "agents" / "skill.md").write_text(skill_text(), encoding="utf-8")
    write_json(
        folder / "agents" / "tools.json",
        [{"name": tool.name, "description": tool.description, "arguments": tool.input_schema} for tool in ALL_TOOLS],
    )
    write_schemas(folder / "schemas")
    for source in ("model/prompts", "shipped"):
        _copy(root / "c4s/judge" / source, folder / "judge" / Path(source).name, CODE - {".py"})
    _copy(analyses, folder / "analyses", ANSWERS)
    digests = {
        path.relative_to(folder).as_posix(): digest_file(path) for path in sorted(folder.rglob("*")) if path.is_file()
    }
    write_json(folder / DIGESTS, digests)
    look_through(folder, private=private, secrets=secrets)
    return digests


def look_through(folder: Path, *, private: Iterable[SuiteFolder], secrets: Secrets) -> None:
    """``MachineryFault`` where something that is private, or a key of this environment, stands in a folder."""
    refuse_leaks(folder, _with_names(secrets, private))
    _refuse_keys(folder)


def _copy(source: Path, target: Path, kinds: frozenset[str]) -> None:
    """The plain files of some kinds below a folder; no links, and nothing compiled."""
    for path in sorted(source.rglob("*")):
        inside = path.relative_to(source)
        hidden = any(part.startswith(".") or part == "__pycache__" for part in inside.parts)
        if path.suffix in kinds and not hidden and path.is_file() and not path.is_symlink():
            shutil.copyfile(path, _place(target / inside))


def _place(path: Path) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    return path


def _of_run(plan: Plan) -> dict[str, object]:
    kept = ("run_id", "suite_id", "suite_digest", "configurations", "repeats", "policy", "judge", "judge_configuration")
    told = plan.plain()
    return {name: told[name] for name in (*kept, "judge_version", "engine", "versions")}


def _with_names(secrets: Secrets, suites: Iterable[SuiteFolder]) -> Secrets:
    """The secrets, and the names of private cases that no row of the warehouse has."""
    names: dict[str, str] = {}
    for suite in suites:
        for case in suite.suite().cases:
            if suite.withheld_case(case.case_id).visibility == PRIVATE:
                for text in (case.case_id, case.alias):
                    names |= dict.fromkeys(pieces(text), "case")
    return replace(secrets, pieces={**names, **secrets.pieces})


def _refuse_keys(folder: Path) -> None:
    keys = {
        name: value.encode()
        for name, value in os.environ.items()
        if name.endswith(("_KEY", "_TOKEN", "_SECRET", "_PASSWORD")) and len(value) >= LEAST_KEY
    }
    for path in sorted(folder.rglob("*")) if keys else ():
        data = path.read_bytes() if path.is_file() else b""
        for name, value in keys.items():
            if value in data:
                raise MachineryFault(
                    f"this would publish the value of {name}, which stands in {path.relative_to(folder).as_posix()}",
                    where=folder.name,
                    todo="nothing was written; take the key out of that file",
                )
