"""A human study from a run to the opened holdout: what annotators get, what is taken, what is refused."""

from __future__ import annotations

import json
from collections.abc import Callable
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from c4s.cli.main import command
from c4s.errors import BadInput
from c4s.human import IntakeFault, OpenStudy, agreement, design_study, evaluate, fit_study, study_named, take
from c4s.human.components import scene_of, weights_of
from c4s.protocol.criteria import CRITERIA, PRIMARY, SPLIT_SEED
from c4s.records.human import AnnotatorSheet, FrozenFit, HumanStudy
from c4s.score.policies import POLICIES
from c4s.score.rescore import rescore
from c4s.stats.human import SubscoreWeights, score_under
from tests.built import built_once
from tests.human.made_study import AGENTS, PROMPTS, answers, make_run, write_answers

SEVEN = AGENTS[:7]
PEOPLE = [f"person-{number}" for number in range(1, 8)]
TASTE = SubscoreWeights(
    {"identity_environment": 0.10, "content_quantity": 0.20, "attributes_materials": 0.10, "spatial_composition": 0.60},
    {
        "global_prompt_alignment": 0.10,
        "composition_and_layout": 0.10,
        "style_atmosphere_coherence": 0.70,
        "completeness_and_polish": 0.10,
    },
    {"floating": 0.1, "solid_penetration": 0.9},
    {"detailed": 0.5, "physics": 0.2, "overview": 0.3},
)


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run of 16 prompts by eight agents; for reading."""
    return built_once(tmp_path_factory, "human-home", make_run)


Make = Callable[..., OpenStudy]


@pytest.fixture
def make(home: Path, tmp_path: Path) -> Make:
    """Makes a study of the run."""

    def made(**changes: Any) -> OpenStudy:
        given: dict[str, Any] = {"agents": SEVEN, "cases": [], "annotators": PEOPLE, "criteria": [], "seed": SPLIT_SEED}
        design_study(home / "runs" / "night", home / "suites", tmp_path / "study", **{**given, **changes})
        return study_named(tmp_path, "study")

    return made


def worths(opened: OpenStudy, taste: SubscoreWeights) -> dict[str, float]:
    """What each candidate is worth to people of a taste."""
    saved = [one for part in ("development", "holdout") for one in opened.saved(part).candidates]
    return {one.candidate: score_under(scene_of(one), taste) for one in saved}


@pytest.fixture
def answered(make: Make, tmp_path: Path) -> OpenStudy:
    """A study whose annotators answered everything, hardly ever wrong."""
    opened = make()
    take(opened, write_answers(tmp_path / "all.jsonl", answers(opened, worths(opened, TASTE), 60.0)))
    return opened


def test_the_design_is_the_papers(make: Make) -> None:
    opened = make()
    study = opened.study
    assert (len(study.prompts), len(study.tasks), study.expected([p.case_id for p in study.prompts])) == (16, 112, 336)
    assert (len(study.development), len(study.holdout)) == (12, 4)
    assert sorted(study.development + study.holdout) == sorted(prompt.case_id for prompt in study.prompts)
    for prompt in study.prompts:
        assert [one.configuration for one in prompt.candidates] == SEVEN
        own = [task for task in study.tasks if task.case_id == prompt.case_id]
        for points in ([task.candidates for task in own], [task.annotators for task in own]):
            pairs = [frozenset(pair) for block in points for pair in combinations(block, 2)]
            assert len(pairs) == len(set(pairs)) == 21
    assert HumanStudy.read(opened.folder.study) == study


def test_an_annotator_sees_no_agent_no_score_and_no_answer(make: Make) -> None:
    """Not in what the sheets say, not in the names of what lies beside them."""
    opened = make(criteria=["spatial-composition"])
    root, study = opened.folder.root, opened.study
    given = [path for folder in ("annotators", "pictures") for path in (root / folder).rglob("*") if path.is_file()]
    assert len(given) == 7 + 16 * 7 * 4
    told = [str(path.relative_to(root)) for path in given]
    told += [path.read_text() for path in given if path.suffix == ".json"]
    hidden = {*SEVEN, study.run_id, study.judge_version, study.suite_digest, study.policy}
    hidden |= {prompt.case_id for prompt in study.prompts}
    hidden |= {one.trial for prompt in study.prompts for one in prompt.candidates}
    hidden |= {str(one.score) for part in ("development", "holdout") for one in opened.saved(part).candidates}
    assert not [word for word in hidden - {""} for text in told if word in text]
    for name in study.annotators:
        sheet = AnnotatorSheet.read(opened.folder.sheet(name))
        assert not {other for other in PEOPLE if other != name} & set(sheet.model_dump_json().split('"'))
        assert len(sheet.tasks) == 2 * 48 and {task.criterion for task in sheet.tasks[:48]} == {PRIMARY}
        for task in sheet.tasks:
            assert len({one.candidate for one in task.candidates}) == 3 and "PALETTE" not in task.prompt
            assert all((root / picture).is_file() for one in task.candidates for picture in one.pictures)
            assert all(len(one.pictures) == 4 for one in task.candidates)


def test_candidates_names_and_places_do_not_tell_the_agent(make: Make) -> None:
    """Each agent is shown in each of the three places about as often, and ids sort the agents in many ways."""
    study = make().study
    agent = {one.candidate: one.configuration for prompt in study.prompts for one in prompt.candidates}
    places = {(name, at): 0 for name in SEVEN for at in range(3)}
    for task in study.tasks:
        for at, candidate in enumerate(task.candidates):
            places[agent[candidate], at] += 1
    assert min(places.values()) >= 8 and sum(places.values()) == 336
    orders = {tuple(agent[one] for one in sorted(c.candidate for c in p.candidates)) for p in study.prompts}
    assert len(orders) == PROMPTS


def test_saved_components_give_every_stored_score_and_every_rescoring_again(home: Path, make: Make) -> None:
    """Under the adopted weights and both published fits: the components, and the verdicts scored again."""
    opened = make()
    saved = {one.candidate: one for part in ("development", "holdout") for one in opened.saved(part).candidates}
    for policy in ("code4scene-published", "human-fit-individual", "human-fit-consensus"):
        shipped = POLICIES[policy]
        weights = SubscoreWeights(
            {**shipped.families}, shipped.overview, shipped.leaves("text-to-scene"), shipped.text_to_scene
        )
        again = {name: new.score for name, _, new in rescore(home / "runs" / "night", shipped).pairs}
        for prompt in opened.study.prompts:
            for one in prompt.candidates:
                name = f"{one.configuration}/{prompt.case_id}/r1"
                assert score_under(scene_of(saved[one.candidate]), weights) == again[name]


def test_a_study_goes_from_answers_to_an_opened_holdout(answered: OpenStudy) -> None:
    """Annotators of a taste far from the adopted weights: fits find it, and hold on prompts that they did not see."""
    fits = {labels: fit_study(answered, labels) for labels in ("individual", "consensus")}
    for frozen in fits.values():
        assert frozen.agreement > frozen.comparison_agreement
        assert (frozen.saw, frozen.holdout) == (answered.study.development, answered.study.holdout)
        assert weights_of(frozen.weights).hundredths()[-2] == 20
    found = evaluate(answered)
    tables = {table.name: table for table in found.findings.tables}
    rows = {row["policy"]: row for row in tables["policies"].rows}
    assert set(rows) == {"adopted", "individual fit", "consensus fit"}
    adopted, fitted = rows["adopted"], rows["individual fit"]
    assert float(fitted["holdout_consensus"]) > float(adopted["holdout_consensus"])
    assert float(fitted["dev_individual"]) == pytest.approx(fits["individual"].agreement)
    for row in rows.values():
        assert float(row["holdout_tau"]) == pytest.approx(2 * float(row["holdout_consensus"]) - 1, abs=0.03)
    assert {row["prompts of"]: row["prompts"] for row in tables["people"].rows} == {
        "all": 16,
        "development": 12,
        "holdout": 4,
    }
    assert not found.findings.intervals[0].honest and len(tables["weights"].rows) == 13
    assert evaluate(answered) == found


def test_no_holdout_without_a_frozen_fit(answered: OpenStudy) -> None:
    with pytest.raises(BadInput, match="no weights are frozen"):
        evaluate(answered)
    assert not answered.is_opened()


def test_a_fit_does_not_read_the_holdout(answered: OpenStudy) -> None:
    """Without the holdout's folder it gives the same weights."""
    frozen = fit_study(answered, "individual")
    answered.folder.fit("individual").unlink()
    hidden = answered.folder.root.parent / "hidden"
    (answered.folder.root / "holdout").rename(hidden)
    assert fit_study(answered, "individual") == frozen


def test_after_the_holdout_is_open_nothing_is_fitted_and_nothing_is_taken(answered: OpenStudy, tmp_path: Path) -> None:
    frozen = fit_study(answered, "individual")
    evaluate(answered)
    assert fit_study(answered, "individual") == frozen
    with pytest.raises(BadInput, match="could have seen it"):
        fit_study(answered, "consensus")
    with pytest.raises(BadInput, match="no ranking is taken any more"):
        take(answered, write_answers(tmp_path / "late.jsonl", []))
    frozen.model_copy(update={"labels": "consensus"}).write(answered.folder.fit("consensus"))
    with pytest.raises(BadInput, match="other fits"):
        evaluate(answered)


def test_a_fit_that_saw_the_holdout_or_was_changed_is_refused(answered: OpenStudy) -> None:
    frozen = fit_study(answered, "individual")
    path = answered.folder.fit("individual")
    seen = {**frozen.plain(), "saw": [*frozen.saw, frozen.holdout[0]]}
    with pytest.raises(BadInput, match="has seen the holdout prompt"):
        FrozenFit.parse(seen)
    moved = frozen.model_copy(update={"saw": [*frozen.saw[1:], frozen.holdout[0]], "holdout": frozen.holdout[1:]})
    moved.write(path)
    with pytest.raises(BadInput, match="not made of the development prompts"):
        evaluate(answered)
    frozen.model_copy(update={"rankings_sha256": "0" * 64}).write(path)
    with pytest.raises(BadInput, match="other rankings"):
        evaluate(answered)
    frozen.write(path)
    path.write_text(path.read_text().replace('"passes": ', '"passes": 1'))
    with pytest.raises(BadInput, match="changed since it was written"):
        evaluate(answered)
    assert not answered.is_opened()


def test_kept_answers_that_were_changed_are_refused(answered: OpenStudy) -> None:
    path, other = (answered.folder.rankings(part) for part in ("development", "holdout"))
    whole, held = path.read_text(), other.read_text()
    first, *rest = whole.splitlines(keepends=True)
    row = json.loads(first)
    stranger = json.dumps({**row, "annotator": "person-9"}) + "\n"
    foreign = json.dumps({**row, "order": [*row["order"][:2], "0000000000"]}) + "\n"
    empty = json.dumps({**row, "order": []}) + "\n"
    swapped = held.splitlines(keepends=True)[0]
    for line, lines in ((2, [first, first, *rest[1:]]), *((1, [one, *rest]) for one in (stranger, foreign, swapped))):
        path.write_text("".join(lines))
        with pytest.raises(BadInput, match=f"line {line} is no answer that was taken for a development prompt"):
            fit_study(answered, "individual")
    for lines in ([empty, *rest], [first.replace('"order"', '"orders"', 1), *rest]):
        path.write_text("".join(lines))
        with pytest.raises(BadInput):
            agreement(answered, PRIMARY)
    path.write_text(held)
    other.write_text(whole)
    with pytest.raises(BadInput, match="line 1 is no answer"):
        agreement(answered, PRIMARY)


def test_a_missing_ranking_keeps_a_fit_and_the_holdout_back(make: Make, tmp_path: Path) -> None:
    opened = make()
    rows = answers(opened, worths(opened, TASTE), 60.0)
    tasks = {task.task: task.case_id in opened.study.holdout for task in opened.study.tasks}
    held = [row for row in rows if tasks[row["task"]]]
    seen = [row for row in rows if not tasks[row["task"]]]
    assert take(opened, write_answers(tmp_path / "a.jsonl", [*seen[1:], *held[2:]])).missing == {
        "development": 1,
        "holdout": 2,
    }
    with pytest.raises(BadInput, match="1 of 252 rankings of the development prompts are missing"):
        fit_study(opened, "individual")
    take(opened, write_answers(tmp_path / "b.jsonl", seen[:1]))
    fit_study(opened, "individual")
    with pytest.raises(BadInput, match="2 of 84 rankings of the holdout prompts are missing"):
        evaluate(opened)
    assert not opened.is_opened()


def test_each_wrong_line_is_told_and_then_none_is_taken(make: Make, tmp_path: Path) -> None:
    opened = make()
    rows = answers(opened, worths(opened, TASTE), 60.0)
    first, second = rows[:2]
    a, b, c = first["order"]
    other = next(row for row in rows if not set(row["order"]) & {a, b, c})
    stranger = next(name for name in PEOPLE if name not in _task(opened, first["task"]).annotators)
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"order": []}, "abstention"),
        ({"order": None}, "abstention"),
        ({"order": [a, b]}, f"candidate {c!r} is not ranked"),
        ({"order": [a, [b, c]]}, "a tie"),
        ({"order": [a, b, b]}, f"candidate {b!r} is ranked twice"),
        ({"order": [a, b, other["order"][0]]}, "is not in task"),
        ({"order": [a, b, c, "nosuch"]}, "candidate 'nosuch' is not in task"),
        ({"annotator": stranger}, f"is not {stranger}'s"),
        ({"annotator": "nobody"}, "unknown annotator 'nobody'"),
        ({"task": "nosuch"}, "unknown task 'nosuch'"),
        ({"study": "another"}, "of the study 'another'"),
        ({"criterion": "content-and-quantity"}, "does not ask for 'content-and-quantity'"),
        ({"criterion": "beauty"}, "criterion"),
        ({"more": 1}, "no such field"),
    ]
    lines = [{**first, **change} for change, _ in wrong]
    found = take(opened, write_answers(tmp_path / "a.jsonl", [second, *lines, second]))
    assert [fault.line for fault in found.faults] == list(range(2, len(wrong) + 3)) and found.taken == 0
    for fault, (_, says) in zip(found.faults, wrong, strict=False):
        assert says in fault.fault and "\n" not in fault.fault
    assert found.faults[-1] == IntakeFault(len(wrong) + 2, "line 1 answers the same task")
    assert found.missing == {"development": 252, "holdout": 84}
    found = take(opened, write_answers(tmp_path / "b.jsonl", rows))
    assert (found.taken, found.there, found.faults) == (336, 0, [])
    assert (take(opened, tmp_path / "b.jsonl").there, opened.rankings_digest("development")) == (
        336,
        opened.rankings_digest("development"),
    )
    changed = take(opened, write_answers(tmp_path / "c.jsonl", [{**first, "order": [c, b, a]}, second]))
    assert [fault.fault for fault in changed.faults] == [
        f"task {first['task']} has another answer of {first['annotator']} already"
    ]


def _task(opened: OpenStudy, name: str) -> Any:
    return next(task for task in opened.study.tasks if task.task == name)


def test_the_order_in_which_answers_come_changes_nothing(make: Make, tmp_path: Path) -> None:
    opened = make()
    rows = answers(opened, worths(opened, TASTE), 60.0)
    for at in range(0, len(rows), 100):
        take(opened, write_answers(tmp_path / "a.jsonl", rows[::-1][at : at + 100]))
    digests = [opened.rankings_digest(part) for part in ("development", "holdout")]
    for part in ("development", "holdout"):
        opened.folder.rankings(part).unlink()
    take(opened, write_answers(tmp_path / "a.jsonl", rows))
    assert [opened.rankings_digest(part) for part in ("development", "holdout")] == digests


def test_who_clicks_at_random_is_named(home: Path, make: Make, tmp_path: Path) -> None:
    cases = [f"place-{number:02}" for number in range(8)]
    opened = make(cases=cases)
    rows = answers(opened, worths(opened, TASTE), 60.0, clickers={"person-3"})
    take(opened, write_answers(tmp_path / "a.jsonl", rows))
    steps: list[str] = []
    found = agreement(opened, PRIMARY, lambda what, done, of: steps.append(what))
    tables = {table.name: table for table in found.tables}
    assert [row["annotator"] for row in tables["annotators"].rows if row["like chance"]] == ["person-3"]
    assert len(tables["people"].rows) == 12 and len(set(steps)) == 2
    with pytest.raises(BadInput, match="no ranking by 'physical-plausibility'"):
        agreement(opened, "physical-plausibility")


def test_diagnostic_rankings_stand_beside_their_part_and_never_enter_the_fit(make: Make, tmp_path: Path) -> None:
    cases = [f"place-{number:02}" for number in range(4)]
    opened = make(cases=cases, criteria=list(CRITERIA))
    rows = answers(opened, worths(opened, TASTE), 60.0)
    primary = [row for row in rows if row["criterion"] == PRIMARY]
    assert len(rows) == 7 * len(primary) == 7 * 84
    take(opened, write_answers(tmp_path / "a.jsonl", primary))
    frozen = fit_study(opened, "individual")
    take(opened, write_answers(tmp_path / "b.jsonl", [row for row in rows if row["criterion"] != PRIMARY]))
    assert fit_study(opened, "individual") == frozen
    table = next(table for table in evaluate(opened).findings.tables if table.name == "diagnostics")
    assert {row["part"] for row in table.rows} == {CRITERIA[name].part for name in CRITERIA if name != PRIMARY}
    assert len(table.rows) == 6 * 3


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"agents": []}, "a study compares 7 configurations, not 8"),
        ({"agents": SEVEN[:6]}, "not 6"),
        ({"agents": [*SEVEN[:6], "agent-z"]}, "unknown agent 'agent-z'"),
        ({"annotators": PEOPLE[:6]}, "7 annotators"),
        ({"annotators": [*PEOPLE[:6], "person-1"]}, "a name of their own"),
        ({"annotators": [*PEOPLE[:6], "../up"]}, "no name"),
        ({"cases": ["nosuch"]}, "unknown case"),
        ({"cases": ["place-01"]}, "1 cases"),
    ],
)
def test_a_study_that_cannot_be_balanced_is_refused(make: Make, changes: dict[str, Any], says: str) -> None:
    with pytest.raises(BadInput, match=says):
        make(**changes)


def test_a_case_that_cannot_be_shown_is_left_out_and_told(tmp_path: Path) -> None:
    run = make_run(tmp_path, prompts=4, agents=SEVEN)
    plan = json.loads((run / "plan.json").read_text())
    case = plan["cases"][1]
    (run / SEVEN[2] / case["alias"] / "r1" / "evidence" / "captures" / "overview-3.png").unlink()
    given: dict[str, Any] = {"agents": [], "annotators": PEOPLE, "criteria": [], "seed": 1}
    study, left_out = design_study(run, tmp_path / "suites", tmp_path / "human" / "one", cases=[], **given)
    assert len(study.prompts) == 3
    assert left_out == [f"{case['case_id']}: {SEVEN[2]} has not 4 overview pictures"]
    with pytest.raises(BadInput, match="cannot be shown"):
        design_study(run, tmp_path / "suites", tmp_path / "human" / "two", cases=[case["case_id"]], **given)
    with pytest.raises(BadInput, match="there is such a study"):
        design_study(run, tmp_path / "suites", tmp_path / "human" / "one", cases=[], **given)


def test_the_commands_do_the_whole_study(
    home: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("suites", "runs"):
        (tmp_path / "home").mkdir(exist_ok=True)
        (tmp_path / "home" / name).symlink_to(home / name)
    monkeypatch.setenv("C4S_HOME", str(tmp_path / "home"))

    def call(*words: str) -> Any:
        command()(["human", *words, "--json"], prog_name="c4s", standalone_mode=False)
        return json.loads(capsys.readouterr().out)

    agents = [word for name in SEVEN for word in ("-a", name)]
    cases = [word for number in range(4) for word in ("-c", f"place-{number:02}")]
    made = call("design", "night", "one", *agents, *cases)
    assert (len(made["tasks"]), made["left_out"]) == (28, [])
    opened = study_named(tmp_path / "home" / "human", "one")
    file = write_answers(tmp_path / "all.jsonl", answers(opened, worths(opened, TASTE), 60.0))
    assert call("intake", "one", str(file))["taken"] == 84
    assert {table["name"] for table in call("agreement", "one")["tables"]} == {"people", "annotators"}
    assert [one["labels"] for one in call("fit", "one")] == ["individual", "consensus"]
    assert np.isfinite(call("evaluate", "one")["findings"]["tables"][0]["rows"][0]["holdout_consensus"])
