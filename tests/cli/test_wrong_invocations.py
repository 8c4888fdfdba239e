"""Every wrong invocation of the tables in ``wrong/``: one line, an exit code, and nothing changed."""

from __future__ import annotations

import shlex
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml

from c4s.cli.main import command
from tests.cli.contract import faults_of_line
from tests.cli.warm import Warm
from tests.cli.world import ALIAS, damaged, listing

TABLES = sorted(Path(__file__).parent.glob("wrong/*.yaml"))
LEAST_ROWS = 300
Row = dict[str, Any]


def _rows() -> list[Row]:
    """All rows: ``c4s`` the arguments as in a shell, ``says`` what the line must name.

    What differs from a plain call: ``exit``; ``env`` (null: unset); ``home``, files that are damaged (see
    ``world.damaged``); ``lists``, where what was found is listed on standard output; ``rebuilds``, where rows and
    pages of what is whole are made again, and only they.

    ``{bad}`` is the folder of garbage, ``{home}`` the home, ``{world}`` what lies beside it, ``{out}`` an empty
    folder, ``{bytes}`` a byte that is no UTF-8, ``{alias}`` the case as an agent knows it.
    """
    return [row for table in TABLES for row in yaml.safe_load(table.read_text())]


def _commands(tree: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Any]]:
    """Every command that is no group, with its path."""
    if hasattr(tree, "commands"):
        for name, inner in tree.commands.items():
            yield from _commands(inner, (*path, name))
    else:
        yield path, tree


ROWS = _rows()


@pytest.mark.parametrize("row", ROWS, ids=[row["c4s"][:100] or "nothing" for row in ROWS])
def test_one_line_an_exit_code_and_nothing_changed(
    row: Row, warm: Warm, world: Path, garbage: Path, tmp_path: Path
) -> None:
    home = world / "home"
    if "home" in row:
        home = damaged(home, tmp_path / "home", row["home"])
    out = tmp_path / "out"
    out.mkdir()

    def filled(text: str) -> str:
        named = {"bad": garbage, "home": home, "world": world, "out": out, "bytes": "\udcff", "alias": ALIAS}
        for name, value in named.items():
            text = text.replace(f"{{{name}}}", str(value))
        return text

    environment = {"C4S_HOME": str(home)}
    environment |= {name: value if value is None else filled(value) for name, value in row.get("env", {}).items()}
    before = listing(home)
    done = warm.call([filled(word) for word in shlex.split(row["c4s"])], cwd=out, environment=environment)
    changed = {name for name, _ in set(before.items()) ^ set(listing(home).items())}
    faults = faults_of_line(done, lists=row.get("lists", False) or row.get("rebuilds", False))
    if done.code != row.get("exit", 2):
        faults.append(f"it ended with {done.code}")
    if filled(str(row["says"])) not in done.err:
        faults.append(f"the line does not say {row['says']!r}")
    if row.get("rebuilds"):
        changed = {name for name in changed if not name.startswith(("site/", "warehouse/"))}
    if changed:
        faults.append(f"it changed {sorted(changed)}")
        shutil.rmtree(tmp_path / "home", ignore_errors=True)
    if made := sorted(path.name for path in out.rglob("*")):
        faults.append(f"it made {made}")
    assert not faults, f"{'; '.join(faults)}: {done.out[:300]}{done.err[-1500:]}"


def test_every_command_and_option_has_rows() -> None:
    calls = [shlex.split(row["c4s"]) for row in ROWS]
    assert len(ROWS) >= LEAST_ROWS
    assert len({(row["c4s"], str(row.get("home")), str(row.get("env"))) for row in ROWS}) == len(ROWS)
    for path, found in _commands(command()):
        of_command = [call for call in calls if tuple(call[: len(path)]) == path]
        assert len(of_command) >= 4, path
        words = {word.partition("=")[0] for call in of_command for word in call}
        for parameter in found.params:
            if parameter.param_type_name == "option" and parameter.name != "help":
                assert words & {*parameter.opts, *parameter.secondary_opts}, (path, parameter.name)
