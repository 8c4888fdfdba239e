"""Builds the suite ``open-190``: packs, then units (a text, or one half of a source scene), then all of it.

What is built stays: each unit lies under ``C4S_HOME/cache/open-190`` with the digest of all that it depends on, so a
build that was killed goes on where it was, and a change of one scene builds that scene anew. The suite is put together
by links, and what is equal in two cases (the original of a scene) is stored once.

``python -m cases.open190.suite [scene ...]`` builds the units of some scenes alone.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Collection, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, Final

from c4s.files import digest, digest_file, read_json, write_json
from c4s.folders import beside, put_folder
from c4s.home import cache_root, packs_root
from c4s.packs.check import pack_changes
from c4s.records.pack import MANIFEST, Pack
from c4s.records.pack import STAMP as PACK_STAMP
from c4s.records.suite import SELECTION, SUITE, PackRef, Suite, SuiteFolder, Visibility
from cases.definition import BUILDER_VERSION
from cases.losses import told, truth_losses
from cases.model import SuiteDefinition
from cases.open190.brought import AnyPlace, BroughtPlace
from cases.open190.build import source_scene, sources
from cases.open190.layout import StagedPlace
from cases.open190.prompts import text_case
from cases.open190.repairs.plan import NESTED, PUBLIC_SEED, Environment, WantedRepair, planned, planned_texts
from cases.open190.repairs.unit import DRAWING_VERSION, UNIT, UnitBuilder
from cases.open190.scenes import SceneSpec
from cases.open190.secret import private_seed
from cases.open190.slots import AnySpec, BroughtSpec, chosen, held
from cases.open190.slots import told as slots_told
from cases.open190.words import WORDS
from cases.settle import to_build
from cases.sharing import link_tree
from cases.stamp import STAMP
from cases.suite import build_suite
from cases.workshop.document import SelectionFile, SelectionSet
from catalog.build import build_pack

SUITE_ID: Final = "open-190"
TITLE: Final = "Open 190"
DESCRIPTION: Final = "Texts and repairs of 50 places made by kits, with the counts of the paper's suite."
AT_ONCE: Final = 2
Progress = Callable[[str], None]
Done = Callable[[int, int], None]
"""Called with how many units are there, and how many there will be."""


@dataclass(frozen=True)
class UnitPlan:
    """A unit before it is built."""

    spec: AnySpec
    visibility: Visibility
    seed: str
    wanted: tuple[WantedRepair, ...] = ()
    """Its repairs; none of a text."""
    nested: int = 0
    """The smallest nested set that a text is in."""

    @property
    def name(self) -> str:
        """What its folder is called."""
        return f"{self.spec.scene_id}-{self.visibility}"


def unit_plans(private: str | None, scenes: Collection[str] = ()) -> list[UnitPlan]:
    """The units of the suite, or of some of its scenes; those of the private half where its seed is given."""
    specs = chosen()
    rooms: dict[Environment, list[str]] = {
        kind: [name for name, spec in specs.items() if spec.kind == kind] for kind in ("indoor", "outdoor")
    }
    texts = [name for name, spec in specs.items() if spec.kind == "text"]
    plans = []
    halves: list[tuple[Visibility, str]] = [("public", PUBLIC_SEED)]
    if private is not None:
        halves.append(("private", private))
    for visibility, seed in halves:
        repairs = planned(rooms, visibility, seed)
        for name in [*rooms["indoor"], *rooms["outdoor"]]:
            mine = tuple(one for one in repairs if one.scene_id == name)
            plans.append(UnitPlan(specs[name], visibility, seed, mine))
        plans += [
            UnitPlan(specs[name], visibility, seed, nested=nested)
            for name, (half, nested) in planned_texts(texts).items()
            if half == visibility
        ]
    return [plan for plan in plans if not scenes or plan.spec.scene_id in scenes]


class _Places:
    """Places, each laid out once while it is needed."""

    def __init__(self, packs: Path, progress: Progress, replace: bool) -> None:
        self._packs, self._progress, self._replace = packs, progress, replace
        self._sources = sources()
        self._laid: dict[str, StagedPlace] = {}
        self._brought: dict[str, BroughtPlace] = {}

    def of(self, spec: SceneSpec) -> StagedPlace:
        """The place of a scene that is laid out."""
        if spec.scene_id not in self._laid:
            self._laid[spec.scene_id] = spec.place()
        return self._laid[spec.scene_id]

    def brought(self, spec: BroughtSpec) -> BroughtPlace:
        """The place of a scene that was imported."""
        if spec.scene_id not in self._brought:
            self._brought[spec.scene_id] = spec.place(self._packs)
        return self._brought[spec.scene_id]

    def any(self, spec: AnySpec) -> AnyPlace:
        """The place of a scene."""
        return self.brought(spec) if isinstance(spec, BroughtSpec) else self.of(spec)

    def forget(self, spec: AnySpec) -> None:
        """It is needed no more."""
        self._laid.pop(spec.scene_id, None)
        self._brought.pop(spec.scene_id, None)

    def sources(self, spec: AnySpec) -> str:
        """Digest of all that decides what a scene is."""
        return spec.sources() if isinstance(spec, BroughtSpec) else self._sources

    def pack(self, spec: AnySpec) -> Pack:
        """The pack of a scene, built unless these sources built the one that is there."""
        if isinstance(spec, BroughtSpec):
            self._progress(f"pack open-{spec.scene_id}: {spec.slot.package} {spec.slot.version}")
            return spec.bring(self._packs, replace=self._replace)
        folder = self._packs / f"open-{spec.scene_id}"
        stamp = folder / PACK_STAMP
        ours = (folder / MANIFEST).is_file() and stamp.is_file() and read_json(stamp).get("sources") == self._sources
        if ours and not (self._replace and pack_changes(folder)):
            return Pack.read(folder / MANIFEST)
        self._progress(f"pack open-{spec.scene_id}")
        place = self.of(spec)
        pack = build_pack(place.assortment.pack(place.pack_id, spec.title), self._packs, replace=self._replace)
        write_json(stamp, {"sources": self._sources})
        return pack


def build_units(
    plans: Sequence[UnitPlan],
    packs: Path,
    progress: Progress = print,
    done: Done = lambda _made, _all: None,
    *,
    replace: bool = False,
) -> list[Path]:
    """Build units that are not there as they should be; their folders in the order of the plans.

    ``packs``: where the packs lie; those that are not there are built, and another one that is there is replaced only
    with ``replace``.

    Raises:
        BadInput: a repair cannot be made, or a pack is not to be replaced.
        MachineryFault: the engine failed.
    """
    places, finished = _Places(packs, progress, replace), 0

    def build(mine: Sequence[UnitPlan]) -> list[Path]:
        nonlocal finished
        folders = []
        for plan in mine:
            folders.append(_unit(plan, places, packs, progress))
            finished += 1
            done(finished, len(plans))
        places.forget(mine[0].spec)
        return folders

    grouped: dict[str, list[UnitPlan]] = {}
    for plan in plans:
        grouped.setdefault(plan.spec.scene_id, []).append(plan)
    with ThreadPoolExecutor(AT_ONCE) as pool:
        running = [pool.submit(build, mine) for mine in grouped.values()]
    by_name = {folder.name: folder for one in running for folder in one.result()}
    return [by_name[plan.name] for plan in plans]


def _unit(plan: UnitPlan, places: _Places, packs: Path, progress: Progress) -> Path:
    out = cache_root() / SUITE_ID / plan.name
    pack = places.pack(plan.spec)
    dealt = [digest(plan.seed), [asdict(one) for one in plan.wanted]]
    made_by = [DRAWING_VERSION, BUILDER_VERSION]
    quick = digest([made_by, places.sources(plan.spec), pack.sha256(), dealt, _said(plan)])
    noted = read_json(out / UNIT) if (out / UNIT).is_file() else {}
    if noted.get("quick") == quick:
        return out
    place = places.any(plan.spec)
    whole = digest([made_by, place.level().plain(), _relations(place), pack.sha256(), dealt, _texts(plan, places)])
    if noted.get("whole") == whole:
        write_json(out / UNIT, {**noted, "quick": quick})
        return out
    with beside(out) as scratch:
        folder = scratch / "unit"
        if plan.wanted:
            folder.mkdir()
            made = UnitBuilder(place, plan.spec.title, plan.wanted, plan.seed, packs, progress).build(folder)
        else:
            progress(f"{plan.name}: a text")
            made = _text(plan, places, folder, packs, progress)
        write_json(folder / UNIT, {**made, "quick": quick, "whole": whole})
        put_folder(folder, out, marker=UNIT)
    return out


def _said(plan: UnitPlan) -> str:
    """What decides the prompt of a text; nothing of a repair."""
    own = [digest_file(Path(__file__).with_name(name)) for name in ("numerals.py", "prompts.py", "wording.py")]
    return "" if plan.wanted else digest([own, WORDS.get(plan.spec.scene_id, "")])


def _relations(place: AnyPlace) -> list[list[str]]:
    soft = place.soft if isinstance(place, BroughtPlace) else ()
    return [*([one.kind, one.subject, one.reference] for one in place.relations), *(["soft", name] for name in soft)]


def _texts(plan: UnitPlan, places: _Places) -> str:
    return "" if isinstance(plan.spec, BroughtSpec) or plan.wanted else repr(text_case(plan.spec, places.of(plan.spec)))


def _text(plan: UnitPlan, places: _Places, out: Path, packs: Path, progress: Progress) -> dict[str, Any]:
    """Build the case of a text into ``out``."""
    assert isinstance(plan.spec, SceneSpec)
    place = places.of(plan.spec)
    case = replace(text_case(plan.spec, place), visibility=plan.visibility)
    scene = source_scene(plan.spec, place)
    definition = SuiteDefinition(SUITE_ID, TITLE, DESCRIPTION, scene.packs, (scene,), (case,))
    build_suite(definition, out, packs, progress)
    return {"cases": {case.case_id: {"visibility": plan.visibility, "nested": plan.nested}}}


def build_open190(
    root: Path,
    packs: Path,
    progress: Progress = print,
    done: Done = lambda _made, _all: None,
    *,
    replace: bool = False,
    scenes: Collection[str] = (),
) -> Suite:
    """Build packs and units that are not there, then put the suite at ``root``; the same suite stays.

    Args:
        root: the suite's folder.
        packs: where the packs lie.
        progress: called with a line for each step.
        done: called after each unit.
        replace: put the suite in the place of another one, or of one that was changed; packs too.
        scenes: only cases of these; of all when empty.

    Raises:
        BadInput: a repair cannot be made, the private seed is no secret, or what lies there is not to be replaced.
        MachineryFault: the engine failed.
    """
    plans = unit_plans(private_seed(), scenes)
    for scene_id, line in slots_told().items():
        progress(f"slot {scene_id}: {line}")
    units = build_units(plans, packs, progress, done, replace=replace)
    notes = [read_json(unit / UNIT) for unit in units]
    wanted = digest([[unit.name, note["whole"]] for unit, note in zip(units, notes, strict=True)])
    same = (root / STAMP).is_file() and read_json(root / STAMP).get("definition") == wanted
    if not to_build(root, same=same, replace=replace):
        progress(f"suite {SUITE_ID}: already built")
        return SuiteFolder(root).suite()
    with beside(root) as scratch:
        folder = SuiteFolder(scratch / "suite")
        sighted: dict[str, Any] = {}
        for unit in units:
            for tree in ("agent", "withheld"):
                link_tree(unit / tree, folder.root / tree)
            sighted |= read_json(SuiteFolder(unit).sightings)
        names = sorted({f"open-{plan.spec.scene_id}" for plan in plans})
        references = [PackRef(pack_id=name, digest=Pack.read(packs / name / MANIFEST).sha256()) for name in names]
        suite = folder.freeze(SUITE_ID, TITLE, described([plan.spec for plan in plans]), references)
        losses = truth_losses(folder, packs, whole=sighted)
        for line in told(losses):
            progress(line)
        write_json(folder.root / STAMP, {"definition": wanted, "physics_of_truth": losses})
        write_json(folder.sightings, dict(sorted(sighted.items())))
        _selection(suite, notes, held(plan.spec for plan in plans)).write(folder.root / SELECTION)
        put_folder(folder.root, root, marker=SUITE)
    return suite


def described(specs: Collection[AnySpec]) -> str:
    """What the suite says of itself: which of its scenes people made, and where they come from."""
    brought = {spec.scene_id: spec.slot for spec in specs if isinstance(spec, BroughtSpec)}
    if not brought:
        return DESCRIPTION
    told = ", ".join(f"{name} from {slot.package} {slot.version}" for name, slot in brought.items())
    return DESCRIPTION.replace("of 50 places made by kits", f"of places made by kits, and by people ({told})")


def _selection(suite: Suite, notes: Sequence[dict[str, Any]], slots: dict[str, str]) -> SelectionFile:
    """Which cases are public, and the nested sets; chosen by the plan, so by no scores."""
    cases = {name: row for note in notes for name, row in note["cases"].items()}
    return SelectionFile(
        suite_id=suite.suite_id,
        suite_digest=suite.sha256(),
        pool={},
        sets=[
            SelectionSet(size=len(within), cases=within)
            for size in NESTED
            if (within := sorted(name for name, row in cases.items() if row["nested"] <= size))
        ],
        visibility={name: row["visibility"] for name, row in sorted(cases.items())},
        slots=slots,
    )


def main() -> None:
    """Command line of the builder of units."""
    parser = argparse.ArgumentParser(description="Build the units of open-190.")
    parser.add_argument("scenes", nargs="*", help="all when none is named")
    parser.add_argument("--out", type=Path, default=None, help="put a suite of these scenes there")
    options = parser.parse_args()
    if options.out is not None:
        build_open190(options.out, packs_root(), scenes=options.scenes)
        return
    build_units(unit_plans(private_seed(), options.scenes), packs_root())


if __name__ == "__main__":
    main()
