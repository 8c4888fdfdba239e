"""Writing cases into the two trees of a suite, ``agent/`` and ``withheld/``, from levels and an engine's exports."""

from __future__ import annotations

import shutil
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from c4s.errors import BadInput
from c4s.files import write_json, write_text
from c4s.records.level import Level
from c4s.records.pack import Asset, Pack
from c4s.records.suite import AgentCase, PackRef, SuiteFolder, WithheldCase, WithheldFolder
from cases.binding import freeze_binding
from cases.exports import Exported
from cases.model import INDOOR_BUDGET, OUTDOOR_BUDGET, RepairCase, SourceScene, TextCase
from cases.prompts import repair_prompt, text_prompt
from cases.recipe import Operation, Recipe
from cases.requirements import bundle
from cases.veil import Veil
from cases.views import cameras_record, targets_record

BLANK_STAGE = "/Game/SceneBench/BlankStage"


def truth_package(scene_id: str) -> str:
    """Package of a scene's original level."""
    return f"/Game/Code4SceneGT/{scene_id}/GT"


def least_actors(truth_actors: int) -> int:
    """Integrity of a repair case: a submission must keep at least half of the original's actors."""
    return max(1, truth_actors // 2)


@dataclass(frozen=True)
class CaseWriter:
    """Writes cases into the folder of a suite; ``packs`` by id, ``authors`` by case id."""

    folder: SuiteFolder
    packs: Mapping[str, Pack]
    veil: Veil
    authors: Mapping[str, str]

    def assets(self, scene: SourceScene) -> dict[str, Asset]:
        """The assets of a scene's packs by path."""
        return {asset.path: asset for pack_id in scene.packs for asset in self._pack(pack_id).assets}

    def _pack(self, pack_id: str) -> Pack:
        if pack_id not in self.packs:
            raise BadInput(f"the suite does not name the pack {pack_id!r}", where=pack_id)
        return self.packs[pack_id]

    def _references(self, scene: SourceScene) -> list[PackRef]:
        return [PackRef(pack_id=pack_id, digest=self._pack(pack_id).sha256()) for pack_id in scene.packs]

    def repair(
        self,
        case: RepairCase,
        scene: SourceScene,
        truth: Level,
        corrupted: Level,
        operations: Sequence[Operation],
        exported: Exported,
    ) -> None:
        """Write an image-to-scene case; ``operations`` are those that made ``corrupted`` of ``truth``."""
        alias = self.veil.alias(case.case_id)
        agent, withheld = self.folder.agent(alias), self.folder.withheld(case.case_id)
        budget = case.budget or (INDOOR_BUDGET if scene.environment == "indoor" else OUTDOOR_BUDGET)
        names = []
        for view, picture, start in zip(
            case.views, exported.views[case.case_id], exported.start_views[case.case_id], strict=True
        ):
            names.append(f"references/{view.name}.png")
            _copy(picture, agent / names[-1])
            _copy(picture, withheld / f"views/truth/{view.name}.png")
            _copy(start, withheld / f"views/start/{view.name}.png")
        AgentCase(
            alias=alias,
            setting=case.setting,
            start_map=corrupted.package,
            prompt=case.prompt or repair_prompt(scene.environment, len(names)),
            budget=budget,
            packs=self._references(scene),
            catalog=[asset.spawn_path for asset in self.assets(scene).values()],
            reference_views=names,
        ).write(agent / "case.json")
        corrupted.write(agent / "start.level.json")
        WithheldCase(
            case_id=case.case_id,
            alias=alias,
            title=case.title,
            scene_id=case.scene_id,
            minimum_actors=least_actors(len(truth.actors)),
            operations=case.kinds,
            operation_group=case.group,
            difficulty=case.difficulty,
            visibility=case.visibility,
            author=self.authors.get(case.case_id),
        ).write(withheld / "case.json")
        truth.write(withheld / "truth.level.json")
        _copy(exported.truth, withheld / "truth.snapshot.json")
        _copy(exported.inputs[case.case_id], withheld / "input.snapshot.json")
        Recipe(
            case_id=case.case_id,
            setting=case.setting,
            scene_id=case.scene_id,
            source_map=truth.package,
            ground_truth_map=truth.package,
            input_map=corrupted.package,
            operations=list(operations),
            entries=case.entries,
        ).write(withheld / "recipe.json")
        write_json(withheld / "cameras.json", cameras_record(case))
        write_json(withheld / "target-cameras.json", targets_record(case.case_id, exported.targets[case.case_id]))

    def text(self, case: TextCase, scene: SourceScene, truth: Level, exported: Exported) -> None:
        """Write a text-to-scene case."""
        assets = self.assets(scene)
        alias = self.veil.alias(case.case_id)
        agent, withheld = self.folder.agent(alias), self.folder.withheld(case.case_id)
        palette = [_known(assets, path, case.case_id) for path in case.palette] or list(assets.values())
        ground = [_known(assets, path, case.case_id) for path in case.ground]
        prompt = text_prompt(case.description, ground, palette, case.plate_m, case.budget)
        requirements: dict[str, Any] = bundle(case.case_id, case.description, prompt, case.requirements)
        packs = [self._pack(pack_id) for pack_id in scene.packs]
        AgentCase(
            alias=alias,
            setting=case.setting,
            prompt=prompt + "\n",
            start_map=BLANK_STAGE,
            budget=case.budget,
            packs=self._references(scene),
            catalog=[asset.spawn_path for asset in palette],
            plate_m=case.plate_m,
        ).write(agent / "case.json")
        Level(package=BLANK_STAGE).write(agent / "start.level.json")
        WithheldCase(
            case_id=case.case_id,
            alias=alias,
            title=case.title,
            scene_id=case.scene_id,
            minimum_actors=case.minimum_actors,
            difficulty=case.difficulty,
            visibility=case.visibility,
            author=self.authors.get(case.case_id),
        ).write(withheld / "case.json")
        truth.write(withheld / "truth.level.json")
        _copy(exported.truth, withheld / "truth.snapshot.json")
        write_json(withheld / "requirements.bundle.json", requirements)
        freeze_binding(WithheldFolder(withheld), requirements, packs, case.reviewed)
        for picture in exported.overview:
            _copy(picture, withheld / f"views/truth/{picture.name}")
        write_text(withheld / "prompt.txt", prompt + "\n")


def _known(assets: dict[str, Asset], path: str, case_id: str) -> Asset:
    if path not in assets:
        raise BadInput(f"no pack of the scene holds {path}", where=case_id)
    return assets[path]


def _copy(source: Path, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(source, target)
