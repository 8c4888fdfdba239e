"""The digest of a suite's definition: all that a built suite depends on."""

from __future__ import annotations

from collections.abc import Sequence

from c4s.files import digest
from c4s.records.suite import PackRef
from cases.model import RepairCase, SuiteDefinition, TextCase

BUILDER_VERSION = 6
"""Part of the definition's digest: raise it when the same definition is built into other files."""


def definition_digest(definition: SuiteDefinition, packs: Sequence[PackRef]) -> str:
    """SHA-256 of all that a built suite depends on."""
    return digest(
        {
            "builder": BUILDER_VERSION,
            "suite": [definition.suite_id, definition.title, definition.description],
            "packs": [pack.plain() for pack in packs],
            "scenes": [
                [scene.scene_id, scene.environment, scene.level.plain(), list(scene.packs)]
                for scene in definition.scenes
            ],
            "cases": [_case_digest(case) for case in definition.cases],
            **({"authors": dict(definition.authors)} if definition.authors else {}),
            **({} if definition.most is None else {"most": definition.most}),
        }
    )


def _case_digest(case: RepairCase | TextCase) -> str:
    if isinstance(case, RepairCase):
        return digest([repr(case), [operation.model_dump(mode="json", by_alias=True) for operation in case.operations]])
    return digest(repr(case))
