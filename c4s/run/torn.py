"""What of a trial on record is torn or was changed, and what becomes of it: this is the one place that decides.

A file that can be made again from what lies before it is set aside as ``<name>.torn-<its digest>``, what was made from
it as ``<name>.outdated-<its digest>``, and the stages make both anew. An outcome that is no JSON was cut off by the
machine: its attempt has not ended, and is repeated. What an agent did can not be made again: an outcome that was
edited, a submission or a trajectory that is not the recorded one is refused with what to do.

For a trial of which no stage is running, by the holder of the run.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

from c4s.errors import BadInput
from c4s.files import digest_file, json_text, parse_json, read_json, write_text
from c4s.folders import remove_tree
from c4s.protocol.rules import GATE
from c4s.records.attempt import AttemptOutcome
from c4s.records.folder import AttemptFolder, TrialFolder
from c4s.records.judgement import Judgements
from c4s.records.plan import Plan
from c4s.records.score import TrialScore
from c4s.records.verdict import Verdict
from c4s.run.aside import OUTDATED, TORN, aside
from c4s.run.check import check_evidence, check_submission
from c4s.run.plan import Trial
from c4s.run.stages import ATTEMPTS
from c4s.trajectory.lines import read_lines
from c4s.verify.registry import verifiers_of


def check_scored(folder: TrialFolder) -> None:
    """``BadInput`` where the trial's score, or what it was made from, is not on record as it was written.

    Outcomes, gates and verdicts are read; submission, evidence and trajectory are not: they may be large.
    """
    score = TrialScore.read(folder.score)
    attempts = folder.attempts()
    for attempt in attempts:
        AttemptOutcome.read(attempt.outcome)
        Verdict.read(attempt.integrity)
    if (score.retained_attempt or 1) not in [attempt.number for attempt in attempts]:
        raise BadInput("the attempt that was scored is not on record", where=str(folder.root), todo=TrialScore.REMEDY)
    made_from = score.verdicts
    found = {name: digest_file(path) for name, path in folder.verdicts.items()}
    for name in sorted(made_from.keys() | found.keys()):
        if made_from.get(name) != found.get(name):
            raise BadInput(
                "this is not the verdict that the score was made from",
                where=str(folder.verdict(name)),
                todo=TrialScore.REMEDY,
            )


def is_scored(folder: TrialFolder) -> bool:
    """``check_scored`` as an answer."""
    try:
        check_scored(folder)
    except BadInput:
        return False
    return True


def settle(trial: Trial, plan: Plan) -> list[str]:
    """Set aside what of a trial cannot be used; what was done, a line each.

    ``BadInput`` for what can neither be used nor be made again.
    """
    folder = trial.folder
    if not folder.root.is_dir():
        return []
    _sweep(folder)
    try:
        return [f"{trial.name}: {line}" for line in _settled(folder, trial, plan)]
    except BadInput as error:
        todo = f"restore it, or move {folder.root} away: the same command then runs this trial anew"
        raise BadInput(error.what, where=error.where, todo=todo) from None


def _settled(folder: TrialFolder, trial: Trial, plan: Plan) -> Iterator[str]:
    yield from _stages(folder)
    retained = None
    for number in range(1, ATTEMPTS + 1):
        attempt = folder.attempt(number)
        if not attempt.root.is_dir():
            yield from _outdated(_after_attempt(folder, number))
            break
        if _is_torn(attempt.outcome):
            yield aside(attempt.outcome, TORN)
        if not attempt.outcome.is_file():
            yield from _outdated(_after_attempt(folder, number))
            break
        _check_attempt(attempt)
        if not attempt.integrity.is_file() or (unread := _unread(Verdict.read, attempt.integrity)):
            if attempt.integrity.is_file():
                yield aside(attempt.integrity, TORN, unread)
            yield from _outdated(_after_gate(folder, number))
            break
        if Verdict.read(attempt.integrity).status == "valid":
            retained = attempt
            break
    if retained is not None:
        yield from _evidence(folder, retained)
        yield from _verdicts(folder, trial, plan)
    if folder.score.is_file() and not is_scored(folder):
        why = _unread(TrialScore.read, folder.score)
        yield aside(folder.score, TORN if why else OUTDATED, why or "a verdict is not the one that it was made from")


def _check_attempt(attempt: AttemptFolder) -> None:
    """``BadInput`` for a record of what the agent did that is not whole."""
    check_submission(attempt, AttemptOutcome.read(attempt.outcome))
    read_json(attempt.manifest, what="attempt manifest")
    try:
        lines = read_lines(attempt.trajectory)
    except (OSError, ValueError) as error:
        raise BadInput(f"the trajectory cannot be read: {error}", where=str(attempt.trajectory)) from None
    if not all(isinstance(line, dict) for line in lines):
        raise BadInput("a line of the trajectory is no record", where=str(attempt.trajectory))


def _evidence(folder: TrialFolder, retained: AttemptFolder) -> Iterator[str]:
    """The gate's verdict beside the other verdicts, and the evidence that it is about."""
    gate, why = folder.verdict(GATE), ""
    if _digest(gate) != _digest(retained.integrity):
        why = "it is not the gate's verdict on the retained attempt"
        if gate.is_file():
            yield aside(gate, TORN, why)
    else:
        try:
            check_evidence(folder)
        except BadInput as error:
            why = error.line()
            if folder.evidence.root.exists():
                yield aside(folder.evidence.root, TORN, why)
    if why:
        yield from _outdated([retained.integrity, *_after_gate(folder, retained.number)])


def _verdicts(folder: TrialFolder, trial: Trial, plan: Plan) -> Iterator[str]:
    """Judgements and verdicts, each with what it was made from."""
    judgements = folder.judgements(plan.judge)
    if judgements.is_file() and (why := _unread(Judgements.read, judgements)):
        yield aside(judgements, TORN, why)
    said = _digest(judgements)
    for verifier in verifiers_of(trial.case.setting):
        path = folder.verdict(verifier.name)
        if not path.is_file():
            continue
        if why := _unread(Verdict.read, path):
            yield aside(path, TORN, why)
        elif Verdict.read(path).inputs.get("judgements", said) != said:
            yield aside(path, OUTDATED, "other judgements are on record")


def _after_attempt(folder: TrialFolder, number: int) -> list[Path]:
    """What was made from an attempt that is not there, or will be repeated."""
    later = [folder.attempt(after).root for after in range(number + 1, ATTEMPTS + 1)]
    own = folder.attempt(number)
    made = _after_gate(folder, number)
    return [*later, *([own.integrity] if own.root.is_dir() else []), *(path for path in made if path not in later)]


def _after_gate(folder: TrialFolder, number: int) -> list[Path]:
    """What was made from an attempt's gate."""
    later = [folder.attempt(after).integrity for after in range(number + 1, ATTEMPTS + 1)]
    earlier = [_digest(folder.attempt(before).integrity) for before in range(1, number)]
    verdicts = [path for name, path in folder.verdicts.items() if name != GATE or _digest(path) not in earlier]
    return [*later, *folder.judged.glob("*.json"), *verdicts, folder.score]


def _stages(folder: TrialFolder) -> Iterator[str]:
    """The times of the stages are told beside a score and decide nothing: whole lines stay."""
    if not folder.stages.is_file():
        return
    whole, lines = [], folder.stages.read_bytes().splitlines()
    for line in lines:
        try:
            record = json.loads(line)
        except ValueError:
            continue
        if isinstance(record, dict) and isinstance(record.get("stage"), str) and _is_number(record.get("seconds")):
            whole.append(record)
    if len(whole) < len(lines):
        yield aside(folder.stages, TORN, f"{len(lines) - len(whole)} lines are no record")
        write_text(folder.stages, "".join(json_text(record, indent=None) for record in whole))


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _is_torn(path: Path) -> bool:
    """Whether a file that is there is no JSON object: cut off, empty or garbled."""
    try:
        return path.is_file() and not isinstance(parse_json(path.read_bytes()), dict)
    except (ValueError, RecursionError):
        return True


def _unread(read: Callable[[Path], object], path: Path) -> str:
    """Why a record cannot be read; empty where it can."""
    try:
        read(path)
    except BadInput as error:
        return error.what
    return ""


def _digest(path: Path) -> str | None:
    return digest_file(path) if path.is_file() else None


def _outdated(paths: Iterable[Path]) -> Iterator[str]:
    for path in dict.fromkeys(paths):
        if path.exists():
            yield aside(path, OUTDATED, "what it was made from is made anew")


def _sweep(folder: TrialFolder) -> None:
    """Remove what a process that was killed had not yet renamed."""
    rooms = [folder.root, folder.judged, folder.verdict(GATE).parent]
    rooms += [folder.attempt(number).root for number in range(1, ATTEMPTS + 1)]
    for room in {room for room in rooms if room.is_dir()}:
        for left in room.glob(".*"):
            if left.is_dir() and not left.is_symlink():
                remove_tree(left, inside=folder.root)
            else:
                left.unlink()
