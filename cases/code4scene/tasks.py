"""Reading published tasks: ``task.yaml`` of both settings, and the palette in a text-to-scene prompt."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c4s.errors import BadInput
from c4s.files import read_yaml
from c4s.names import file_in, name_fault, package_fault, path_fault
from c4s.protocol.settings import Setting
from c4s.records.suite import MOST_CALLS, MOST_MINUTES, Budget
from catalog.proxy import PaletteEntry

KINDS = {"scene_generation", "scene_repair"}
MOST_M = 100_000.0
"""Side of a plate, and of an asset."""
SIZE = r"[0-9]+(?:\.[0-9]+)?"
LINE = re.compile(
    r"^- (?P<id>\S+) \| (?P<name>.+?) \| (?P<category>[^|]+?) \| "
    rf"(?P<w>{SIZE})x(?P<d>{SIZE})x(?P<h>{SIZE}) m \| (?P<path>/\S+)$",
    re.MULTILINE,
)


@dataclass(frozen=True)
class Task:
    """A published task."""

    folder: Path
    case_id: str
    setting: Setting
    prompt: str
    start_map: str
    budget: Budget
    plate_m: float | None
    bundle: Path | None
    packs: tuple[str, ...]


def find_tasks(folder: Path) -> list[Path]:
    """Every ``task.yaml`` at or below a folder, in order; ``BadInput`` when there is none."""
    if not folder.is_dir():
        raise BadInput("no such folder", where=str(folder))
    found = [file_in(folder, path.relative_to(folder).as_posix()) for path in sorted(folder.rglob("task.yaml"))]
    if not found:
        raise BadInput(
            "no task.yaml at or below this folder",
            where=str(folder),
            todo="point to a folder in the published task layout",
        )
    return found


def read_task(path: Path) -> Task:
    """A task from its ``task.yaml``. ``BadInput`` names the file and what is wrong with it."""
    raw = read_yaml(path, what="task")
    if not isinstance(raw, Mapping):
        raise BadInput("malformed task.yaml: not a mapping", where=str(path))
    given = _Reader(raw, path)
    kind = given.text("kind")
    if kind not in KINDS:
        raise BadInput(f"malformed task.yaml: unknown kind {kind!r}", where=str(path))
    setting: Setting = "text-to-scene"
    if kind == "scene_repair":
        setting = "image-to-scene/indoor" if given.text("scene_environment") == "indoor" else "image-to-scene/outdoor"
    case_id = given.text("id")
    given.refuse("id", name_fault(case_id))
    start_map = given.text("inputs.init_map")
    given.refuse("inputs.init_map", package_fault(start_map))
    if not start_map.startswith("/Game/"):
        given.refuse("inputs.init_map", "a start map lies below /Game")
    plate = given.number("inputs.size_m", MOST_M) if kind == "scene_generation" else None
    packs = given.listed("assets", "packs")
    for pack in packs:
        given.refuse("assets.packs", name_fault(pack))
    return Task(
        folder=path.parent,
        case_id=case_id,
        setting=setting,
        prompt=given.text("inputs.prompt"),
        start_map=start_map,
        budget=Budget(
            tool_calls=given.whole("inputs.budget.tool_calls", MOST_CALLS),
            wall_minutes=given.number("inputs.budget.wall_minutes", MOST_MINUTES),
        ),
        plate_m=plate,
        bundle=given.bundle(),
        packs=packs,
    )


class _Reader:
    """Fields of a task by dotted name, with one clear line when one is missing or of the wrong kind."""

    def __init__(self, raw: Mapping[str, Any], path: Path) -> None:
        self.raw, self.path = raw, path

    def _value(self, name: str) -> Any:
        value: Any = self.raw
        for part in name.split("."):
            if not isinstance(value, Mapping) or value.get(part) is None:
                raise BadInput(f"malformed task.yaml: field {name!r} is missing", where=str(self.path))
            value = value[part]
        return value

    def text(self, name: str) -> str:
        value = self._value(name)
        if not isinstance(value, str) or not value.strip():
            raise BadInput(f"malformed task.yaml: field {name!r} is not text", where=str(self.path))
        return value

    def refuse(self, name: str, fault: str) -> None:
        """``BadInput`` where something is wrong with a field."""
        if fault:
            raise BadInput(f"malformed task.yaml: field {name!r}: {fault}", where=str(self.path))

    def listed(self, group: str, name: str) -> tuple[str, ...]:
        """A list of texts that may be absent."""
        record = self.raw.get(group) or {}
        found = record.get(name) or [] if isinstance(record, Mapping) else None
        if not isinstance(found, list):
            raise BadInput(f"malformed task.yaml: field '{group}.{name}' is not a list", where=str(self.path))
        return tuple(map(str, found))

    def bundle(self) -> Path | None:
        """The requirement bundle that a verifier names, a file of the task's folder; None where there is none."""
        verifiers = self.raw.get("verifiers") or []
        entries = [one for one in verifiers if isinstance(one, Mapping)] if isinstance(verifiers, list) else []
        named = next((one["verification_bundle"] for one in entries if one.get("verification_bundle")), None)
        if named is None:
            return None
        if not isinstance(named, str):
            raise BadInput("malformed task.yaml: field 'verification_bundle' is not text", where=str(self.path))
        self.refuse("verification_bundle", path_fault(named))
        file = file_in(self.path.parent, named)
        return file if file.is_file() else None

    def number(self, name: str, most: float) -> float:
        value = self._value(name)
        if isinstance(value, bool) or not isinstance(value, int | float) or not 0 < value <= most:
            self.refuse(name, f"this is no positive number up to {most:,.0f}")
        return float(value)

    def whole(self, name: str, most: int) -> int:
        value = self.number(name, most)
        if value != int(value):
            self.refuse(name, "this is no whole number")
        return int(value)


def palette(task: Task) -> list[PaletteEntry]:
    """The palette lines of a text-to-scene prompt. ``BadInput`` when there is no palette, or a line cannot be read."""
    _, heading, rest = task.prompt.partition("=== ASSET PALETTE ===")
    section = rest.split("===")[0]
    entries = [
        PaletteEntry(
            id=m["id"],
            name=m["name"],
            category=m["category"],
            path=m["path"],
            size_m=(float(m["w"]), float(m["d"]), float(m["h"])),
        )
        for m in LINE.finditer(section)
    ]
    lines = [line for line in section.splitlines() if line.startswith("- ")]
    if not heading or not lines:
        raise BadInput("the prompt has no asset palette", where=str(task.folder / "task.yaml"))
    if len(entries) != len(lines):
        read = {entry.id for entry in entries}
        wrong = next(line for line in lines if line[2:].split(" |")[0] not in read)
        raise BadInput(f"palette line cannot be read: {wrong[:80]}", where=str(task.folder / "task.yaml"))
    seen: dict[str, str] = {}
    for entry in entries:
        size = f"it is larger than {MOST_M:,.0f} m" if max(entry.size_m) > MOST_M else None
        if fault := name_fault(entry.id) or package_fault(entry.path) or size:
            raise BadInput(f"palette line: {fault}", where=str(task.folder / "task.yaml"))
        if seen.setdefault(entry.id, entry.path) != entry.path:
            raise BadInput(f"palette id {entry.id!r} is used twice", where=str(task.folder / "task.yaml"))
    return entries
