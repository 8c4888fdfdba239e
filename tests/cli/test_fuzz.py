"""Calls that nobody wrote down: options and arguments of the real command tree, files that were whole once.

``C4S_FUZZ_EXAMPLES=5000`` looks at so many calls, others each time; without it the same few in every run.
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from c4s.cli.main import command
from tests.cli.contract import MUST_NOT_SAY, faults_of_line
from tests.cli.warm import HUNG, Warm
from tests.cli.world import ALIAS
from warehouse.database import rebuild

EXAMPLES = int(os.environ.get("C4S_FUZZ_EXAMPLES", "0"))
LISTING = (["suite", "check"], ["suite", "list"], ["catalog", "list"])
"""Calls that show what they found beside what they refuse."""
USUAL_EXAMPLES = 60
CHANGED = "changed"
"""Where the copy lies that is changed: the views of a warehouse name their place."""
TRIAL = f"home/runs/yard/noop/{ALIAS}/r1"
DOCUMENTS = (
    *(
        "home/suites/yard/suite.json",
        f"home/suites/yard/agent/{ALIAS}/case.json",
        "home/suites/yard/withheld/yard/case.json",
    ),
    *(
        f"home/suites/yard/agent/{ALIAS}/start.level.json",
        "home/suites/yard/digests.json",
        f"home/packs/proxy-{ALIAS}/pack.json",
    ),
    *("home/runs/yard/plan.json", f"{TRIAL}/score.json", f"{TRIAL}/stages.jsonl", f"{TRIAL}/verdicts/integrity.json"),
    *(f"{TRIAL}/attempt-1/outcome.json", f"{TRIAL}/attempt-1/manifest.json", f"{TRIAL}/attempt-1/trajectory.jsonl"),
    *(
        f"{TRIAL}/attempt-1/usage.jsonl",
        f"{TRIAL}/evidence/snapshot.json",
        "bundle/bundle.json",
        "tasks/yard/task.yaml",
    ),
    *("agent.yaml", "policy.yaml", "recipe.json", "scene.csv", "rows.jsonl", "scene.json", "home/warehouse/c4s.duckdb"),
)
"""What is read somewhere; each example changes one of them."""
OWN = {
    "agent.yaml": '{"name": "mine", "client": "random", "model": null, "options": {"seed": 3}}',
    "policy.yaml": '{"policy_id": "mine", "families": {"existence": 0.25}, "repair_tolerances": "strict"}',
    "recipe.json": '{"operations": [{"kind": "move", "actor": "a"}]}',
    "scene.csv": "asset,x,y,z\nbox,1,2,3\n",
    "rows.jsonl": '{"name": "a", "kind": "physics_report", "input": {"report": {"status": "measured", "score": 1}}}\n',
    "scene.json": json.dumps(
        {
            "schema_version": "0.3.0",
            "units": "cm",
            "actors": [
                {
                    "stable_actor_id": "a",
                    "label": "A",
                    "class": "/Script/Engine.StaticMeshActor",
                    "transform": {"location_cm": [0.0, 0, 0], "rotation_deg": [0, 0, 0], "scale": [1, 1, 1]},
                    "bounds": {"origin_cm": [0, 0, 0], "extent_cm": [50, 50, 50]},
                }
            ],
        }
    ),
}
"""Files that a user writes, as JSON where that is YAML too."""
NAMES = ("yard", "noop", "starter", f"proxy-{ALIAS}", "leaderboard", "box", "headless", "rule", "repair-only", "x")
ODD_TEXTS = (
    "",
    " ",
    "..",
    "/",
    "-",
    "--",
    "nosuch",
    "a\nb",
    "\udcff",
    "\x1b[31m",
    "%s",
    "{}",
    "'",
    "*",
    "a" * 300,
    "é",
)
NUMBERS = ("0", "-1", "1", "2", "1e9", "nan", "inf", "-inf", "1.5", "99999999999999999999", "0x10", "١")
ODD_VALUES: tuple[Any, ...] = (
    *(None, True, 0, -1, 7, 1.5, 1e308, 2**63, 2**70, "", "x", "../x", "a\u0000b", [], {}, [[]], [None], {"x": 1}),
    float("nan"),
)
READERS = (
    *("suite list", "suite show yard --json", "suite check yard", "catalog list", f"catalog show proxy-{ALIAS} --json"),
    *("catalog search box", "score yard --policy {root}/policy.yaml --json", "score yard", "sql leaderboard", "report"),
    *("report --from-runs", "bundle score {root}/bundle", "bundle pack yard noop yard {out}/b", "agent list"),
    *("run yard -a noop -c nosuch", "run yard -a {root}/agent.yaml -c nosuch", "score --batch {root}/rows.jsonl"),
    *("verify support --batch {root}/rows.jsonl", "verify repair --batch {root}/rows.jsonl"),
    *(
        "verify physics --snapshot {root}/scene.json",
        f"verify physics --snapshot {{root}}/{TRIAL}/evidence/snapshot.json",
    ),
    "verify repair --input {root}/scene.json --truth {root}/scene.json --candidate {root}/scene.json",
    f"engine export {{root}}/home/suites/yard/agent/{ALIAS}/start.level.json --glb {{out}}/n.glb",
    "suite import-scene {root}/scene.csv --id s",
    "suite import code4scene {root}/tasks/yard --id other",
    f"agent replay {{root}}/{TRIAL}/attempt-3",
)
"""Calls that are right, each of which reads some of these documents to its end."""
NEVER_DONE = {
    ("run",): ["-c", "nosuch"],
    ("demo",): ["extra"],
    ("agent", "try"): ["--engine", "nosuch"],
    ("judge", "check"): ["extra"],
    ("suite", "build"): ["extra"],
    ("engine", "conformance"): ["--only", "nosuch"],
}
"""What makes sure that a call for minutes of work is refused."""


def _commands(tree: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Any]]:
    if hasattr(tree, "commands"):
        for name, inner in tree.commands.items():
            yield from _commands(inner, (*path, name))
    else:
        yield path, tree


COMMANDS = sorted(_commands(command()), key=lambda found: found[0])
FILES = [f"{{root}}/{name}" for name in DOCUMENTS]
FOLDERS = ["{root}/home/suites/yard", "{root}/home/runs/yard", f"{{root}}/{TRIAL}/attempt-1", "{root}/bundle"]
FOLDERS += [
    "{root}/tasks/yard",
    f"{{root}}/home/packs/proxy-{ALIAS}",
    "{root}",
    "{out}/new",
    "{out}/new.csv",
    "{out}/new.glb",
]
VALUES = st.one_of(
    st.sampled_from(NAMES), st.sampled_from(FILES), st.sampled_from(FOLDERS), st.sampled_from(NUMBERS),
    st.sampled_from(ODD_TEXTS), st.text(st.characters(exclude_characters="\0"), max_size=8),
)  # fmt: skip


@st.composite
def _calls(draw: st.DrawFn) -> list[str]:
    path, chosen = draw(st.sampled_from(COMMANDS))
    words: list[str] = []
    for parameter in chosen.params:
        if parameter.param_type_name == "argument":
            words += [draw(VALUES)] if parameter.required or draw(st.booleans()) else []
        elif parameter.name != "help" and (parameter.required or draw(st.integers(0, 3)) == 0):
            words.append(draw(st.sampled_from([*parameter.opts, *parameter.secondary_opts])))
            words += [] if getattr(parameter, "is_flag", False) else [draw(VALUES)]
    if draw(st.integers(0, 9)) == 0:
        words.insert(draw(st.integers(0, len(words))), draw(VALUES))
    if path == ("agent", "replay"):
        words = [word.replace("attempt-1", "attempt-9") for word in words]
    return [*path, *words, *NEVER_DONE.get(path, [])]


def _places(value: Any, way: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    yield way
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        yield from _places(inner, (*way, key))


def _changed(draw: st.DrawFn, path: Path) -> bytes:
    """A document with one thing about it changed: bytes, or a value somewhere in it."""
    data = path.read_bytes()
    kind = draw(st.sampled_from(("value", "value", "value", "cut", "byte", "gone", "twice")))
    if kind == "cut":
        return data[: draw(st.integers(0, max(0, len(data) - 1)))]
    if kind == "byte" and data:
        place = draw(st.integers(0, len(data) - 1))
        return data[:place] + bytes([draw(st.integers(0, 255))]) + data[place + 1 :]
    if kind == "twice":
        return data + data
    try:
        value = json.loads(data)
    except ValueError:
        return b""
    way = draw(st.sampled_from(list(_places(value))[:400]))
    if not way:
        return json.dumps(draw(st.sampled_from(ODD_VALUES))).encode()
    inner = value
    for part in way[:-1]:
        inner = inner[part]
    if kind == "gone":
        del inner[way[-1]]
    else:
        inner[way[-1]] = draw(st.sampled_from(ODD_VALUES))
    return json.dumps(value).encode()


@st.composite
def _examples(draw: st.DrawFn, world: Path) -> tuple[list[str], str, bytes]:
    name = draw(st.sampled_from(DOCUMENTS))
    call = draw(st.sampled_from(READERS)).split() if draw(st.integers(0, 3)) else draw(_calls())
    return call, name, _changed(draw, world / name)


@pytest.fixture(scope="module")
def whole(world: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The world with the files that a user writes beside it."""
    root = tmp_path_factory.mktemp("fuzz") / "whole"
    shutil.copytree(world, root, symlinks=True)
    for name, text in OWN.items():
        (root / name).write_text(text)
    place = root.with_name(CHANGED)
    shutil.copytree(root, place, symlinks=True)
    shutil.copy(rebuild(place / "home/warehouse"), root / "home/warehouse")
    return root


def test_any_call_ends_with_a_code_and_a_line(warm: Warm, whole: Path) -> None:
    @settings(
        max_examples=EXAMPLES or USUAL_EXAMPLES,
        derandomize=not EXAMPLES,
        database=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
        print_blob=bool(EXAMPLES),
    )
    @given(_examples(whole))
    def property_(example: tuple[list[str], str, bytes]) -> None:
        call, name, content = example
        root, out = whole.with_name(CHANGED), whole.with_name("out")
        shutil.rmtree(out, ignore_errors=True)
        shutil.rmtree(root, ignore_errors=True)
        shutil.copytree(whole, root, symlinks=True)
        out.mkdir()
        (root / name).write_bytes(content)
        words = [word.replace("{root}", str(root)).replace("{out}", str(out)) for word in call]
        done = warm.call(words, cwd=out, environment={"C4S_HOME": str(root / "home")})
        said = [what for what, pattern in MUST_NOT_SAY.items() if pattern.search(done.err)]
        assert done.code in (0, 1, 2, 3) and done.code != HUNG, done
        assert not said, (said, done)
        faults = faults_of_line(done, lists=call[:2] in LISTING or call[0] == "report" or "--batch" in call)
        assert done.code != 2 or not faults, (faults, done)

    property_()
