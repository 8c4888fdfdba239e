"""What is so, by what is shown: for an endpoint that answers requests of a model judge from the known truth."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeAlias

from c4s.files import digest_file
from c4s.records.captures import Captures
from c4s.records.folder import EvidenceFolder
from cases.judge_check.evidence import Shown

Place: TypeAlias = tuple[str, str]
"""Stage and variant."""


class Truth:
    """The truth of all claims and of what they are made of, by the requirement's words and the pictures beside them."""

    def __init__(self, scenes: Iterable[Shown]) -> None:
        self._facts: dict[Place, dict[str, bool]] = {}
        self._places: dict[str, set[Place]] = {}
        for scene in scenes:
            place = scene.stage.name, scene.variant
            self._facts[place] = _facts(scene)
            folder = EvidenceFolder(scene.folder)
            for view in Captures.read(folder.captures_index).views:
                self._places.setdefault(digest_file(folder.captures / view.file), set()).add(place)

    def __call__(self, words: str, pictures: Sequence[str]) -> bool | None:
        """Whether a requirement holds where pictures of these SHA-256 were taken; None where that is not known."""
        places = [self._places.get(sha256, set()) for sha256 in pictures]
        where = set.intersection(*places) if places else set()
        told = {self._facts[place].get(words) for place in where}
        return told.pop() if len(told) == 1 else None


def _facts(scene: Shown) -> dict[str, bool]:
    facts = {}
    for claim in scene.claims:
        for holds, variant in ((True, claim.true_on), (False, claim.false_on)):
            if variant == scene.variant:
                facts[claim.row.source_text] = holds
        facts |= {row.source_text: known[scene.variant] for row, known in claim.operands if scene.variant in known}
    return facts
