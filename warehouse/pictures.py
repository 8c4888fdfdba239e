"""Pictures as rows: JPEG of what was photographed of cases and submissions."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final

from PIL import Image, ImageStat

from c4s.records.captures import OVERVIEW, Captures
from c4s.records.suite import WithheldFolder
from c4s.run.check import check_evidence
from c4s.run.plan import Trial
from warehouse.records import PictureRow

PICTURE_WIDTH, PICTURE_QUALITY = 960, 85
EVIDENCE_WIDTH, EVIDENCE_QUALITY = 640, 78
"""Of the pictures of claims and repair targets, of which a trial may have many."""
CASE_PARTITION = "_case"
"""Partition of pictures that belong to a case, not to a configuration."""
SHOWN: Final = (OVERVIEW, "reference")
"""Purposes of the views that pages show of a submission."""
EVIDENCE: Final = {"claim": "claim", "target": "target", "truth": "target_truth"}
"""Purposes of the views that verdicts rest on, and the roles of their pictures."""


def case_pictures(folder: WithheldFolder, key: dict[str, Any]) -> Iterator[PictureRow]:
    """A case's pictures of its start and its truth."""
    for role in ("start", "truth"):
        for path in sorted(folder.views(role).glob("*.png")):
            yield image_row(path, key, role, path.stem)


def submission_pictures(trial: Trial, key: dict[str, Any], *, evidence: bool) -> Iterator[PictureRow]:
    """A submission's pictures; with ``evidence`` those of single requirements and repair targets too."""
    index = trial.folder.evidence.captures_index
    if not index.is_file():
        return
    check_evidence(trial.folder)
    for view in Captures.read(index).views:
        if view.purpose in SHOWN:
            yield image_row(index.parent / view.file, key, "submission", view.name)
        elif evidence and view.purpose in EVIDENCE:
            role, path = EVIDENCE[view.purpose], index.parent / view.file
            yield image_row(path, key, role, view.pair or view.name, EVIDENCE_WIDTH, EVIDENCE_QUALITY)


def image_row(
    path: Path, key: dict[str, Any], role: str, view: str, width: int = PICTURE_WIDTH, quality: int = PICTURE_QUALITY
) -> PictureRow:
    """A picture as JPEG, at most ``width`` pixels wide."""
    with Image.open(path) as image:
        picture = image.convert("RGB")
    if picture.width > width:
        picture = picture.resize((width, max(1, round(picture.height * width / picture.width))))
    buffer = io.BytesIO()
    picture.save(buffer, "JPEG", quality=quality)
    return PictureRow.parse(
        {
            **key,
            "role": role,
            "view": view,
            "width": picture.width,
            "height": picture.height,
            "jpeg": buffer.getvalue(),
            "brightness": round(ImageStat.Stat(picture.convert("L")).mean[0] / 255, 4),
        }
    )
