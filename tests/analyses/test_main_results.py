"""The main table over a warehouse of known truth: coverage gate, ranks, intervals, replay to the last digit."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest

from bench.made_warehouse import PUBLIC_SET, MadeWarehouse
from c4s.cli.main import command
from c4s.errors import BadInput
from c4s.home import analyses_root
from c4s.protocol.settings import INDOOR_REPAIR
from reports.site import build_site
from warehouse.analyses import STUDIES, StudyOptions, WantedScope, answer, folder_of, replay, study_named

ABILITIES = (0.75, 0.6, 0.6, 0.45, 0.3)


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> MadeWarehouse:
    warehouse = MadeWarehouse(
        tmp_path_factory.mktemp("warehouse"), ABILITIES, pending=frozenset({("agent-05", "indoor-03")})
    )
    warehouse.write()
    return warehouse


def ask(made: MadeWarehouse, place: Path, **options: object):
    wanted = WantedScope()
    return answer(made.root, study_named("main-results"), wanted, StudyOptions.parse(options), place)


def test_the_order_is_by_score_and_a_pending_trial_stands_apart(made: MadeWarehouse, tmp_path: Path) -> None:
    main, apart = ask(made, tmp_path).findings.tables
    assert main.column("configuration")[0] == "agent-01" and main.column("rank") == [1, 2, 3, 4]
    assert main.column("s_model") == sorted(main.column("s_model"), reverse=True)
    assert [row["configuration"] for row in apart.rows] == ["agent-05"]
    assert apart.rows[0]["resolved"] == apart.rows[0]["planned"] - 1


def test_scores_are_means_of_cases_joined_by_the_adopted_weights(made: MadeWarehouse, tmp_path: Path) -> None:
    rows = {row["configuration"]: row for row in ask(made, tmp_path).findings.tables[0].rows}
    parts = pq.read_table(made.root / "outcomes/suite=made/configuration=agent-01").to_pandas()
    repairs = parts[parts["setting"] != PUBLIC_SET[0][0]]
    row = rows["agent-01"]
    assert row["s_i2s"] == pytest.approx(repairs["score"].mean(), abs=1e-12)
    assert row["repair_f1"] == pytest.approx(repairs["repair_f1"].mean(), abs=1e-12)
    assert row["s_t2s"] == pytest.approx(0.8 * row["semantic"] + 0.2 * row["physical_t2s"], abs=1e-12)
    assert row["s_model"] == pytest.approx((row["s_t2s"] + row["s_i2s"]) / 2, abs=1e-12)


def test_intervals_hold_the_score_and_say_how_they_were_made(made: MadeWarehouse, tmp_path: Path) -> None:
    findings = ask(made, tmp_path, draws=2000).findings
    (how,) = findings.intervals
    assert how.honest and (how.draws, how.seed) == (2000, 23917) and how.clusters[INDOOR_REPAIR] == 9
    for row in findings.tables[0].rows:
        for name in ("s_t2s", "s_i2s", "s_model", "repair_f1"):
            assert row[f"{name}_low"] < row[name] < row[f"{name}_high"]
        assert row["rank_low"] <= row["rank"] <= row["rank_high"]


def test_an_answer_is_given_again_to_the_last_digit(made: MadeWarehouse, tmp_path: Path) -> None:
    result = ask(made, tmp_path, draws=500)
    kept, again = replay(tmp_path, result.identity(), STUDIES)
    assert kept == result == again
    path = folder_of(result, tmp_path) / "trials.parquet"
    table = pq.read_table(path)
    changed = table.set_column(
        table.column_names.index("score"), "score", [np.nextafter(table["score"].to_numpy(), 1.0)]
    )
    pq.write_table(changed, path)
    with pytest.raises(BadInput, match="not the rows of the answer"):
        replay(tmp_path, result.identity(), STUDIES)


def test_a_replay_says_when_the_code_is_another(
    made: MadeWarehouse, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("C4S_HOME", str(tmp_path))
    result = ask(made, analyses_root(), draws=500)
    told = "Other code computed this again"
    command()(["analyze", "replay", result.identity()], prog_name="c4s", standalone_mode=False)
    assert "the same to the last digit" in (out := capsys.readouterr().out) and told not in out
    older = result.model_copy(update={"made_by": "0.0.1+0123456789ab"})
    older.write(folder_of(result, analyses_root()) / "analysis.json")
    command()(["analyze", "replay", result.identity()], prog_name="c4s", standalone_mode=False)
    assert told in (out := capsys.readouterr().out) and "0.0.1+0123456789ab" in out


def test_a_seed_that_json_cannot_hold_is_refused(made: MadeWarehouse, tmp_path: Path) -> None:
    result = ask(made, tmp_path, draws=100, seed=2**53 - 1)
    assert replay(tmp_path, result.identity(), STUDIES)[1] == result
    with pytest.raises(BadInput, match="'seed'"):
        ask(made, tmp_path, draws=100, seed=2**53)


def test_few_sources_give_no_interval(tmp_path: Path) -> None:
    few = MadeWarehouse(tmp_path / "few", (0.5, 0.4), shape=[(setting, 8, 4) for setting, *_ in PUBLIC_SET])
    few.write()
    findings = ask(few, tmp_path / "answers").findings
    assert not findings.intervals[0].honest and "4 source scenes" in findings.intervals[0].proviso
    assert all("s_model_low" not in row for row in findings.tables[0].rows)


def test_one_domain_alone_has_no_score_to_show_and_is_no_fault(tmp_path: Path) -> None:
    alone = MadeWarehouse(tmp_path / "alone", (0.5, 0.4), shape=PUBLIC_SET[1:2])
    alone.write()
    findings = ask(alone, tmp_path / "answers").findings
    assert [row["configuration"] for row in findings.tables[0].rows] == ["agent-01", "agent-02"]
    assert not findings.charts and "both domains" in findings.notes[0]
    assert "agent-01" in build_site(alone.root, tmp_path / "site").read_text()


@pytest.mark.parametrize(
    ("options", "wanted", "words"),
    [
        ({"agents": ["agent-77"]}, {}, "did you mean"),
        ({"holm": True}, {}, "takes no option 'holm'"),
        ({"agents": ["agent-05"]}, {}, "no configuration is complete"),
        ({}, {"judge": "nobody"}, "unknown judge 'nobody'"),
        ({}, {"suite_digest": "e"}, "unknown build"),
    ],
)
def test_what_cannot_be_answered_is_refused(made, tmp_path, options, wanted, words) -> None:
    with pytest.raises(BadInput, match=words):
        answer(made.root, study_named("main-results"), WantedScope.parse(wanted), StudyOptions.parse(options), tmp_path)
    assert not list(tmp_path.iterdir())


def test_results_of_two_judges_are_not_mixed(tmp_path: Path) -> None:
    two = MadeWarehouse(tmp_path / "two", (0.5, 0.4), judges=("one", "other"))
    two.write()
    with pytest.raises(BadInput, match="results of 2 judges: one, other"):
        ask(two, tmp_path / "answers")
