"""What the engine exports for a suite: snapshots of original and corrupted levels, and reference pictures.

All of it comes from clean engine processes, by the very code that exports a submission's evidence.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from c4s.engine import evidence
from c4s.scene.level import Level
from cases.model import View
from cases.views import camera


@dataclass(frozen=True)
class Exported:
    """Files of a scene: the original's snapshot, each case's input snapshot, and each case's pictures in order."""

    truth: Path
    inputs: dict[str, Path]
    views: dict[str, list[Path]]


def scene(packs: Sequence[Path], truth: Level, corrupted: Mapping[str, Level], views: Mapping[str, Sequence[View]],
          out: Path, progress: Callable[[str], None]) -> Exported:
    """Export a scene into the folder ``out``: one engine for the original with all pictures, one a corrupted level."""
    content = out / "content"
    truth.write(content / f"{truth.package.lstrip('/')}.level.json")
    cameras = [{**camera(view), "name": f"{case_id}--{view.name}"}
               for case_id, wanted in views.items() for view in wanted]
    progress(f"  original: snapshot and {len(cameras)} pictures")
    evidence.collect(packs=packs, submission_content=content, package=truth.package, out=out / "truth", cameras=cameras)
    inputs = {}
    for case_id, level in corrupted.items():
        progress(f"  {case_id}: snapshot of the corrupted level")
        inputs[case_id] = out / "inputs" / f"{case_id}.snapshot.json"
        level.write(out / "levels" / f"{case_id}.level.json")
        evidence.export_level(packs=packs, level=out / "levels" / f"{case_id}.level.json", out=inputs[case_id])
    pictures = {case_id: [out / "truth" / "captures" / f"{case_id}--{view.name}.png" for view in wanted]
                for case_id, wanted in views.items()}
    return Exported(out / "truth" / "snapshot.json", inputs, pictures)
