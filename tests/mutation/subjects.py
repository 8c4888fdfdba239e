"""What is mutated: a shipped repair and a shipped text, their base submissions, and what a submission is worth."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from c4s.files import read_json
from c4s.judge.rule.judging import judge_by_rule
from c4s.protocol.settings import Setting
from c4s.records.evidence import catalog_facts
from c4s.records.pack import MANIFEST, Pack
from c4s.records.suite import SuiteFolder, WithheldFolder
from c4s.records.verdict import Verdict
from c4s.verify.physics.verdict import verify_physics
from c4s.verify.repair.verdict import repair_verdict
from c4s.verify.semantic.detailed import verify_detailed
from tests.mutation.scenes import Scene, changed, is_mesh, scene, shifted

REPAIR, TEXT = "indoor-flat-03-child-room", "text-flat-family"
ROUNDING = 1e-9


@dataclass(frozen=True)
class Worth:
    """What a submission scores, and the advisories of its verdicts by their codes."""

    score: float
    advisories: frozenset[str]
    detailed: float = 0.0


def _codes(*verdicts: Verdict) -> frozenset[str]:
    return frozenset(note["code"] for verdict in verdicts for note in verdict.advisories)


@dataclass(frozen=True)
class RepairSubject:
    """A repair case: the scene that agents get, the original, and submissions between the two."""

    setting: Setting
    start: Scene
    truth: Scene

    def worth(self, candidate: Scene) -> Worth:
        """0.8 Repair F1 + 0.2 physics."""
        repair = repair_verdict(self.start, self.truth, candidate)
        physics = verify_physics(self.setting, candidate, self.start)
        return Worth(0.8 * (repair.score or 0.0) + 0.2 * (physics.score or 0.0), _codes(repair, physics))

    @cached_property
    def targets(self) -> list[str]:
        """Ids of the actors that differ between the start and the original."""
        old = {one["stable_actor_id"]: one for one in self.start["actors"]}
        new = {one["stable_actor_id"]: one for one in self.truth["actors"]}
        keys = ("transform", "asset_path")
        return [
            name
            for name in dict.fromkeys([*old, *new])
            if name not in old or name not in new or any(old[name][key] != new[name][key] for key in keys)
        ]

    @cached_property
    def bases(self) -> dict[str, Scene]:
        """Submissions: nothing done, half of it with the rest lifted into the air, all of it."""
        done = set(self.targets[::2])
        new = {one["stable_actor_id"]: one for one in self.truth["actors"]}
        half = [
            new.get(one["stable_actor_id"], one) if one["stable_actor_id"] in done else one
            for one in self.start["actors"]
            if one["stable_actor_id"] not in done or one["stable_actor_id"] in new
        ]
        missing = {name for name in done if name in new} - {one["stable_actor_id"] for one in half}
        halfway = scene([*half, *(new[name] for name in missing)], self.start)
        rest = set(self.targets[1::2])
        askew = changed(halfway, lambda one: one["stable_actor_id"] in rest, lambda one: shifted(one, (0, 0, 70)))
        return {"start": self.start, "askew": askew, "truth": self.truth}


@dataclass(frozen=True)
class TextSubject:
    """A text case: its prompt's requirements and the authors' own scene."""

    bundle: dict[str, Any]
    prompt: str
    binding: dict[str, Any]
    catalog: dict[str, dict[str, Any]]
    truth: Scene

    def parts(self, candidate: Scene) -> tuple[Verdict, Verdict]:
        """Detailed alignment by the state, and physics."""
        said = judge_by_rule(self.bundle, self.prompt, candidate, self.catalog, {"views": []}, self.binding)
        return verify_detailed(self.bundle, said), verify_physics("text-to-scene", candidate)

    def worth(self, candidate: Scene) -> Worth:
        """0.2 detailed + 0.2 physics: the share of a text's score that needs no picture."""
        detailed, physics = self.parts(candidate)
        said = detailed.score or 0.0
        return Worth(0.2 * said + 0.2 * (physics.score or 0.0), _codes(detailed, physics), said)

    @cached_property
    def bases(self) -> dict[str, Scene]:
        """The authors' scene, and the same with a third of its things lifted or pushed into others."""
        meshes = [one["label"] for one in self.truth["actors"] if is_mesh(one) and one["bounds"]["extent_cm"][2] > 5]
        lifted, pushed = set(meshes[::6]), set(meshes[3::6])

        def shake(one: dict[str, Any]) -> dict[str, Any]:
            return shifted(one, (0, 0, 60) if one["label"] in lifted else (45, 0, 0))

        shaken = changed(self.truth, lambda one: one["label"] in lifted | pushed, shake)
        return {"truth": self.truth, "shaken": shaken}


def repair_subject(home: Path) -> RepairSubject:
    """The shipped repair."""
    folder = SuiteFolder(home / "suites/starter")
    withheld = WithheldFolder(folder.withheld(REPAIR))
    opened = folder.agent_case(folder.case(REPAIR).alias)
    return RepairSubject(opened.setting, read_json(withheld.input_snapshot), read_json(withheld.truth_snapshot))


def text_subject(home: Path) -> TextSubject:
    """The shipped text."""
    folder = SuiteFolder(home / "suites/starter")
    withheld = WithheldFolder(folder.withheld(TEXT))
    opened = folder.agent_case(folder.case(TEXT).alias)
    return TextSubject(
        read_json(withheld.requirements),
        opened.prompt,
        read_json(withheld.binding),
        catalog_facts(Pack.read(home / "packs" / pack.pack_id / MANIFEST) for pack in opened.packs),
        read_json(withheld.truth_snapshot),
    )
