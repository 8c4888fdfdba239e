"""A built suite in numbers, as the paper tells them of its own (``app:case-construction-details``)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from c4s.files import read_json
from c4s.protocol.settings import is_construction
from c4s.records.level import Level
from c4s.records.suite import SELECTION, AgentCase, SuiteFolder, WithheldCase
from cases.workshop.document import SelectionFile

GROUPS = ("Restore", "Lifecycle", "Layout", "Symmetry", "Transform")
TIERS = ("easy", "medium", "hard")


@dataclass(frozen=True)
class Range:
    """Smallest, middle and largest of some numbers, and their mean."""

    least: float
    median: float
    most: float
    mean: float


@dataclass
class SettingStatistics:
    """Numbers of the cases of one setting. What a setting has not is empty."""

    setting: str
    cases: int = 0
    public: int = 0
    scenes: int = 0
    actors: Range | None = None
    """Of the truth scenes."""
    palette: Range | None = None
    """Assets that a case offers."""
    plates_m: dict[str, int] = field(default_factory=dict)
    prompt_words: Range | None = None
    requirements: Range | None = None
    groups: dict[str, int] = field(default_factory=dict)
    tiers: dict[str, int] = field(default_factory=dict)
    chains: dict[str, int] = field(default_factory=dict)
    """Cases by how many changes were authored."""
    kinds: dict[str, int] = field(default_factory=dict)
    views: dict[str, int] = field(default_factory=dict)
    target_pixels: Range | None = None
    """Of 1280 x 720, in the view that shows a target best."""


def statistics(suite: SuiteFolder) -> list[SettingStatistics]:
    """Numbers of each setting that a suite has cases of, text-to-scene first."""
    record = suite.suite()
    seen = read_json(suite.sightings) if suite.sightings.is_file() else {}
    found: dict[str, list[tuple[str, AgentCase, WithheldCase]]] = {}
    for case in record.cases:
        rows = found.setdefault(case.setting, [])
        rows.append((case.case_id, suite.agent_case(case.alias), suite.withheld_case(case.case_id)))
    return [_of(suite, setting, found[setting], seen) for setting in sorted(found, key=lambda name: name[0] != "t")]


def held_slots(suite: SuiteFolder) -> dict[str, str]:
    """What the slots of a suite hold, as its selection file tells: a package, or the scene in its place."""
    place = suite.root / SELECTION
    return SelectionFile.parse(read_json(place), where=str(place)).slots if place.is_file() else {}


def _of(
    suite: SuiteFolder, setting: str, rows: Sequence[tuple[str, AgentCase, WithheldCase]], seen: dict[str, Any]
) -> SettingStatistics:
    withheld = [row for _, _, row in rows]
    scenes = {row.scene_id: case_id for case_id, _, row in rows}
    told = SettingStatistics(
        setting,
        cases=len(rows),
        public=sum(row.visibility == "public" for row in withheld),
        scenes=len(scenes),
        actors=_spread([len(Level.read(suite.withheld(one) / "truth.level.json").actors) for one in scenes.values()]),
        tiers=_counted([row.difficulty or "none" for row in withheld], TIERS),
    )
    if is_construction(rows[0][1].setting):
        told.palette = _spread([len(agent.catalog) for _, agent, _ in rows])
        told.plates_m = _counted([f"{agent.plate_m:g}" for _, agent, _ in rows if agent.plate_m])
        bundles = [read_json(suite.withheld(case_id) / "requirements.bundle.json") for case_id, _, _ in rows]
        told.requirements = _spread([len(bundle["requirements"]) for bundle in bundles])
        told.prompt_words = _spread([len(agent.prompt.split("===")[0].split()) for _, agent, _ in rows])
        return told
    told.groups = _counted([row.operation_group or "none" for row in withheld], GROUPS)
    told.chains = _counted([str(len(row.operations)) for row in withheld])
    told.kinds = _counted([kind for row in withheld for kind in row.operations])
    told.views = _counted([str(len(agent.reference_views)) for _, agent, _ in rows])
    told.target_pixels = _spread([one["pixels"] for case_id, _, _ in rows for one in seen.get(case_id, [])])
    return told


def _spread(values: Sequence[float]) -> Range | None:
    if not values:
        return None
    return Range(float(min(values)), float(np.median(values)), float(max(values)), float(np.mean(values)))


def _counted(values: Sequence[str], order: Sequence[str] = ()) -> dict[str, int]:
    count = Counter(values)
    first = [name for name in order if name in count]
    rest = sorted(
        set(count) - set(first), key=lambda name: (not name.isdigit(), int(name) if name.isdigit() else 0, name)
    )
    return {name: count[name] for name in [*first, *rest]}
