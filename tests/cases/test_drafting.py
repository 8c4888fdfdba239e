"""Descriptions drafted by a model on loopback from pictures, through the command line."""

from __future__ import annotations

import base64
import json
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from c4s.errors import BadInput
from cases.drafting import MOST_PICTURES, draft_description
from tests.cases.model_endpoint import Raw, completion, model_endpoint
from tests.cases.test_requirements_command import c4s

GOOD = " ".join(["A stone well stands in the middle of a small yard of trodden earth, with two barrels beside it."] * 4)
"""As short as a description may be, nearly."""


@pytest.fixture(scope="module")
def pictures(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    folder = tmp_path_factory.mktemp("pictures")
    for name, colour in (("a.png", "red"), ("b.jpg", "blue")):
        Image.new("RGB", (64, 36), colour).save(folder / name)
    return [folder / "a.png", folder / "b.jpg"]


def drafted(home: Path, pictures: list[Path], out: Path, answers: list[Any], *more: str) -> tuple[Any, list[Any]]:
    with model_endpoint(answers) as endpoint:
        endpoint.describe(home)
        asked = ("suite", "draft-prompt", *pictures, "--model", "m", "--endpoint", "near", "--out", out, *more)
        return c4s(home, *asked), endpoint.bodies


def test_a_model_sees_the_pictures_and_is_told_what_is_wrong(pictures: list[Path], tmp_path: Path) -> None:
    out = tmp_path / "yard.txt"
    bad = ["Too short.", f"# A yard\n\n{GOOD}", f"In the picture there is this. {GOOD}", f"  {GOOD}\n"]
    found, bodies = drafted(tmp_path / "home", pictures, out, bad, "--about", "a farm yard", "--json")
    assert found.returncode == 0, found.stderr
    told = json.loads(found.stdout)
    assert (told["answers"], told["words"], len(told["faults"])) == (4, len(GOOD.split()), 3)
    assert out.read_text() == GOOD + "\n"
    words, *shown = bodies[0]["messages"][1]["content"]
    assert "a farm yard" in words["text"]
    sent = [base64.b64decode(part["image_url"]["url"].split(",")[1]) for part in shown]
    assert sent == [picture.read_bytes() for picture in pictures]
    for body, said in zip(bodies[1:], ("2 words", "headings", "in the picture"), strict=True):
        assert said in body["messages"][-1]["content"] and len(body["messages"]) == 4


@pytest.mark.parametrize(
    ("answers", "code", "said"),
    [
        (["short"], 3, "no description"),
        ([completion(GOOD, finish="length")], 3, "output limit"),
        ([""], 3, "empty"),
        ([Raw(b'{"error": {"message": "no pictures here"}}', 400)], 2, "no pictures here"),
    ],
)
def test_nothing_is_written_where_no_answer_is_any_good(
    answers: list[Any], code: int, said: str, pictures: list[Path], tmp_path: Path
) -> None:
    out = tmp_path / "yard.txt"
    found, _ = drafted(tmp_path / "home", pictures, out, answers, "--repairs", "1")
    assert found.returncode == code and said in found.stderr and not out.exists()


def test_what_is_no_picture_is_never_sent(pictures: list[Path], tmp_path: Path) -> None:
    (tmp_path / "cut.png").write_bytes(pictures[0].read_bytes()[:40])
    (tmp_path / "x.txt").write_text("no")

    def never(body: object) -> Any:
        raise AssertionError(body)

    for wrong in ([], [tmp_path / "cut.png"], [tmp_path / "x.txt"], [tmp_path / "no.png"], pictures * MOST_PICTURES):
        with pytest.raises(BadInput):
            draft_description(wrong, "m", never)
