"""``bundle.json`` of a published evidence bundle, field by field (the benchmark's page "Evidence bundles")."""

from __future__ import annotations

from pathlib import PurePosixPath
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BaseModel, ConfigDict, Field

from c4s.case.package import Setting
from c4s.model import Record

MANIFEST = "bundle.json"


def _inside(path: str) -> str:
    parts = PurePosixPath(path).parts
    if not parts or path.startswith(("/", "~")) or "\\" in path or ".." in parts or ":" in parts[0] or "\0" in path:
        raise ValueError("paths are relative to the bundle, with '/', without '..'")
    return path


BundlePath = Annotated[str, AfterValidator(_inside)]
Digest = Annotated[str, Field(pattern=r"^[0-9a-fA-F]{64}$")]
INTEGRITY_LEAVES = ("candidate_snapshot_integrity", "content_and_dependency_parity", "asset_library_manifest_parity")
"""The three recorded checks of candidate integrity."""


class _Part(BaseModel):
    """Only the top level refuses unknown keys."""

    model_config = ConfigDict(extra="allow", frozen=True)


class Task(_Part):
    """The case."""

    id: str
    setting: Setting
    sha256: str | None = None
    """Of the ``task.yaml`` that the run used."""


class Run(_Part):
    """Where the submission comes from."""

    model: str | None = None
    """Label that results are grouped by."""
    submission: Literal["submitted", "missing"] = "submitted"
    candidate_sha256: str | None = None
    batch_status: str | None = None
    authoritative: bool | None = None


class Integrity(_Part):
    """Recorded integrity: the three checks."""

    status: Literal["valid", "invalid"]
    leaves: dict[str, str | None] | None = None
    failure_reason: str | None = None

    def failed_leaf(self) -> str | None:
        """The first check that is recorded with another status than ``valid``."""
        recorded = self.leaves or {}
        return next((name for name in INTEGRITY_LEAVES if recorded.get(name) not in (None, "valid")), None)


class Scenes(_Part):
    """Snapshots."""

    candidate: BundlePath | None = None
    input: BundlePath | None = None
    ground_truth: BundlePath | None = None


class Physics(_Part):
    """The recorded report of physical safety."""

    report: BundlePath | None = None


class Semantic(_Part):
    """Decided requirements; the request schedule of the visual judge."""

    decisions: BundlePath | None = None
    stage3_plan: BundlePath | None = None


class Overview(_Part):
    """The recorded overview judgement and its four views."""

    judgement: BundlePath | None = None
    views: list[BundlePath] | None = None


class Render(_Part):
    """An image of the bundle."""

    role: str
    view: str
    channel: str
    path: BundlePath


class Manifest(Record):
    """The whole of ``bundle.json``."""

    schema_version: Literal["code4scene.bundle.v1"]
    task: Task
    run: Run | None = None
    candidate_integrity: Integrity | None = None
    scenes: Scenes | None = None
    physics: Physics | None = None
    semantic: Semantic | None = None
    overview: Overview | None = None
    renders: list[Render] | None = None
    files: dict[BundlePath, Digest]
    """SHA-256 of every file that is referenced."""
    notes: Any = None

    @property
    def submitted(self) -> bool:
        """Whether the run left a submission."""
        return self.run is None or self.run.submission == "submitted"

    def referenced(self) -> set[str]:
        """Paths that the manifest names."""
        named: list[Any] = [render.path for render in self.renders or ()]
        if self.scenes:
            named += [self.scenes.candidate, self.scenes.input, self.scenes.ground_truth]
        if self.physics:
            named.append(self.physics.report)
        if self.semantic:
            named += [self.semantic.decisions, self.semantic.stage3_plan]
        if self.overview:
            named += [self.overview.judgement, *(self.overview.views or ())]
        return {path for path in named if path}

    def lacks(self) -> list[str]:
        """Fields that a submitted bundle of this setting must have and has not.

        A text-to-scene bundle may lack decisions, judgement and snapshot: what they give is then not evaluated, or
        taken from the recorded report.
        """
        if not self.submitted:
            return []
        if self.candidate_integrity is None:
            return ["candidate_integrity"]
        if self.candidate_integrity.status == "invalid":
            return []
        scenes = self.scenes or Scenes()
        needed = () if self.task.setting == "text-to-scene" else ("candidate", "input", "ground_truth")
        missing = [f"scenes.{name}" for name in needed if not getattr(scenes, name)]
        return missing + ([] if self.physics and self.physics.report else ["physics.report"])
