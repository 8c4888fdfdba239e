"""Whether a built suite may be frozen: reviewed by others than its authors, on content with a known licence."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from c4s.errors import BadInput
from c4s.files import read_json_lines
from c4s.packs.suite_check import suite_changes
from c4s.records.asking import CaseReview, ReviewFolder
from c4s.records.frozen import Frozen, FrozenPack, FrozenReview
from c4s.records.pack import MANIFEST, Pack
from c4s.records.suite import SuiteFolder
from c4s.trees import refuse

SOLVABLE, PROMPT = 3, 2
"""Reviewers who say that a case can be solved, and that its prompt is clear (paper, benchmark suite)."""
_SHOWN = 4


@dataclass(frozen=True)
class Gap:
    """What keeps a suite from being frozen: a case or a pack, and what it lacks."""

    of: str
    lacks: str


class NotFrozen(BadInput):
    """A suite cannot be frozen yet; ``gaps`` has all of what it lacks."""

    def __init__(self, suite: str, gaps: Sequence[Gap]) -> None:
        told = "; ".join(f"{gap.of}: {gap.lacks}" for gap in gaps[:_SHOWN])
        more = f"; and {len(gaps) - _SHOWN} more" if len(gaps) > _SHOWN else ""
        super().__init__(
            f"the suite cannot be frozen: {told}{more}",
            where=suite,
            todo=f"collect reviews with `c4s suite review {suite}`, and name the licences of its packs",
        )
        self.gaps = tuple(gaps)


def freeze(suite: SuiteFolder, reviews: ReviewFolder, packs_root: Path) -> Frozen:
    """Freeze a suite: write ``frozen.json`` beside its list of cases.

    Raises:
        NotFrozen: reviews are missing or say no, or the licence or the permission for AI use of a pack is not known.
        BadInput: a file of the suite or of a pack was changed.
    """
    refuse(suite_changes(suite), todo="restore the files, or build again with --replace")
    record = suite.suite()
    packs = [Pack.read(packs_root / pack.pack_id / MANIFEST) for pack in record.packs]
    given = _reviews(reviews.reviews, record.suite_id, record.sha256())
    cases: dict[str, FrozenReview] = {}
    gaps = [gap for pack in packs for gap in _licence_gaps(pack)]
    for case in record.cases:
        author = suite.withheld_case(case.case_id).author
        own = {name: row for name, row in given.get(case.alias, {}).items() if name != author}
        cases[case.case_id] = review = FrozenReview(
            author=author,
            solvable=sorted(name for name, row in own.items() if row.answers.get("solvable") == "yes"),
            prompt=sorted(
                name
                for name, row in own.items()
                if row.answers.get("clear") == "yes" and row.answers.get("consistent") == "yes"
            ),
        )
        gaps += _review_gaps(case.case_id, review, own)
    if gaps:
        raise NotFrozen(record.suite_id, gaps)
    frozen = Frozen(
        suite=record.suite_id,
        suite_digest=record.sha256(),
        packs=[FrozenPack(pack_id=pack.pack_id, license=pack.license, ai_use=pack.ai_use) for pack in packs],
        cases=cases,
    )
    frozen.write(suite.frozen)
    return frozen


def _reviews(path: Path, suite_id: str, suite_digest: str) -> Mapping[str, Mapping[str, CaseReview]]:
    """Reviews of this very build, by alias and reviewer."""
    found: dict[str, dict[str, CaseReview]] = defaultdict(dict)
    rows = read_json_lines(path, what="reviews", cut=True) if path.is_file() else []
    for row in rows:
        review = CaseReview.parse(row, where=str(path))
        if (review.suite, review.suite_digest) == (suite_id, suite_digest):
            found[review.alias][review.reviewer] = review
    return found


def _licence_gaps(pack: Pack) -> list[Gap]:
    gaps = []
    if pack.license in ("", "unknown"):
        gaps.append(Gap(f"pack {pack.pack_id}", "its licence is not known"))
    if pack.ai_use != "allowed":
        gaps.append(Gap(f"pack {pack.pack_id}", f"permission for AI use is {pack.ai_use}"))
    return gaps


def _review_gaps(case_id: str, review: FrozenReview, given: Mapping[str, CaseReview]) -> list[Gap]:
    gaps = []
    for row in given.values():
        said = [name for name, answer in row.answers.items() if answer == "no"]
        if said:
            gaps.append(Gap(case_id, f"{row.reviewer} says it is not {' and not '.join(said)}: {row.note}"))
    for what, have, least in (
        ("find it solvable", review.solvable, SOLVABLE),
        ("find its prompt clear", review.prompt, PROMPT),
    ):
        if len(have) < least:
            gaps.append(Gap(case_id, f"{len(have)} of {least} reviewers who did not make it {what}"))
    return gaps
