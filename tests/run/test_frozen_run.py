"""One changed byte of what a run has on record is told, is nobody's outcome, and is not scored."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from c4s.errors import BadInput
from c4s.evidence import export_evidence
from c4s.protocol.rules import DEFAULT_POLICY
from c4s.records.attempt import AttemptOutcome
from c4s.records.level import Level
from c4s.records.plan import Plan
from c4s.records.score import TrialScore
from c4s.records.suite import SuiteFolder
from c4s.run import stages
from c4s.run.check import check_evidence, noted_digests
from c4s.run.configurations import configuration
from c4s.run.plan import Trial, make_plan, open_run, trials
from c4s.score.policies import policy_named
from c4s.score.rescore import rescore
from tests.run.conftest import Command
from tests.run.frozen import changed, edited, flipped

REPAIR = "indoor-flat-01-mirrored-bath"
RUN = "tampered"
Change = Callable[[bytes], bytes]
LEVEL = "attempt-1/submission/Game/SavedScenes/submission.level.json"


@pytest.fixture(scope="module")
def own(home: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A home with the suite and no run."""
    root = tmp_path_factory.mktemp("own")
    for part in ("packs", "suites"):
        shutil.copytree(home / part, root / part)
    return root


def frozen_plan(own: Path) -> Plan:
    return open_run(
        own / "runs" / RUN,
        make_plan(
            SuiteFolder(own / "suites/small"),
            [configuration("noop")],
            run_id=RUN,
            policy=DEFAULT_POLICY,
            judge="rule",
            engine="headless",
            cases=[REPAIR],
        ),
    )


def only_trial(own: Path, plan: Plan) -> Trial:
    return next(trials(own / "runs" / RUN, own / "suites/small", plan))


@pytest.fixture(scope="module")
def attempted(own: Path) -> Path:
    """The home after the attempt of one trial, and nothing more."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("C4S_HOME", str(own))
        plan = frozen_plan(own)
        outcome = stages.attempt(only_trial(own, plan), plan, 1)
        assert outcome.submission == "/Game/SavedScenes/submission"
    return own


@pytest.fixture(scope="module")
def gated(attempted: Path) -> Path:
    """The home after evidence was taken and found valid."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("C4S_HOME", str(attempted))
        plan = frozen_plan(attempted)
        assert stages.integrity(only_trial(attempted, plan), plan, 1)
        stages.look(only_trial(attempted, plan), plan)
    return attempted


@pytest.fixture
def trial(own: Path, monkeypatch: pytest.MonkeyPatch) -> Trial:
    monkeypatch.setenv("C4S_HOME", str(own))
    return only_trial(own, frozen_plan(own))


def _none_saved(outcome: dict[str, object]) -> None:
    outcome["submission"] = None


def _more_repeats(plan: dict[str, object]) -> None:
    plan["versions"] = {}


SUBMITTED: list[tuple[str, str, Change]] = [
    ("submission level", LEVEL, flipped),
    ("list of saves", "attempt-1/submission/saves.jsonl", flipped),
    ("outcome.json, a byte", "attempt-1/outcome.json", flipped),
    ("outcome.json, no submission", "attempt-1/outcome.json", edited(_none_saved)),
    ("outcome.json, a blank", "attempt-1/outcome.json", lambda data: data + b"\n"),
]
EVIDENCE: list[tuple[str, str, Change]] = [
    ("snapshot", "evidence/snapshot.json", flipped),
    ("dependencies", "evidence/dependencies.json", flipped),
    ("list of captures", "evidence/captures/captures.json", flipped),
    ("capture", "evidence/captures/*.png", flipped),
    ("actor mask", "evidence/captures/*.npz", flipped),
    ("list of digests", "evidence/digests/export.json", flipped),
    ("list of digests, a blank", "evidence/digests/export.json", lambda data: data + b" "),
]


def names(rows: list[tuple[str, str, Change]]) -> list[str]:
    return [row[0] for row in rows]


def told_of(error: BadInput, path: Path, request: pytest.FixtureRequest, own: Path) -> str:
    line = error.line()
    assert error.exit_code == 2 and "(" in line and "\n" not in line
    request.node.user_properties.append(("told", line.replace(f"{own}/", "")))
    return line


@pytest.mark.parametrize(("kind", "pattern", "change"), SUBMITTED, ids=names(SUBMITTED))
def test_a_changed_submission_is_no_evidence(
    attempted: Path, trial: Trial, kind: str, pattern: str, change: Change, request: pytest.FixtureRequest
) -> None:
    path = sorted(trial.folder.root.glob(pattern))[0]
    with changed(path, change), pytest.raises(BadInput) as refused:
        stages.integrity(trial, frozen_plan(attempted), 1)
    assert str(path) in told_of(refused.value, path, request, attempted)
    assert not trial.folder.attempt(1).integrity.exists() and not trial.folder.evidence.root.exists()


def test_a_link_or_a_file_beside_the_saved_level_is_told(attempted: Path, trial: Trial) -> None:
    folder = trial.folder.attempt(1).submission
    (folder / "more.asset.json").write_text("{}")
    with pytest.raises(BadInput, match=r"more\.asset\.json: the file was not there"):
        stages.integrity(trial, frozen_plan(attempted), 1)
    (folder / "more.asset.json").unlink()
    (folder / "link").symlink_to("saves.jsonl")
    with pytest.raises(BadInput, match="link: a link is not allowed"):
        stages.integrity(trial, frozen_plan(attempted), 1)
    (folder / "link").unlink()


@pytest.mark.parametrize(("kind", "pattern", "change"), [SUBMITTED[0], SUBMITTED[3]], ids=["level", "outcome"])
def test_the_command_ends_with_2_and_one_line(
    attempted: Path, c4s: Command, trial: Trial, kind: str, pattern: str, change: Change
) -> None:
    path = trial.folder.root / pattern
    with changed(path, change):
        done = c4s("run", "small", "-a", "noop", "--case", REPAIR, "--run-id", RUN, home=attempted)
    assert done.returncode == 2 and len(done.stderr.strip().splitlines()) == 1, done.stderr
    assert str(path) in done.stderr and not trial.folder.score.exists()


def test_a_changed_plan_is_told(attempted: Path, c4s: Command, trial: Trial, request: pytest.FixtureRequest) -> None:
    path = trial.run / "plan.json"
    for change in (flipped, edited(_more_repeats), lambda data: data.replace(b"\n", b" \n", 1)):
        with changed(path, change):
            with pytest.raises(BadInput) as refused:
                frozen_plan(attempted)
            with pytest.raises(BadInput):
                rescore(trial.run, policy_named(DEFAULT_POLICY))
        assert str(path) in told_of(refused.value, path, request, attempted)
    with changed(path, edited(_more_repeats)):
        done = c4s("run", "small", "-a", "noop", "--case", REPAIR, "--run-id", RUN, home=attempted)
    assert done.returncode == 2 and str(path) in done.stderr and len(done.stderr.strip().splitlines()) == 1


@pytest.mark.parametrize(("kind", "pattern", "change"), EVIDENCE, ids=names(EVIDENCE))
def test_changed_evidence_gets_no_verdict(
    gated: Path, trial: Trial, kind: str, pattern: str, change: Change, request: pytest.FixtureRequest
) -> None:
    plan, path = frozen_plan(gated), sorted(trial.folder.root.glob(pattern))[0]
    with changed(path, change):
        if pattern.startswith(("evidence/snapshot", "evidence/digests")):
            for name in ("physics", "repair"):
                with pytest.raises(BadInput):
                    stages.verify(trial, plan, name)
        with pytest.raises(BadInput) as refused:
            check_evidence(trial.folder)
    assert str(path) in told_of(refused.value, path, request, gated)
    assert trial.folder.verdicts.keys() == {"integrity"}


def test_pictures_that_were_not_taken_are_taken_by_the_stage_of_their_own(gated: Path, trial: Trial) -> None:
    evidence = trial.folder.evidence
    before = noted_digests(evidence)
    shutil.rmtree(evidence.captures)
    evidence.digests("look").unlink()
    stages.look(trial, frozen_plan(gated))
    check_evidence(trial.folder)
    assert noted_digests(evidence) == before and any(name.endswith(".png") for name in before)


def test_sound_evidence_of_another_scene_is_told(gated: Path, trial: Trial, tmp_path: Path) -> None:
    evidence = trial.folder.evidence.root
    shutil.copytree(evidence, tmp_path / "kept")
    start = SuiteFolder(trial.suite).agent(trial.case.alias) / "start.level.json"
    content, package = tmp_path / "content", Level.read(start).package
    (content / f"{package[1:]}.level.json").parent.mkdir(parents=True)
    shutil.copyfile(start, content / f"{package[1:]}.level.json")
    export_evidence(
        engine="headless", packs=[gated / "packs/c4s-home"], submission_content=content, package=package, out=evidence
    )
    with pytest.raises(BadInput, match=r"evidence/.*json: the file has changed"):
        stages.verify(trial, frozen_plan(gated), "physics")
    shutil.rmtree(evidence)
    shutil.copytree(tmp_path / "kept", evidence)


def test_changed_evidence_is_taken_again_from_the_submission(gated: Path, c4s: Command, trial: Trial) -> None:
    snapshot = trial.folder.evidence.snapshot
    before = snapshot.read_bytes()
    snapshot.write_bytes(flipped(before))
    done = c4s("run", "small", "-a", "noop", "--case", REPAIR, "--run-id", RUN, home=gated)
    assert done.returncode == 0 and "evidence.torn-" in done.stderr, done.stderr
    assert snapshot.read_bytes() == before
    assert TrialScore.read(trial.folder.score).status == "measured"
    assert AttemptOutcome.read(trial.folder.attempt(1).outcome).submission
