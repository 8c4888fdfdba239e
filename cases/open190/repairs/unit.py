"""A unit of the suite: the repairs of one half of one source scene, drawn, looked at and written.

A half of a scene has an original, names and ids of its own, all of them from its seed: who has the public half knows
nothing of where things stand in the private one. A unit's folder holds ``agent/`` and ``withheld/`` as a suite does,
``sightings.json`` and ``unit.json``, which is written last.
"""

from __future__ import annotations

import tempfile
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, Final

from c4s.errors import BadInput
from c4s.evidence import Tracer
from c4s.files import digest, read_json, write_json
from c4s.folders import remove_tree
from c4s.packs.store import PackStore
from c4s.records.level import Level, Vector
from c4s.records.pack import MANIFEST, Pack
from c4s.records.suite import SuiteFolder
from c4s.semantics.inventory import inventory
from c4s.semantics.sight import target_cameras
from cases import exports
from cases.admissible import (
    Glanced,
    Looked,
    Refusal,
    TargetSighting,
    looked_at,
    score_refusals,
    seen_by,
    sight_refusals,
    sightings,
)
from cases.applying import apply
from cases.audit import MOST_F1, audit_repair
from cases.boxes import boxes_of
from cases.checks import check_repair
from cases.corruption import with_identities
from cases.model import SourceScene
from cases.natural import NOT_PARTED, lived_in, rounded
from cases.open190.brought import AnyPlace, BroughtPlace
from cases.open190.repairs.changes import Changeable
from cases.open190.repairs.difficulty import Hardness, hardness
from cases.open190.repairs.drafts import RepairDraft, draft
from cases.open190.repairs.lookouts import Lookout, lookouts, traced
from cases.open190.repairs.plan import WantedRepair
from cases.packaging import CaseWriter, truth_package
from cases.recipe import Operation
from cases.sharing import share_equal
from cases.standing import settled
from cases.veil import Veil
from cases.views import camera, changed

UNIT: Final = "unit.json"
DRAWING_VERSION: Final = 2
"""Part of a unit's digest: raise it when the same plan is drawn into other repairs."""
DRAFTS, ROUNDS = 400, 24
"""Draws for one repair before a round gives up on it, and rounds; in each round every repair is drawn once."""
ORIGINALS: Final = 6
"""Where all rounds find nothing, the scene is left as people leave it in another way; so often at the most."""
FEWEST_VIEWS: Final = 6
"""Views that no other repair of the unit has are enough for one; where there are fewer, all are."""
Progress = Callable[[str], None]


class _NothingFound(BadInput):
    """A repair cannot be made in an original."""


@dataclass(frozen=True)
class Made:
    """A repair that passed: its draft, its levels under the veil, and its operations in their words."""

    draft: RepairDraft
    start: Level
    operations: list[Operation]


@dataclass
class UnitBuilder:
    """Builds the repairs of one half of a scene.

    Args:
        place: the scene as it is laid out.
        wanted: what its repairs are to be; all of one visibility.
        seed: of this half.
        packs: where the packs lie; that of the scene is there.
    """

    place: AnyPlace
    title: str
    wanted: Sequence[WantedRepair]
    seed: str
    packs: Path
    progress: Progress
    refused: Counter[str] = field(default_factory=Counter)
    """Why drafts were not taken, and how often."""

    def __post_init__(self) -> None:
        first = self.wanted[0]
        self.scene_id, self.environment = first.scene_id, first.environment
        self.folders = [self.packs / self.place.pack_id]
        self.pack = Pack.read(self.folders[0] / MANIFEST)
        self.boxes = boxes_of(self.pack.assets)
        self.store = PackStore(self.folders)
        self.veil = Veil(digest([self.seed, self.scene_id, first.visibility, self.place.level().plain()]))
        self.chance = self.veil.chance(f"{self.scene_id}|draws")

    def build(self, out: Path) -> dict[str, Any]:
        """Write the unit into ``out`` and return what is to be noted; ``BadInput`` where a repair cannot be made."""
        authored = rounded(with_identities(self.place.level(), self.scene_id)).model_copy(
            update={"package": truth_package(self.scene_id)}
        )
        self.progress(f"{self.name}: an original of {len(authored.actors)} actors")
        for number in range(1, ORIGINALS):
            drawn = self.scene_id if number == 1 else f"{self.scene_id}|{number}"
            try:
                return self._of_original(authored, drawn, out)
            except _NothingFound as error:
                self.progress(f"{self.name}: {error.what}; another original")
                remove_tree(out, inside=out.parent)
                out.mkdir()
        return self._of_original(authored, f"{self.scene_id}|{ORIGINALS}", out)

    def _of_original(self, authored: Level, drawn: str, out: Path) -> dict[str, Any]:
        """Write the unit of one way to leave the scene; ``drawn`` names the draws that leave it so."""
        brought = self.place if isinstance(self.place, BroughtPlace) else None
        parted, left_alone = (brought.parted, brought.left_alone) if brought else (NOT_PARTED, frozenset[str]())
        disturbed = lived_in(authored, self.boxes, self.veil.chance(drawn), parted=parted)
        with exports.bench(self.folders) as self._bench:
            original = settled(authored, disturbed, self._bench.snapshot)
            snapshot = self._bench.snapshot(original)
            scene = Changeable(
                original, self.scene_id, snapshot, self.boxes, self.store, self.place.relations, parted, left_alone
            )
            pool = lookouts(self.place, self.environment, scene.things, Tracer(snapshot, self.folders), self.chance)
            self.progress(f"{self.name}: {len(scene.things)} things to change, {len(pool)} views")
            if not pool:
                raise BadInput("no view of this scene shows anything to change", where=self.scene_id)
            self._original, self._scene, self._pool = original, scene, pool
            self._views: dict[str, list[Vector]] = {}
            self._veiled = self.veil.over(self.scene_id, original)
            self._truth = self._veiled.level(original)
            self._snapshot = self._bench.snapshot(self._truth)
            self._tracer = Tracer(self._snapshot, self.folders)
            return self._written(out)

    @property
    def name(self) -> str:
        """The unit in words."""
        return f"{self.scene_id} ({self.wanted[0].visibility})"

    def _written(self, out: Path) -> dict[str, Any]:
        folder = SuiteFolder(out)
        writer = CaseWriter(folder, {self.pack.pack_id: self.pack}, self.veil, {})
        source = SourceScene(self.scene_id, self.environment, self.title, self._original, (self.pack.pack_id,))
        seen, hard = dict[str, list[TargetSighting]](), dict[str, Hardness]()
        ready: dict[str, Made] = {}
        for number in range(ROUNDS):
            missing = [one for one in self.wanted if one.case_id not in ready and one.case_id not in seen]
            if missing:
                ready |= self._drawn(missing, number)
            if len(ready) + len(seen) == len(self.wanted):
                self._pictured(ready, writer, source, seen, hard)
                ready = {}
            if len(seen) == len(self.wanted):
                break
        else:
            left = [one for one in self.wanted if one.case_id not in seen]
            told = ", ".join(f"{reason} ({count})" for reason, count in self.refused.most_common(3))
            raise _NothingFound(
                f"no good repair found for {len(left)} of {len(self.wanted)}: {told}",
                where=", ".join(f"{one.case_id} {one.group} {one.chain} {one.tier}" for one in left),
            )
        write_json(folder.sightings, {name: list(map(asdict, rows)) for name, rows in sorted(seen.items())})
        share_equal(out / "withheld")
        return {
            "cases": {one.case_id: {**asdict(one), "difficulty": hard[one.case_id].plain()} for one in self.wanted},
            "refused": dict(self.refused.most_common()),
        }

    # drawing, and a first look without light

    def _drawn(self, wanted: Sequence[WantedRepair], number: int) -> dict[str, Made]:
        """One draft of each wanted repair that passes all but its pictures."""
        drafts: dict[str, Made] = {}
        for one in wanted:
            made = self._draft(one, number)
            if made is not None:
                drafts[one.case_id] = made
        if not drafts:
            return {}
        good = {}
        for case_id, made in drafts.items():
            refusal = self._glanced(made, self._bench.snapshot(made.start))
            if refusal is None:
                good[case_id] = made
            else:
                self.refused[refusal.kind] += 1
                self.progress(f"  {case_id}: {refusal.reason}")
        return good

    def _draft(self, wanted: WantedRepair, number: int) -> Made | None:
        chance = self.veil.chance(f"{wanted.case_id}|{number}")
        place = list(self.wanted).index(wanted)
        taken = {view for case_id, views in self._views.items() if case_id != wanted.case_id for view in views}
        pool = [one for one in self._pool if one.view.location_cm not in taken]
        pool = pool if len(pool) >= FEWEST_VIEWS else self._pool
        for attempt in range(DRAFTS):
            first = pool[(place + attempt + 5 * number) % len(pool)]
            made = draft(wanted, self._scene, pool, first, chance)
            if made is None or self._hardness(made, self._expected(made, first)).tier != wanted.tier:
                continue
            package = self.veil.start_map(wanted.case_id)
            corrupted = apply(self._original, made.case.operations, package)
            try:
                check_repair(made.case, made.case.operations, self._original, corrupted)
            except BadInput:
                self.refused["unreachable"] += 1
                continue
            self._views[wanted.case_id] = [view.location_cm for view in made.case.views]
            start = self._veiled.level(corrupted)
            operations = self.veil.operations(self.scene_id, made.case.operations, start)
            return Made(made, start, operations)
        self.refused["nothing to draw"] += 1
        return None

    def _glanced(self, made: Made, start: dict[str, Any]) -> Refusal | None:
        """Why a draft is no good, as far as can be told without its pictures."""
        case, truth = made.draft.case, self._snapshot
        after = Tracer(start, self.folders)
        looks = []
        for view in case.views:
            pictures = [seen_by(traced(tracer, view), tracer.names) for tracer in (self._tracer, after)]
            looks.append(Glanced(view.name, *pictures))
        seen = sightings(made.operations, self._truth, made.start, looks, {})
        for refusal in sight_refusals(case, made.operations, self._truth, made.start, truth, start, seen, {}):
            return refusal
        tier = self._hardness(made.draft, seen).tier
        if tier != case.difficulty:
            return Refusal(case.case_id, "seen", f"it is {tier} and not {case.difficulty}")
        for refusal in score_refusals(case.case_id, case.setting, truth, start, self.store, {}):
            return refusal
        way, f1 = audit_repair(case.case_id, made.start, start, truth, self.boxes).best
        if f1 > MOST_F1:
            return Refusal(case.case_id, "guessed", f"{way!r} repairs it without a look at a picture (F1 {f1:.2f})")
        return None

    def _expected(self, made: RepairDraft, first: Lookout) -> list[TargetSighting]:
        """How well the targets of a draft are likely to be seen."""
        return [TargetSighting(name, (), first.pixels[name], None, None) for name in made.targets]

    def _hardness(self, made: RepairDraft, seen: Sequence[TargetSighting]) -> Hardness:
        things = self._scene.things
        places = [things[name].origin for name in made.targets]
        return hardness(made.case.corruptions, places, made.related, seen)

    # pictures

    def _pictured(
        self,
        made: dict[str, Made],
        writer: CaseWriter,
        source: SourceScene,
        seen: dict[str, list[TargetSighting]],
        hard: dict[str, Hardness],
    ) -> None:
        """Take the pictures of drafts, and write those that pass."""
        with tempfile.TemporaryDirectory(prefix="c4s-unit-") as scratch:
            exported = self._exported(made, Path(scratch))
            for case_id, one in made.items():
                case = one.draft.case
                pairs = zip(case.views, exported.views[case_id], exported.start_views[case_id], strict=True)
                looks: list[Looked] = [looked_at(view.name, before, after) for view, before, after in pairs]
                sighted = sightings(one.operations, self._truth, one.start, looks, {})
                start = read_json(exported.inputs[case_id])
                against = sight_refusals(
                    case, one.operations, self._truth, one.start, self._snapshot, start, sighted, {}
                )
                found = self._hardness(one.draft, sighted)
                if found.tier != case.difficulty:
                    against.append(Refusal(case_id, "seen", f"it is {found.tier} and not {case.difficulty}"))
                if against:
                    self.refused[against[0].kind] += 1
                    self.progress(f"  {case_id}: {against[0].reason}")
                    continue
                writer.repair(case, source, self._truth, one.start, one.operations, exported)
                seen[case_id], hard[case_id] = sighted, found

    def _exported(self, made: dict[str, Made], scratch: Path) -> exports.Exported:
        """Snapshots and pictures of the original and of the start scenes of drafts."""
        views = {name: list(one.draft.case.views) for name, one in made.items()}
        self.progress(f"{self.name}: {sum(map(len, views.values()))} pictures of the original")
        write_json(scratch / "truth.json", self._bench.snapshot(self._truth))
        things = inventory(self._snapshot, {})
        shown, held_out = {}, {}
        for name, one in made.items():
            cameras = [camera(view) for view in views[name]]
            shown[name] = self._bench.pictures(cameras)
            told = changed(self._truth, one.start, self.boxes)
            held_out[name] = target_cameras(things, told, cameras, self._bench.probe)
        inputs, starts = {}, {}
        for name, one in made.items():
            self.progress(f"  {name}: snapshot and pictures of the start scene")
            inputs[name] = scratch / f"{name}.json"
            write_json(inputs[name], self._bench.snapshot(one.start))
            starts[name] = self._bench.pictures([exports.reduced(view) for view in views[name]])
        return exports.Exported(scratch / "truth.json", inputs, shown, starts, [], held_out)
