"""Whether what a trial holds on record is as it was written: submissions, and the evidence taken of one."""

from __future__ import annotations

from typing import get_args

from c4s.errors import BadInput
from c4s.files import digest_file, read_written_json, write_json
from c4s.protocol.rules import GATE
from c4s.records.attempt import AttemptOutcome
from c4s.records.evidence_digests import EXPORTED, Maker
from c4s.records.folder import AttemptFolder, EvidenceFolder, TrialFolder
from c4s.records.verdict import Verdict
from c4s.trees import Change, Listing, changes, digests, listing_digest, read_listing, refuse

LISTING = "evidence_listing"
"""Name of the digest of the exported evidence's list of digests among what the gate read."""
_REMEDY = "restore the file, or run this trial again under another --run-id"


def freeze_submission(attempt: AttemptFolder) -> str:
    """Note the digest of every file that an attempt saved; returns the digest of all."""
    files = read_listing(attempt.submission)
    write_json(attempt.submission_digests, files)
    return listing_digest(files)


def check_submission(attempt: AttemptFolder, outcome: AttemptOutcome) -> None:
    """Raise ``BadInput`` where the submission is not the one that the attempt's outcome names."""
    if outcome.submission is None:
        return
    found = read_listing(attempt.submission)
    if listing_digest(found) == outcome.submission_sha256:
        return
    try:
        noted = read_written_json(attempt.submission_digests)
    except BadInput:
        noted = {}
    if noted and listing_digest(noted) == outcome.submission_sha256:
        refuse(changes(attempt.submission, noted, found), todo=_REMEDY)
    refuse([Change(attempt.submission, "unsound", "these are not the files that the attempt saved")], todo=_REMEDY)


def noted_digests(folder: EvidenceFolder) -> Listing:
    """The digests that the files of the evidence had when they were made, of all stages so far."""
    noted: Listing = {}
    for path in folder.listings():
        made = read_written_json(path, what="list of digests", todo=_REMEDY)
        made_by_stage = path != folder.early_digests
        if (made_by_stage and path.stem not in get_args(Maker)) or noted.keys() & made.keys():
            refuse([Change(path, "extra")], todo=_REMEDY)
        noted |= made
    return noted


def judged_digests(trial: TrialFolder) -> Listing:
    """``noted_digests`` of the evidence that passed the gate; ``BadInput`` when it is other evidence.

    The gate's verdict holds the digest of the list of what was exported.
    """
    folder, gate = trial.evidence, trial.verdict(GATE)
    if gate.is_file():
        judged, listing = Verdict.read(gate).inputs.get(LISTING), folder.digests(EXPORTED)
        if judged is not None and (not listing.is_file() or digest_file(listing) != judged):
            refuse([Change(listing, "changed" if listing.is_file() else "missing")], todo=_REMEDY)
    return noted_digests(folder)


def check_evidence(trial: TrialFolder) -> None:
    """Raise ``BadInput`` for the first file of the evidence that is not the one that was made.

    For a trial of which no stage is running.
    """
    folder, noted = trial.evidence, judged_digests(trial)
    if _differing(folder, noted, digests(folder.root)):
        refuse(_differing(folder, noted, digests(folder.root, full=True)), todo=_REMEDY)


def _differing(folder: EvidenceFolder, noted: Listing, found: Listing) -> list[Change]:
    listings = {path.relative_to(folder.root).as_posix() for path in folder.listings()}
    return changes(folder.root, noted, {name: value for name, value in found.items() if name not in listings})
