"""A run of 0.1.0 is read as it lies; what is newer than known is refused.

``run-0.1.0.tar.xz`` is a home that the first version which ran a suite wrote: two cases, three baselines, with pictures
of 96 x 54 pixels and of its suite the two cases alone.
"""

from __future__ import annotations

import json
import tarfile
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from c4s.cli.main import app
from c4s.errors import BadInput
from c4s.files import digest, digest_file
from c4s.records.attempt import AttemptOutcome
from c4s.records.base import Record
from c4s.records.folder import RunFolder, TrialFolder
from c4s.records.level import Level
from c4s.records.migration import EARLY, STEPS
from c4s.records.plan import Plan
from c4s.records.schemas import FORMATS
from c4s.records.score import TrialScore
from c4s.records.suite import SuiteFolder
from warehouse.ingest import rebuild_from_run

KEPT = Path(__file__).parent / "run-0.1.0.tar.xz"
RUN, SUITE = "runs/starter", "suites/starter"
NUMBERED = {
    name: (model, known)
    for name, model in FORMATS.items()
    if issubclass(model, Record)
    and "schema_version" in model.model_fields
    and str(known := model.model_fields["schema_version"].default).startswith("c4s.")
}


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The home of 0.1.0, of which today's c4s has made warehouse and pages."""
    found = tmp_path_factory.mktemp("home")
    with tarfile.open(KEPT) as packed:
        packed.extractall(found, filter="data")
    before = listing(found)
    done = asked(found, "report")
    assert done.exit_code == 0, (done.output, done.exception)
    assert listing(found) == before
    return found


def listing(home: Path) -> dict[str, str]:
    """Every file of the run and of the suite."""
    return {str(path): digest_file(path) for top in (RUN, SUITE) for path in (home / top).rglob("*") if path.is_file()}


def asked(home: Path, *words: str) -> Result:
    return CliRunner(env={"C4S_HOME": str(home)}).invoke(app, list(words))


def test_its_scores_are_answered_as_they_were_written(home: Path) -> None:
    sql = "SELECT configuration, case_id, status, score, physics, repair_f1, detailed, attempts FROM outcomes"
    found = {
        (row["configuration"], row["case_id"]): row for row in json.loads(asked(home, "sql", sql, "--json").stdout)
    }
    trials = list(RunFolder(home / RUN).trials())
    assert len(trials) == len(found) == 6
    for trial in trials:
        written = json.loads(trial.score.read_text())
        row = found[written["configuration"], written["case_id"]]
        assert row["attempts"] == len(trial.attempts())
        assert {name: row[name] for name in ("status", "score", "physics", "repair_f1", "detailed")} == {
            name: written[name] for name in ("status", "score", "physics", "repair_f1", "detailed")
        }
    calls = json.loads(asked(home, "sql", "SELECT count(*) AS calls FROM calls", "--json").stdout)
    assert calls[0]["calls"] == sum(
        json.loads(line)["event"] == "call"
        for trial in trials
        for attempt in trial.attempts()
        for line in attempt.trajectory.read_text().splitlines()
    )


def test_it_is_listed_and_shown(home: Path) -> None:
    (row,) = json.loads(asked(home, "runs", "list", "--json").stdout)
    assert (row["run"], row["state"], row["done"], row["planned"]) == ("starter", "done", 6, 6)
    pages = [path for path in (home / "site").rglob("*.html") if "Flat for a family" in path.read_text()]
    assert pages


def test_who_refers_to_a_record_knows_it_by_what_was_written(home: Path) -> None:
    plan, suite = Plan.read(RunFolder(home / RUN).plan), SuiteFolder(home / SUITE).suite()
    assert suite.sha256() == plan.suite_digest == digest(json.loads((home / SUITE / "suite.json").read_text()))
    assert suite.model_copy(update={"title": "Another"}).sha256() != plan.suite_digest
    assert [case.alias for case in plan.cases] == [case.case_id for case in plan.cases]


def test_a_record_of_today_is_not_read_without_its_digest(home: Path, tmp_path: Path) -> None:
    trial = next(RunFolder(home / RUN).trials())
    for kind, path in ((TrialScore, trial.score), (AttemptOutcome, trial.attempts()[0].outcome)):
        bare = tmp_path / path.name
        record: Record = kind.read(path)
        bare.write_text(json.dumps(record.plain()))
        with pytest.raises(BadInput, match=r"changed|no digest"):
            kind.read(bare)


def test_a_verdict_that_was_changed_since_is_found(home: Path, tmp_path: Path) -> None:
    with tarfile.open(KEPT) as packed:
        packed.extractall(tmp_path, filter="data")
    trial = TrialFolder(tmp_path / RUN / "oracle/indoor-flat-01-mirrored-bath/r1")
    snapshot = trial.evidence.snapshot
    snapshot.write_bytes(snapshot.read_bytes().replace(b'"Bathtub_01"', b'"Bathtub_00"'))
    left_out = rebuild_from_run(
        tmp_path / RUN, tmp_path / SUITE, tmp_path / "warehouse", wanted=lambda one, _: one.folder.root == trial.root
    )
    assert [str(snapshot) in error.line() for error in left_out] == [True]


@pytest.mark.parametrize("name", NUMBERED)
def test_what_is_newer_than_known_is_refused(name: str, tmp_path: Path) -> None:
    model, known = NUMBERED[name]
    series, _, number = known.rpartition(".v")
    path = tmp_path / "record.json"
    newer = f"{series}.v{int(number) + 1}"
    value = {"schema_version": newer, "new": 1}
    path.write_text(json.dumps({**value, "sha256": digest(value)}, indent=1) + "\n")
    with pytest.raises(BadInput) as refused:
        model.read(path)
    line = refused.value.line()
    assert known in line and "\n" not in line
    assert newer in line or model is Level


def test_a_run_that_is_newer_hides_no_other(home: Path) -> None:
    value = {"schema_version": "c4s.plan.v99"}
    newer = home / "runs/newer/plan.json"
    newer.parent.mkdir()
    newer.write_text(json.dumps({**value, "sha256": digest(value)}, indent=1) + "\n")
    try:
        done = asked(home, "runs", "list", "--json")
        assert [row["run"] for row in json.loads(done.stdout)] == ["starter"]
        assert isinstance(done.exception, BadInput) and "c4s.plan.v99" in done.exception.line()
    finally:
        newer.unlink()
        newer.parent.rmdir()


def test_every_step_leads_to_a_format_that_is_known() -> None:
    known = {known for _, known in NUMBERED.values()}
    assert set(EARLY) <= known
    for schema in STEPS:
        series, _, number = schema.rpartition(".v")
        assert f"{series}.v{int(number) + 1}" in known | set(STEPS)


def test_a_format_that_nothing_leads_on_from_says_so() -> None:
    model, known = NUMBERED["backup"]
    with pytest.raises(BadInput, match=r"c4s\.backup\.v1, which this c4s no longer reads"):
        model.parse({"schema_version": "c4s.backup.v1"})
    assert known == "c4s.backup.v2"
