"""A package has a face: what others may use of it, names or modules, is in its ``__all__``; the rest is its own."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from tests.house.tree import ROOT, Source, source, sources

ROOMS = {".".join(file.parent.relative_to(ROOT).parts) for file in ROOT.glob("c4s/*/**/__init__.py")}
OWN = "c4s.engine.headless.unreal"
"""The ``unreal`` module's own parts follow Unreal's names."""


def imported(file: Source) -> Iterator[str]:
    """What a file imports of c4s, each as a dotted path down to the name."""
    for node in file.nodes:
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("c4s"):
            yield from (f"{node.module}.{alias.name}" for alias in node.names)
        elif isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name.startswith("c4s."))


def crossed(path: str, target: str) -> Iterator[tuple[str, str]]:
    """Each room that an import enters from outside, and what it takes there."""
    home = path.removesuffix(".py").removesuffix("/__init__").replace("/", ".") + "."
    parts = target.split(".")
    for depth in range(2, len(parts)):
        room = ".".join(parts[:depth])
        if room in ROOMS and not home.startswith(f"{room}.") and not room.startswith(OWN):
            yield room, parts[depth]


def face(room: str) -> set[str]:
    """The names of a room's ``__all__``; none where it has none."""
    tree = ast.parse((ROOT / room.replace(".", "/") / "__init__.py").read_text())
    for node in tree.body:
        if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == "__all__":
            return set(ast.literal_eval(node.value))
    return set()


def test_no_room_is_entered_past_its_face() -> None:
    faces = {room: face(room) for room in ROOMS}
    entered = {
        (file.path, room, taken)
        for file in sources()
        if not file.within("tests", "bench", "manual")
        for target in imported(file)
        for room, taken in crossed(file.path, target)
    }
    assert len(entered) > 500
    assert {row for row in entered if row[2] not in faces[row[1]]} == set()


def test_a_face_shows_what_is_there() -> None:
    for room in ROOMS:
        folder = ROOT / room.replace(".", "/")
        tree = ast.parse((folder / "__init__.py").read_text())
        bound = {
            alias.asname or alias.name for node in tree.body if isinstance(node, ast.ImportFrom) for alias in node.names
        }
        bound |= {node.name for node in tree.body if isinstance(node, ast.FunctionDef | ast.ClassDef)}
        bound |= {str(getattr(n.targets[0], "id", "")) for n in tree.body if isinstance(n, ast.Assign)}
        modules = {path.stem for path in folder.glob("*.py")} | {
            path.parent.name for path in folder.glob("*/__init__.py")
        }
        assert face(room) <= bound | modules, room


def test_an_entry_past_a_face_is_seen() -> None:
    file = source("catalog/sample.py", "from c4s.verify.repair.counts import count\n")
    assert [*crossed(file.path, next(imported(file)))] == [("c4s.verify", "repair"), ("c4s.verify.repair", "counts")]
    assert "counts" not in face("c4s.verify.repair")
