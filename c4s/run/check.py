"""Whether what a trial holds on record is as it was written: submissions, and the evidence taken of one."""

from __future__ import annotations

from pathlib import Path

from c4s.errors import BadInput
from c4s.files import read_written_json, write_json
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import TrialFolder
from c4s.records.verdict import Verdict
from c4s.run.plan import Trial
from c4s.trees import Change, Listing, changes, digests, listing_digest, read_listing, refuse

SUBMISSION_DIGESTS = "submission.digests.json"
"""Beside an attempt's ``submission/``: SHA-256 of each of its files, to tell which one was changed."""
EVIDENCE_DIGESTS = "digests.json"
_TODO = "restore the file, or run this trial again under another --run-id"


def freeze_submission(attempt: Path) -> str:
    """Note the digest of every file that an attempt saved; returns the digest of all."""
    files = read_listing(attempt / "submission")
    write_json(attempt / SUBMISSION_DIGESTS, files)
    return listing_digest(files)


def check_submission(attempt: Path, outcome: AttemptOutcome) -> None:
    """Raise ``BadInput`` where the submission is not the one that the attempt's outcome names."""
    if outcome.submission is None:
        return
    folder = attempt / "submission"
    found = read_listing(folder)
    if listing_digest(found) == outcome.submission_sha256:
        return
    try:
        noted = read_written_json(attempt / SUBMISSION_DIGESTS)
    except BadInput:
        noted = {}
    if noted and listing_digest(noted) == outcome.submission_sha256:
        refuse(changes(folder, noted, found), todo=_TODO)
    refuse([Change(folder, "unsound", "these are not the files that the attempt saved")], todo=_TODO)


def check_evidence(trial: TrialFolder) -> None:
    """Raise ``BadInput`` for the first file of the evidence that is not the one that was exported.

    The integrity verdict holds the digest of the list of digests, so evidence of another trial is told as well.
    """
    folder = trial.evidence
    frozen = read_written_json(folder / EVIDENCE_DIGESTS, what="list of digests", todo=_TODO)
    if _evidence_changes(trial, frozen, digests(folder)):
        refuse(_evidence_changes(trial, frozen, digests(folder, full=True)), todo=_TODO)


def _evidence_changes(trial: TrialFolder, frozen: Listing, found: Listing) -> list[Change]:
    folder, gate = trial.evidence, trial.verdict("integrity")
    judged = Verdict.read(gate).inputs if gate.is_file() else {}
    rows = [
        Change(folder / name, "changed") for name in sorted(judged) if judged[name] != found.get(name, judged[name])
    ]
    listed = {name: value for name, value in found.items() if name != EVIDENCE_DIGESTS}
    return rows + [change for change in changes(folder, frozen, listed) if change not in rows]


def check_kept(trial: Trial) -> None:
    """Check all that a trial to be completed has on record; ``BadInput`` names the first file that was changed."""
    for path in sorted(trial.folder.root.glob("attempt-*/outcome.json")):
        check_submission(path.parent, AttemptOutcome.read(path))
    gate = trial.folder.verdict("integrity")
    if gate.is_file() and Verdict.read(gate).status == "valid":
        check_evidence(trial.folder)
