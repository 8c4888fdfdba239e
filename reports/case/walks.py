"""The walks of a case side by side: that of its start, that of its truth, then each configuration's.

The start is walked in the scene that the baseline ``noop`` saved, the truth in the one that ``oracle`` saved: their
trials stand for them, so that all maps come of one verifier.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from c4s.protocol.baselines import NOOP, ORACLE
from c4s.verify.navigation.verifier import NAVIGATION
from reports.case.runs import CaseRun
from reports.case.walk import WalkMap, walk_of

UNTOLD: Final = (
    "this trial has no navigation verdict: it ended without a scene, or was judged before there was one (reverify)"
)
_STANDS: Final = {NOOP: "Start", ORACLE: "Truth"}


@dataclass(frozen=True)
class CaseWalk:
    """A trial's walk, or why it has none."""

    label: str
    run: CaseRun
    walk: WalkMap | None
    why: str = ""


@dataclass(frozen=True)
class CaseWalks:
    """All of them."""

    rows: Sequence[CaseWalk]
    counts: Mapping[str, int]
    """How targets fall, in all maps."""
    missing: str
    """Which of start and truth is not shown, and why."""


def walks_of(runs: Sequence[CaseRun], documents: Mapping[str, Mapping[str, Any]]) -> CaseWalks | None:
    """Start, truth, configurations as they stand on the leaderboard; None where no trial has a navigation verdict."""
    found = [_of(run, documents.get(run.trial["trial_id"], {})) for run in runs]
    walked = [one.walk for one in found if one.walk]
    if not walked:
        return None
    places = list(_STANDS)
    found.sort(key=lambda one: places.index(one.run.trial["client"]) if one.run.trial["client"] in _STANDS else 2)
    clients = {run.trial["client"] for run in runs}
    missing = [
        f"{label} is not shown: {client} has not played this case."
        for client, label in _STANDS.items()
        if client not in clients
    ]
    counts: Counter[str] = Counter()
    for walk in walked:
        counts.update(walk.counts)
    return CaseWalks(found, counts, " ".join(missing))


def _of(run: CaseRun, documents: Mapping[str, Any]) -> CaseWalk:
    repeat = f" · repeat {run.trial['repeat']}" if run.trial["repeat"] > 1 else ""
    stands = _STANDS.get(run.trial["client"])
    label = (f"{stands} ({run.configuration})" if stands else run.configuration) + repeat
    walk = walk_of(documents.get(NAVIGATION.name))
    return CaseWalk(label, run, walk, "" if walk else UNTOLD)
