"""What must never be (docs/design.md), read off the source tree. The exceptions stand in ``allowed``."""

from __future__ import annotations

import ast
import re
from collections import defaultdict
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import pytest

from tests.house import allowed
from tests.house.tree import Source, packages, source, sources

RUN_FILES = (
    *("outcome.json", "trajectory.jsonl", "usage.jsonl", "snapshot.json", "dependencies.json", "captures.json"),
    *("digests.json", "score.json", "stages.jsonl", "faults.jsonl", "manifest.json", "integrity.json", "plan.json"),
    *("spending.jsonl", "saves.jsonl", "contacts.json", "support.json", "submission.digests.json"),
)
RUN_FOLDERS = ("submission", "evidence", "verdicts")
BACKENDS = ("c4s.engine.headless", "c4s.engine.unreal")
FILE = re.compile(rf"(?<![\w.-])(?:{'|'.join(map(re.escape, RUN_FILES))})\b")
FOLDER = re.compile(rf"(?:^|/)({'|'.join(RUN_FOLDERS)})(?=/)")
SETTING = re.compile(r"text-to-scene|image-to-scene(?:/\w+)?")
VERIFIER = re.compile(r"(?:physics|repair|detailed|overview|integrity)")
BACKEND = re.compile(rf"\b(?:{'|'.join(map(re.escape, BACKENDS))})\b[\w.]*")
REMOVALS = ("rmtree", "removedirs", "rmdir")
MOST_FILE_LINES = 400
SAMPLE = "c4s/cli/sample.py"


def run_files(file: Source) -> set[str]:
    """Files and folders of a run folder that are spelt: a folder's name counts where a path is made of it."""
    joined = [
        part.value
        for node in file.nodes
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div)
        for part in (node.left, node.right)
        if isinstance(part, ast.Constant)
    ]
    return {found for text in file.strings for found in (*FILE.findall(text), *FOLDER.findall(text))} | {
        name for name in RUN_FOLDERS if name in joined
    }


def settings(file: Source) -> set[str]:
    """Names of settings that are spelt."""
    return {found for text in file.strings for found in SETTING.findall(text)}


def verifiers(file: Source) -> set[str]:
    """Names of verifiers that are spelt, each a string of its own."""
    quoted = file.strings if file.path.endswith(".py") else re.findall(r"""['"]([^'"\n]*)['"]""", file.text)
    return {text for text in quoted if VERIFIER.fullmatch(text)}


def backends(file: Source) -> set[str]:
    """Modules of a backend that are imported, or named in a string, outside ``open_engine``."""
    door = {
        id(node)
        for function in file.nodes
        if isinstance(function, ast.FunctionDef) and function.name == "open_engine"
        for node in ast.walk(function)
    }
    named = [
        name
        for node in file.nodes
        if id(node) not in door
        for name in (
            [alias.name for alias in node.names]
            if isinstance(node, ast.Import)
            else [node.module or "", *(f"{node.module}.{alias.name}" for alias in node.names)]
            if isinstance(node, ast.ImportFrom)
            else [node.value]
            if isinstance(node, ast.Constant) and isinstance(node.value, str)
            else []
        )
    ]
    modules = {found for name in named for found in BACKEND.findall(name)}
    return {name for name in modules if not any(other != name and name.startswith(f"{other}.") for other in modules)}


def removals(file: Source) -> set[str]:
    """Names by which a tree is removed or a folder moved, called, handed on or imported."""
    return {
        name
        for node in file.nodes
        for name in (
            [node.attr]
            if isinstance(node, ast.Attribute)
            else [alias.name for alias in node.names]
            if isinstance(node, ast.ImportFrom) and node.module in ("shutil", "os")
            else []
        )
        if name in REMOVALS
    }


def prints(file: Source) -> set[str]:
    """Ways to write to a terminal that are called."""
    called = [node.func for node in file.nodes if isinstance(node, ast.Call)]
    names = {
        one.id if isinstance(one, ast.Name) else one.attr for one in called if isinstance(one, ast.Name | ast.Attribute)
    }
    written = {ast.unparse(one) for one in called if isinstance(one, ast.Attribute)} & {
        "sys.stdout.write",
        "sys.stderr.write",
    }
    return names & {"print", "echo", "secho"} | written


def long_files(file: Source) -> set[str]:
    """The file as a whole, where it has too many lines."""
    return {"whole"} if len(file.text.splitlines()) > MOST_FILE_LINES else set()


@dataclass(frozen=True)
class Rule:
    """What no file may hold, but those within some paths."""

    find: Callable[[Source], set[str]]
    but: tuple[str, ...]
    allowed: dict[str, set[str]]
    sample: str
    """Python that breaks the rule."""
    told: set[str]
    """What is found in the sample."""


RULES = {
    "a file of a run folder is spelt in the records alone": Rule(
        run_files,
        ("c4s/records", "c4s/records/folder.py", "tests"),
        allowed.RUN_FILES,
        '"""plan.json"""\nroot / "evidence"\nb = f"{root}/attempt-1/outcome.json"\nc = "submission"\nd = "verdicts/"\n',
        {"evidence", "outcome.json", "verdicts"},
    ),
    "a setting is spelt in the protocol and the registry alone": Rule(
        settings,
        ("c4s/protocol", "c4s/verify/registry.py", "cases", "tests"),
        allowed.SETTINGS,
        'def f(s):\n    """For text-to-scene."""\n    return s.startswith("image-to-scene/")\n',
        {"image-to-scene"},
    ),
    "a verifier is spelt in verify and the protocol alone": Rule(
        verifiers,
        ("c4s/verify", "c4s/protocol", "tests"),
        allowed.VERIFIERS,
        'a = {"physics": 1, "physics of it": 2, "semantic": 3}\n',
        {"physics"},
    ),
    "a backend is imported in open_engine alone": Rule(
        backends,
        ("c4s/engine/base.py", "c4s/engine/headless", "c4s/engine/unreal", "tests"),
        allowed.BACKENDS,
        "def open_engine():\n    import c4s.engine.unreal\ndef f():\n    from c4s.engine import headless\n"
        "run('-m', 'c4s.engine.headless.process.main')\n",
        {"c4s.engine.headless"},
    ),
    "a tree is removed in one place": Rule(
        removals,
        ("c4s/folders.py", "tests"),
        allowed.REMOVALS,
        "import shutil\nfrom os import rmdir\natexit.register(shutil.rmtree, 1)\n",
        {"rmdir", "rmtree"},
    ),
    "the command line prints in one place": Rule(
        lambda file: prints(file) if file.within("c4s/cli") else set(),
        ("c4s/cli/output.py", "tests"),
        allowed.PRINTS,
        "print(1)\nconsole.print(2)\ntyper.echo(3)\nsys.stderr.write(4)\n",
        {"echo", "print", "sys.stderr.write"},
    ),
    "a file has at most 400 lines": Rule(long_files, (), allowed.FILES, "pass\n" * 401, {"whole"}),
}


def public_classes(files: Iterable[Source]) -> dict[str, set[str]]:
    """Names that more than one public class has, each with its files; the ``unreal`` module has names of its own."""
    found: dict[str, list[str]] = defaultdict(list)
    for file in files:
        if not file.within("c4s/engine/headless/unreal", "tests"):
            for node in file.nodes:
                if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                    found[node.name].append(file.path)
    return {name: set(paths) for name, paths in found.items() if len(paths) > 1}


@pytest.mark.parametrize("name", RULES)
def test_no_file_breaks_a_rule_but_those_that_are_listed(name: str) -> None:
    rule = RULES[name]
    found = {file.path: told for file in sources() if not file.within(*rule.but) for told in [rule.find(file)] if told}
    assert found == rule.allowed


@pytest.mark.parametrize("name", RULES)
def test_each_rule_sees_what_breaks_it(name: str) -> None:
    assert RULES[name].find(source(SAMPLE, RULES[name].sample)) == RULES[name].told


def test_no_two_public_classes_have_one_name_but_those_that_are_listed() -> None:
    assert public_classes(sources()) == {}
    twice = [source(f"c4s/{name}.py", "class Scene: ...\nclass _Own: ...") for name in "ab"]
    assert public_classes(twice) == {"Scene": {"c4s/a.py", "c4s/b.py"}}


def test_no_two_test_modules_have_one_name() -> None:
    """pytest takes the second for the first and collects none of it."""
    modules = [file.path for file in sources() if file.within("tests") and re.search(r"/test_[^/]*\.py$", file.path)]
    names = [path.rsplit("/", 1)[1] for path in modules]
    assert len(names) > 300 and sorted(names) == sorted(set(names))


def test_the_whole_tree_is_read() -> None:
    assert {"bench", "c4s", "cases", "catalog", "flows", "reports", "tasks", "tests", "warehouse"} <= set(packages())
    assert {file.path.split("/")[0] for file in sources()} == set(packages())
