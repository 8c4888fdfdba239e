"""Reading published tasks: ``task.yaml`` of both settings, and the palette in a text-to-scene prompt."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from c4s.errors import BadInput
from c4s.protocol.settings import Setting
from c4s.records.suite import Budget
from catalog.proxy import PaletteEntry

KINDS = {"scene_generation", "scene_repair"}
LINE = re.compile(
    r"^- (?P<id>\S+) \| (?P<name>.+?) \| (?P<category>[^|]+?) \| "
    r"(?P<w>[\d.]+)x(?P<d>[\d.]+)x(?P<h>[\d.]+) m \| (?P<path>/\S+)$",
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
    found = sorted(folder.rglob("task.yaml"))
    if not found:
        raise BadInput(
            "no task.yaml at or below this folder",
            where=str(folder),
            todo="point to a folder in the published task layout",
        )
    return found


def read_task(path: Path) -> Task:
    """A task from its ``task.yaml``. ``BadInput`` names the file and what is wrong with it."""
    try:
        raw = yaml.safe_load(path.read_text(encoding="utf-8"))
    except (yaml.YAMLError, UnicodeDecodeError) as error:
        text = " ".join(str(error).split())
        raise BadInput(f"malformed task.yaml: {text[:160]}", where=str(path)) from None
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
    if not re.fullmatch(r"[A-Za-z0-9._-]+", case_id) or case_id.startswith("."):
        raise BadInput(f"malformed task.yaml: id {case_id!r} is not a plain name", where=str(path))
    bundles = [entry.get("verification_bundle") for entry in raw.get("verifiers") or [] if isinstance(entry, Mapping)]
    bundle = next((path.parent / name for name in bundles if name), None)
    plate = given.number("inputs.size_m") if kind == "scene_generation" else None
    packs = (raw.get("assets") or {}).get("packs") or []
    return Task(
        folder=path.parent,
        case_id=case_id,
        setting=setting,
        prompt=given.text("inputs.prompt"),
        start_map=given.text("inputs.init_map"),
        budget=Budget(
            tool_calls=int(given.number("inputs.budget.tool_calls")),
            wall_minutes=given.number("inputs.budget.wall_minutes"),
        ),
        plate_m=plate,
        bundle=bundle if bundle and bundle.is_file() else None,
        packs=tuple(map(str, packs)),
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

    def number(self, name: str) -> float:
        value = self._value(name)
        if isinstance(value, bool) or not isinstance(value, int | float) or not value > 0:
            raise BadInput(f"malformed task.yaml: field {name!r} is not a positive number", where=str(self.path))
        return float(value)


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
        if seen.setdefault(entry.id, entry.path) != entry.path:
            raise BadInput(f"palette id {entry.id!r} is used twice", where=str(task.folder / "task.yaml"))
    return entries
