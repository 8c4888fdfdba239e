"""What is taken, what is refused, and what a kill leaves."""

from __future__ import annotations

import json
import resource
from collections import Counter
from urllib.parse import urlsplit

import httpx
import pytest

from c4s.errors import BadInput
from c4s.human import AnswerLog, OpenStudy, RankingDesk, take
from c4s.protocol.criteria import CRITERIA, PRIMARY
from tests.study.conftest import PEOPLE, PROMPTS, Serve

ORDERS = [dict(zip(("best", "middle", "worst"), letters, strict=True)) for letters in ("ABC", "BCA", "CAB", "CBA")]


def answer_all(desk: RankingDesk, person: str) -> None:
    for number in range(desk.done(person) + 1, desk.count(person) + 1):
        desk.answer(person, number, ORDERS[number % len(ORDERS)])


@pytest.mark.parametrize(
    ("fields", "says"),
    [
        ({"best": "A", "middle": "A", "worst": "C"}, "no ties"),
        ({"best": "A", "middle": "B"}, "none left out"),
        ({}, "none left out"),
        ({"best": "A", "middle": "B", "worst": "D"}, "a place of its own"),
        ({**ORDERS[0], "more": "A"}, "a place of its own"),
    ],
)
def test_a_ranking_is_strict(study: OpenStudy, fields: dict[str, str], says: str) -> None:
    with AnswerLog(study.folder.answers) as log:
        desk = RankingDesk(study, log, "secret")
        with pytest.raises(BadInput, match=says):
            desk.answer(PEOPLE[0], 1, fields)
        assert log.rows == [] and desk.done(PEOPLE[0]) == 0


def test_an_answer_stands(study: OpenStudy) -> None:
    with AnswerLog(study.folder.answers) as log:
        desk = RankingDesk(study, log, "secret")
        desk.answer(PEOPLE[0], 1, ORDERS[0])
        desk.answer(PEOPLE[0], 1, ORDERS[0])
        with pytest.raises(BadInput, match="not changed"):
            desk.answer(PEOPLE[0], 1, ORDERS[1])
        with pytest.raises(BadInput, match="before this one"):
            desk.answer(PEOPLE[0], 3, ORDERS[1])
        assert len(log.rows) == 1


def test_answers_of_the_server_are_taken_in_as_they_are(study: OpenStudy) -> None:
    with AnswerLog(study.folder.answers) as log:
        desk = RankingDesk(study, log, "secret")
        for person in PEOPLE:
            answer_all(desk, person)
        of_one = PROMPTS * 3 * len(CRITERIA)
        assert [desk.done(person) for person in PEOPLE] == [of_one] * len(PEOPLE)
        assert {(row.done, row.of) for row in desk.progress()} == {(PROMPTS * 3, PROMPTS * 3)}
    found = take(study, study.folder.answers)
    assert (found.faults, found.taken) == ([], of_one * len(PEOPLE)) and set(found.missing.values()) == {0}


def test_the_letters_mean_what_the_screen_shows(study: OpenStudy) -> None:
    """The candidate whose picture is A is the one that ``A`` ranks."""
    with AnswerLog(study.folder.answers) as log:
        desk = RankingDesk(study, log, "secret")
        shown = {letter: desk.picture(PEOPLE[2], 1, f"{letter}-2") for letter in "ABC"}
        desk.answer(PEOPLE[2], 1, {"best": "C", "middle": "A", "worst": "B"})
        ranked = [study.folder.picture(candidate, 2).read_bytes() for candidate in log.rows[0]["order"]]
    assert ranked == [shown["C"], shown["A"], shown["B"]]


def test_each_candidate_is_as_often_left_as_right(study: OpenStudy) -> None:
    """Of nine rankings of a candidate by a criterion, three have it at each place."""
    places: Counter[tuple[str, str, int]] = Counter()
    with AnswerLog(study.folder.answers) as log:
        desk = RankingDesk(study, log, "another secret")
        for person in PEOPLE:
            for number in range(1, desk.count(person) + 1):
                desk.answer(person, number, ORDERS[0])
                row = log.rows[-1]
                places.update((row["criterion"], candidate, at) for at, candidate in enumerate(row["order"]))
    assert len(places) == PROMPTS * 7 * 3 * len(CRITERIA) and set(places.values()) == {3}


def test_the_primary_question_comes_first_and_each_criterion_in_a_block(study: OpenStudy) -> None:
    with AnswerLog(study.folder.answers) as log:
        desk = RankingDesk(study, log, "secret")
        titles = [desk.question(PEOPLE[0], number)["title"] for number in range(1, desk.count(PEOPLE[0]) + 1)]
    assert list(dict.fromkeys(titles)) == [one.title for one in CRITERIA.values()]
    assert titles == sorted(titles, key=list(dict.fromkeys(titles)).index)
    assert titles[0] == CRITERIA[PRIMARY].title


def test_a_line_that_a_crash_cut_off_is_asked_again(study: OpenStudy) -> None:
    with AnswerLog(study.folder.answers) as log:
        desk = RankingDesk(study, log, "secret")
        desk.answer(PEOPLE[0], 1, ORDERS[0])
        desk.answer(PEOPLE[0], 2, ORDERS[0])
    whole = study.folder.answers.read_bytes()
    for left in range(whole.index(b"\n") + 1, len(whole)):
        study.folder.answers.write_bytes(whole[:left])
        with AnswerLog(study.folder.answers) as log:
            assert RankingDesk(study, log, "secret").done(PEOPLE[0]) == 1
    with AnswerLog(study.folder.answers) as log:
        RankingDesk(study, log, "secret").answer(PEOPLE[0], 2, ORDERS[0])
    assert study.folder.answers.read_bytes() == whole


def test_one_server_at_a_time_takes_answers(study: OpenStudy) -> None:
    with AnswerLog(study.folder.answers), pytest.raises(BadInput, match="another server"):
        AnswerLog(study.folder.answers)


def test_an_answer_that_the_disk_refuses_is_not_in_the_file(study: OpenStudy) -> None:
    """A limit on the size of files stands for a full disk."""
    with AnswerLog(study.folder.answers) as kept:
        desk = RankingDesk(study, kept, "secret")
        desk.answer(PEOPLE[0], 1, ORDERS[0])
        before = study.folder.answers.read_bytes()
        limits = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (len(before) + 10, limits[1]))
        try:
            with pytest.raises(OSError):
                desk.answer(PEOPLE[0], 2, ORDERS[0])
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        assert study.folder.answers.read_bytes() == before and desk.done(PEOPLE[0]) == 1
        desk.answer(PEOPLE[0], 2, ORDERS[0])


def test_an_open_holdout_ends_the_asking(study: OpenStudy) -> None:
    with AnswerLog(study.folder.answers) as log:
        desk = RankingDesk(study, log, "secret")
        study.folder.opened.write_text("{}")
        with pytest.raises(BadInput, match="holdout"):
            desk.answer(PEOPLE[0], 1, ORDERS[0])
        with pytest.raises(BadInput, match="holdout"):
            RankingDesk(study, log, "secret")


def test_nonsense_is_no_answer(serve: Serve, study: OpenStudy) -> None:
    link = serve("serve", "yards").links[PEOPLE[0]]
    own = {"Origin": "{0.scheme}://{0.netloc}".format(urlsplit(link))}
    bodies = {b"best=A&best=B": 400, b"\xff=\xfe": 400, b"a=b&" * 40: 400, b"x" * 20_000: 413, b"": 422, b"best=A": 422}
    for body, status in bodies.items():
        assert httpx.post(f"{link}1", content=body, headers=own).status_code == status, body[:20]
    assert httpx.post(f"{link}5", content=b"best=A&middle=B&worst=C", headers=own).status_code == 409
    assert httpx.post(f"{link}0", content=b"", headers=own).status_code == 404
    assert httpx.put(f"{link}1", content=b"", headers=own).status_code == 405
    assert httpx.get(f"{link}2").headers["location"] == "next", "nobody looks ahead"
    assert httpx.get(f"{link}2/A-1.png").status_code == 404
    assert study.folder.answers.read_text() == ""


def test_the_file_only_grows(study: OpenStudy) -> None:
    seen = b""
    with AnswerLog(study.folder.answers) as log:
        desk = RankingDesk(study, log, "secret")
        for number in range(1, 6):
            desk.answer(PEOPLE[0], number, ORDERS[0])
            now = study.folder.answers.read_bytes()
            assert now.startswith(seen) and now.count(b"\n") == number
            assert json.loads(now.splitlines()[-1])["annotator"] == PEOPLE[0]
            seen = now
