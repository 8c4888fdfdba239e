"""Building a suite: from definitions to the two frozen trees, ``agent/`` and ``withheld/``.

Levels are corrupted here; what a level looks like to the verifiers (its snapshot) and to the agent (reference pictures)
is exported by the same clean engine process that later reads the submissions. A suite is built beside its place and
moved there when it is whole, so an interrupted build leaves nothing half done. The digest of the definition decides
whether a suite that is there is the one that is asked for; another one is replaced only where that is asked for.
"""

from __future__ import annotations

import math
import tempfile
from collections import Counter
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing
from dataclasses import asdict
from functools import partial
from pathlib import Path

from c4s.errors import BadInput
from c4s.files import read_json, write_json
from c4s.folders import beside, put_folder
from c4s.packs.check import check_pack
from c4s.packs.store import PackStore
from c4s.records.level import Level
from c4s.records.pack import Asset, Pack
from c4s.records.suite import SUITE, PackRef, Suite, SuiteFolder
from cases import exports
from cases.admissible import (
    Refusal,
    Refused,
    TargetSighting,
    looked_at,
    score_refusals,
    sight_refusals,
    sightings,
    summed,
)
from cases.applying import apply
from cases.audit import audit, check_blind
from cases.boxes import Boxes, boxes_of
from cases.checks import check_definition, check_repair, check_scene
from cases.corruption import id_of, with_identities
from cases.definition import definition_digest
from cases.losses import told, truth_losses
from cases.model import RepairCase, SourceScene, SuiteDefinition, TextCase
from cases.natural import lived_in, plans_of, rebased, rounded, settled_spawns
from cases.packaging import CaseWriter, truth_package
from cases.recipe import Operation, SpawnActor
from cases.settle import to_build
from cases.sharing import share_equal
from cases.sifting import MadeCase, sifted
from cases.stamp import STAMP
from cases.standing import settled, snapshot_of
from cases.veil import Veil
from cases.views import changed

SPARE = 1.5
"""Where only so many repairs are kept, pictures are taken of this many times as many: some show too little.
Where too few of those can be used, the next ones are looked at."""
SCENES_AT_ONCE = 2
"""An engine starts and writes its files on one processor; meanwhile that of another scene renders on the others."""
Progress = Callable[[str], None]


def build_suite(
    definition: SuiteDefinition, root: Path, packs_root: Path, progress: Progress = print, *, replace: bool = False
) -> Suite:
    """Build the suite at ``root`` unless the same one is there.

    Args:
        definition: scenes and cases.
        root: the suite's folder.
        packs_root: where the packs lie, one folder a pack.
        progress: called with a line for each step.
        replace: put the new suite in the place of another one, or of one that was changed, when it is whole.

    Raises:
        BadInput: a pack is missing or was changed, a case cannot be used (the message names it), or what lies at
            ``root`` is not to be replaced.
        MachineryFault: the engine failed.
    """
    check_definition(definition)
    for pack_id in definition.packs:
        check_pack(packs_root / pack_id)
    packs = {pack_id: Pack.read(packs_root / pack_id / "pack.json") for pack_id in definition.packs}
    references = [PackRef(pack_id=pack_id, digest=pack.sha256()) for pack_id, pack in packs.items()]
    wanted = definition_digest(definition, references)
    same = (root / STAMP).is_file() and read_json(root / STAMP).get("definition") == wanted
    if not to_build(root, same=same, replace=replace):
        progress(f"suite {definition.suite_id}: already built")
        return SuiteFolder(root).suite()
    with beside(root) as scratch:
        folder = SuiteFolder(scratch / "suite")
        builder = _Builder(definition, folder, packs, packs_root, Veil(wanted), progress)
        with ThreadPoolExecutor(SCENES_AT_ONCE) as pool:
            list(pool.map(builder.scene, definition.scenes))
        if definition.most is None and builder.refused:
            raise Refused(sorted(builder.refused, key=lambda one: one.case_id))
        if definition.most is not None and not builder.taken:
            raise BadInput(
                f"none of {len(definition.cases)} made cases is a good one: {summed(builder.refused)}",
                where=f"{builder.refused[0].case_id}: {builder.refused[0].reason}",
                todo="give another --seed, or fewer --changes",
            )
        share_equal(folder.root / "withheld")
        suite = folder.freeze(definition.suite_id, definition.title, definition.description, references)
        check_blind(list(audit(folder, packs_root)))
        refused = [one.plain() for one in builder.refused]
        losses = truth_losses(folder, packs_root, whole=builder.sightings)
        for line in told(losses):
            progress(line)
        made = {"definition": wanted, "physics_of_truth": losses}
        write_json(folder.root / STAMP, {**made, **({"refused": refused} if refused else {})})
        write_json(folder.sightings, {name: list(map(asdict, rows)) for name, rows in builder.sightings.items()})
        put_folder(folder.root, root, marker=SUITE)
    return suite


class _Builder:
    """Writes the cases of a suite, one scene after the other."""

    def __init__(
        self,
        definition: SuiteDefinition,
        folder: SuiteFolder,
        packs: dict[str, Pack],
        packs_root: Path,
        veil: Veil,
        progress: Progress,
    ) -> None:
        self.definition, self.folder = definition, folder
        self.packs_root, self.veil, self.progress = packs_root, veil, progress
        self.writer = CaseWriter(folder, packs, veil, definition.authors)
        self.operations: dict[str, list[Operation]] = {}
        """Of each repair, as they were made."""
        self.taken: Counter[str] = Counter()
        """How many repairs of each scene are written."""
        self.names: dict[str, dict[str, str]] = {}
        """Of each repair: what its author calls the actors of the veiled levels."""
        self.refused: list[Refusal] = []
        """Repairs that cannot be used, and where only so many are kept, those that are not taken."""
        self.sightings: dict[str, list[TargetSighting]] = {}

    def scene(self, scene: SourceScene) -> None:
        """Write every case of a scene."""
        cases = [case for case in self.definition.cases if case.scene_id == scene.scene_id]
        if not cases:
            return
        assets = self.writer.assets(scene)
        check_scene(scene, set(assets))
        truth = with_identities(scene.level, scene.scene_id).model_copy(
            update={"package": truth_package(scene.scene_id)}
        )
        self.progress(f"scene {scene.scene_id}: {len(truth.actors)} actors, {len(cases)} cases")
        folders = [self.packs_root / pack_id for pack_id in scene.packs]
        repairs = [case for case in cases if isinstance(case, RepairCase)]
        corrupted: dict[str, Level] = {}
        if repairs:
            truth, corrupted = self._damaged(scene, truth, repairs, assets)
        if self.definition.most is None:
            self._write(scene, truth, cases, corrupted)
            return
        texts = [case for case in cases if isinstance(case, TextCase)]
        if texts:
            self._write(scene, truth, texts, {})
        while corrupted and self.taken[scene.scene_id] < self.definition.most:
            good = self._sifted(repairs, truth, corrupted, folders, boxes_of(assets.values()), self.definition.most)
            if good:
                chosen = [case for case in repairs if case.case_id in good]
                self._write(scene, truth, chosen, {case_id: corrupted[case_id] for case_id in good})
            looked_at = {*good, *(one.case_id for one in self.refused)}
            corrupted = {case_id: level for case_id, level in corrupted.items() if case_id not in looked_at}

    def _write(
        self, scene: SourceScene, truth: Level, cases: Sequence[RepairCase | TextCase], corrupted: dict[str, Level]
    ) -> None:
        """Take the pictures of cases of a scene, and write those that can be used."""
        folders = [self.packs_root / pack_id for pack_id in scene.packs]
        views = {case.case_id: list(case.views) for case in cases if isinstance(case, RepairCase)}
        with tempfile.TemporaryDirectory(dir=self.folder.root.parent) as scratch:
            known = boxes_of(self.writer.assets(scene).values())
            told = {case_id: changed(truth, level, known) for case_id, level in corrupted.items()}
            exported = exports.scene(folders, truth, corrupted, views, told, Path(scratch), self.progress)
            for case in cases:
                if isinstance(case, RepairCase):
                    if not self._taken(case, scene, truth, corrupted[case.case_id], exported):
                        continue
                    operations = self.operations[case.case_id]
                    self.writer.repair(case, scene, truth, corrupted[case.case_id], operations, exported)
                else:
                    self.writer.text(case, scene, truth, exported)

    def _damaged(
        self, scene: SourceScene, authored: Level, repairs: list[RepairCase], assets: dict[str, Asset]
    ) -> tuple[Level, dict[str, Level]]:
        """The original as people would have left it, and the corrupted level of each case; all of it veiled."""
        authored, chance = rounded(authored), self.veil.chance(scene.scene_id)
        boxes = boxes_of(assets.values())
        packs = [self.packs_root / pack_id for pack_id in scene.packs]
        plans = plans_of([operation for case in repairs for operation in case.operations], authored)
        original = settled(authored, lived_in(authored, boxes, chance, plans), partial(snapshot_of, packs=packs))
        damaged, usable = [original], list[RepairCase]()
        for case in repairs:
            operations = rebased(case.operations, authored, original, chance)
            put = [operation.stable_id for operation in operations if isinstance(operation, SpawnActor)]
            package = self.veil.start_map(case.case_id)
            corrupted = lived_in(apply(original, operations, package), boxes, chance, only=put)
            operations = settled_spawns(operations, corrupted)
            try:
                check_repair(case, operations, original, corrupted)
            except BadInput as error:
                if self.definition.most is None:
                    raise
                self.refused.append(Refusal(case.case_id, "unreachable", error.what))
                continue
            damaged.append(corrupted)
            usable.append(case)
            self.operations[case.case_id] = operations
        truth, *veiled = self.veil.scene(scene.scene_id, damaged)
        for case, level, plain in zip(usable, veiled, damaged[1:], strict=True):
            known = {
                self.veil.id_of(scene.scene_id, id_of(one) or one.name): one.name
                for one in (*original.actors, *plain.actors)
            }
            self.names[case.case_id] = {
                one.name: known.get(id_of(one) or "", one.name) for one in (*truth.actors, *level.actors)
            }
            told = self.veil.operations(scene.scene_id, self.operations[case.case_id], level)
            self.operations[case.case_id] = told
        return truth, {case.case_id: level for case, level in zip(usable, veiled, strict=True)}

    def _sifted(
        self,
        repairs: Sequence[RepairCase],
        truth: Level,
        corrupted: dict[str, Level],
        folders: list[Path],
        boxes: Boxes,
        wanted: int,
    ) -> list[str]:
        """Ids of the first good cases: as many as are still wanted, and some to spare."""
        settings, scene_id = {case.case_id: case.setting for case in repairs}, repairs[0].scene_id
        with closing(exports.snapshots(folders, {"": truth, **corrupted})) as exported:
            original = next(exported)[1]
            candidates = (
                MadeCase(case_id, settings[case_id], corrupted[case_id], snapshot, original)
                for case_id, snapshot in exported
            )
            most = math.ceil(SPARE * (wanted - self.taken[scene_id]))
            good, refused = sifted(candidates, boxes, PackStore(folders), most, self.progress)
        self.refused += refused
        return good

    def _taken(
        self, case: RepairCase, scene: SourceScene, truth: Level, corrupted: Level, exported: exports.Exported
    ) -> bool:
        """Whether a repair is written; how well its changes can be seen, and why it cannot be used, is noted."""
        most = self.definition.most
        if most is not None and self.taken[case.scene_id] == most:
            return False
        operations, names = self.operations[case.case_id], self.names[case.case_id]
        pairs = zip(case.views, exported.views[case.case_id], exported.start_views[case.case_id], strict=True)
        looks = [looked_at(view.name, original, start) for view, original, start in pairs]
        seen = sightings(operations, truth, corrupted, looks, names)
        original, start = read_json(exported.truth), read_json(exported.inputs[case.case_id])
        against = sight_refusals(case, operations, truth, corrupted, original, start, seen, names)
        if most is None:
            store = PackStore([self.packs_root / pack_id for pack_id in scene.packs])
            against += score_refusals(case.case_id, case.setting, original, start, store, names)
        self.refused += against
        if against:
            return False
        self.sightings[case.case_id] = seen
        self.taken[case.scene_id] += 1
        return True
