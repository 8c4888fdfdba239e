"""The JSON Schemas of c4s's file formats.

``python -m c4s.records.schemas [FOLDER]`` writes them (default ``docs/schemas``).
"""

from __future__ import annotations

import sys
from pathlib import Path

from pydantic import BaseModel

from c4s.files import write_json
from c4s.records.asking import Access, CaseReview
from c4s.records.attempt import AttemptOutcome
from c4s.records.backup import Backup
from c4s.records.base import SEAL, Sealed
from c4s.records.binding import Binding, ReviewedBindings
from c4s.records.captures import Captures
from c4s.records.frozen import Frozen
from c4s.records.guards import Guards, Instruction
from c4s.records.handover import Handover
from c4s.records.human import (
    AnnotatorSheet,
    FrozenFit,
    HoldoutOpened,
    HumanEvaluation,
    HumanRanking,
    HumanStudy,
    SavedCandidates,
)
from c4s.records.journal import Event
from c4s.records.judge import JudgeConfiguration
from c4s.records.judgement import Judgements
from c4s.records.lease import Lease
from c4s.records.level import Level
from c4s.records.navigation import NavigationEvidence
from c4s.records.pack import Pack
from c4s.records.plan import Configuration, Plan
from c4s.records.policy import ScorePolicy
from c4s.records.progress import Snapshot
from c4s.records.repeatability import Repeatability
from c4s.records.score import TrialScore
from c4s.records.snapshot import SceneSnapshot
from c4s.records.suite import AgentCase, Suite, WithheldCase
from c4s.records.unreal_content import UnrealContent
from c4s.records.verdict import Verdict

FORMATS: dict[str, type[BaseModel]] = {
    "scene-snapshot": SceneSnapshot,
    "level": Level,
    "pack": Pack,
    "unreal-content": UnrealContent,
    "suite": Suite,
    "frozen": Frozen,
    "agent-case": AgentCase,
    "withheld-case": WithheldCase,
    "binding": Binding,
    "reviewed-bindings": ReviewedBindings,
    "plan": Plan,
    "configuration": Configuration,
    "attempt-outcome": AttemptOutcome,
    "captures": Captures,
    "navigation": NavigationEvidence,
    "judge": JudgeConfiguration,
    "judgements": Judgements,
    "repeatability": Repeatability,
    "verdict": Verdict,
    "policy": ScorePolicy,
    "trial-score": TrialScore,
    "handover": Handover,
    "lease": Lease,
    "guards": Guards,
    "asked": Instruction,
    "journal": Event,
    "progress": Snapshot,
    "backup": Backup,
    "human-study": HumanStudy,
    "human-sheet": AnnotatorSheet,
    "human-ranking": HumanRanking,
    "human-components": SavedCandidates,
    "human-fit": FrozenFit,
    "human-opened": HoldoutOpened,
    "human-evaluation": HumanEvaluation,
    "access": Access,
    "case-review": CaseReview,
}


def write_schemas(folder: Path) -> list[Path]:
    """Write one schema a format; returns the files."""
    files = []
    for name, model in FORMATS.items():
        files.append(folder / f"{name}.schema.json")
        schema = model.model_json_schema(by_alias=True)
        if issubclass(model, Sealed):
            schema["properties"][SEAL] = {"pattern": "^[0-9a-f]{64}$", "title": "Digest of the rest", "type": "string"}
            schema["required"] = [*schema.get("required", []), SEAL]
        write_json(files[-1], schema)
    return files


if __name__ == "__main__":
    for written in write_schemas(Path(sys.argv[1] if len(sys.argv) > 1 else "docs/schemas")):
        print(written)
