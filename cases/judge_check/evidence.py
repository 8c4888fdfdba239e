"""Evidence of the stages: each level goes through the headless engine as a submission does, once.

It lies in ``C4S_HOME/cache/judge-check/<key>``: level, bundle, pack, and the sources that draw and plan views. It may
be deleted at any time; a check that finds it there starts no engine. As in a run, what changes in stage 1 later is
judged by the pictures that are there.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from c4s.evidence import open_level
from c4s.files import digest, write_json
from c4s.folders import beside, put_folder
from c4s.home import cache_root, packs_root
from c4s.protocol.bundle import read_requirements
from c4s.records.evidence import Evidence, catalog_facts
from c4s.records.folder import EvidenceFolder
from c4s.records.level import Level
from c4s.records.pack import MANIFEST, Pack
from c4s.records.version import code_version
from c4s.semantics.sight import sight_plan
from cases.judge_check.claims import bundle, sheet
from cases.judge_check.model import VARIANTS, CheckScene, Claim, Variant
from cases.judge_check.stages import STAGES
from cases.judge_check.staging import staged
from cases.starter import indoor_cases, outdoor_cases
from catalog.build import ensure_pack

ROOM: Final = "judge-check"
_ENGINE: Final = "headless"
_DRAW: Final = ("editor", "engine", "evidence", "geometry", "packs", "render", "semantics/sight")
_BUNDLE: Final = "bundle.json"
Tell = Callable[[str], None]


@dataclass(frozen=True)
class Shown:
    """One variant of one stage, photographed."""

    stage: CheckScene
    variant: Variant
    claims: tuple[Claim, ...]
    prompt: str
    folder: Path

    @property
    def name(self) -> str:
        """Stage and variant."""
        return f"{self.stage.name}/{self.variant}"

    def evidence(self) -> Evidence:
        """As a judge is given it."""
        made = EvidenceFolder(self.folder)
        return Evidence(
            setting="text-to-scene",
            prompt=self.prompt,
            files={
                "captures": made.captures_index,
                "candidate_snapshot": made.snapshot,
                "requirements": self.folder / _BUNDLE,
            },
            packs=[packs_root() / self.stage.pack],
        )


@functools.cache
def _sources() -> dict[str, Level]:
    return {scene.scene_id: scene.level for scene in (*indoor_cases.scenes(), *outdoor_cases.scenes())}


def shown(stages: Sequence[str] = (), tell: Tell = lambda line: None) -> Iterator[Shown]:
    """The variants of the stages of these names (all where none is named), each rendered where it is not kept."""
    for stage in STAGES:
        if stages and stage.name not in stages:
            continue
        ensure_pack(stage.pack, packs_root())
        pack = Pack.read(packs_root() / stage.pack / MANIFEST)
        levels = staged(stage, _sources()[stage.source], pack).levels
        asked = bundle(stage)
        prompt, made = sheet(stage)
        for variant in VARIANTS:
            key = digest([levels[variant].plain(), asked, pack.sha256(), code_version(*_DRAW)])
            folder = cache_root() / ROOM / "scenes" / key
            if not EvidenceFolder(folder).captures_index.is_file():
                tell(f"rendering {stage.name}/{variant}")
                _render(levels[variant], asked, pack, folder)
            yield Shown(stage, variant, made.claims, prompt, folder)


def _render(level: Level, asked: dict[str, Any], pack: Pack, folder: Path) -> None:
    plan = sight_plan(read_requirements(asked), catalog_facts([pack]))
    with beside(folder) as scratch:
        document = scratch / "scene.level.json"
        level.write(document)
        made = scratch / "made"
        with open_level(engine=_ENGINE, packs=[packs_root() / pack.pack_id], level=document) as clean:
            clean.export(made)
            clean.look(made, plan)
        write_json(made / _BUNDLE, asked)
        put_folder(made, folder, marker=EvidenceFolder(folder).captures_index.relative_to(folder).as_posix())
