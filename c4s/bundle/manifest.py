"""``bundle.json`` of a published evidence bundle, field by field (the benchmark's page "Evidence bundles")."""

from __future__ import annotations

from pathlib import PurePosixPath
from typing import Annotated, Any, Literal, TypeVar

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field

from c4s.names import path_fault
from c4s.protocol.settings import Setting, is_construction
from c4s.records.base import Record

MANIFEST = "bundle.json"


def _inside(path: str) -> str:
    slashed = path.replace("\\", "/")
    if path_fault(slashed) or ":" in slashed.partition("/")[0]:
        raise ValueError("paths are relative to the bundle, without '..'")
    return path


def _plain(path: str) -> str:
    return str(PurePosixPath(_inside(path).replace("\\", "/")))


def _text(value: Any) -> Any:
    return str(value) if isinstance(value, (int, float)) and value else value


FileKey = Annotated[str, AfterValidator(_inside)]
"""A path as the list of files has it."""
BundlePath = Annotated[str, AfterValidator(_plain)]
"""A path that the manifest refers to, in its plain form: ``./a//b`` is the file ``a/b``."""
Text = Annotated[str, BeforeValidator(_text), Field(min_length=1)]
"""A label. Numbers are read as text."""
Digest = Annotated[str, Field(min_length=64, max_length=64)]
INTEGRITY_LEAVES = ("candidate_snapshot_integrity", "content_and_dependency_parity", "asset_library_manifest_parity")
"""The three recorded checks of candidate integrity."""


T = TypeVar("T")
Section = Annotated[T | None, BeforeValidator(lambda value: value or None)]
"""What may be absent: null and every other empty value mean the same."""


class _Part(BaseModel):
    """Only the top level refuses unknown keys."""

    model_config = ConfigDict(extra="allow", frozen=True)


class BundleTask(_Part):
    """The case."""

    id: Text
    setting: Setting
    sha256: Any = None
    """Of the ``task.yaml`` that the run used."""


class BundleRun(_Part):
    """Where the submission comes from."""

    model: Annotated[str | None, BeforeValidator(lambda value: value if value is None else str(value))] = None
    """Label that results are grouped by."""
    submission: Literal["submitted", "missing"] = "submitted"
    candidate_sha256: Any = None
    batch_status: Any = None
    authoritative: Any = None


class Integrity(_Part):
    """Recorded integrity: the three checks."""

    status: Literal["valid", "invalid"]
    leaves: Section[dict[str, Any]] = None
    failure_reason: Any = None

    def failed_leaf(self) -> str | None:
        """The first check that is recorded with another status than ``valid``."""
        recorded = self.leaves or {}
        return next((name for name in INTEGRITY_LEAVES if recorded.get(name) not in (None, "valid")), None)


class Scenes(_Part):
    """Snapshots."""

    candidate: Section[BundlePath] = None
    input: Section[BundlePath] = None
    ground_truth: Section[BundlePath] = None


class Physics(_Part):
    """The recorded report of physical safety."""

    report: Section[BundlePath] = None


class Semantic(_Part):
    """Decided requirements; the request schedule of the visual judge."""

    decisions: Section[BundlePath] = None
    stage3_plan: Section[BundlePath] = None


class Overview(_Part):
    """The recorded overview judgement and its four views."""

    judgement: Section[BundlePath] = None
    views: Section[list[BundlePath]] = None


class Render(_Part):
    """An image of the bundle."""

    path: BundlePath
    role: Any = None
    view: Any = None
    channel: Any = None


class Manifest(Record):
    """The whole of ``bundle.json``."""

    schema_version: Literal["code4scene.bundle.v1"]
    task: BundleTask
    run: Section[BundleRun] = None
    candidate_integrity: Section[Integrity] = None
    scenes: Section[Scenes] = None
    physics: Section[Physics] = None
    semantic: Section[Semantic] = None
    overview: Section[Overview] = None
    renders: Section[list[Render]] = None
    files: dict[FileKey, Digest]
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

        A bundle of a construction may lack decisions, judgement and snapshot: what they give is then not evaluated, or
        taken from the recorded report.
        """
        if not self.submitted:
            return []
        if self.candidate_integrity is None:
            return ["candidate_integrity"]
        if self.candidate_integrity.status == "invalid":
            return []
        scenes = self.scenes or Scenes()
        needed = () if is_construction(self.task.setting) else ("candidate", "input", "ground_truth")
        missing = [f"scenes.{name}" for name in needed if not getattr(scenes, name)]
        return missing + ([] if self.physics and self.physics.report else ["physics.report"])
