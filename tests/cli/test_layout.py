"""Tables at terminals of two widths: no number and no word is folded, and each group tells its rows apart."""

from __future__ import annotations

import pytest

from c4s.cli import output
from c4s.cli.layout import GAP, laid_out, narrowest
from c4s.numbers import half_up

TITLES = ["suite", "build", "judge", "configuration", *(f"score {place} of_part_{place}" for place in range(12))]


def rows(configurations: int) -> list[list[str]]:
    return [
        ["starter", "c1f4e31b" * 8, judge, f"agent-{place:02}", *(f"0.{place + score:03}" for score in range(12))]
        for judge in ("rule", "other")
        for place in range(configurations)
    ]


@pytest.mark.parametrize("width", [80, 120])
def test_wide_tables_come_in_groups_with_their_keys(width: int, monkeypatch: pytest.MonkeyPatch) -> None:
    laid = laid_out(TITLES, rows(14), width)
    assert laid.same == [0, 1] and laid.keys == [2, 3] and len(laid.groups) > 1
    assert [place for group in laid.groups for place in group] == list(range(4, 16))
    for group in laid.groups:
        shown = [*laid.keys, *group]
        widths = [narrowest(TITLES[place], [row[place] for row in rows(14)]) for place in shown]
        assert sum(widths) + GAP * (len(shown) - 1) <= width
    monkeypatch.setattr(output.console, "width", width)
    with output.console.capture() as told:
        output.print_table(TITLES, rows(14))
    lines = told.get().splitlines()
    assert max(map(len, lines)) <= width
    words = told.get().split()
    assert all(word in words for title in TITLES for word in title.split()) and words.count("agent-13") == 2 * len(
        laid.groups
    )
    assert words.count("0.013") == sum(row.count("0.013") for row in rows(14))
    assert "c1f4e31bc1f4…," in words or "c1f4e31bc1f4…" in words


def test_few_rows_are_told_column_by_column_and_long_tables_are_cut(monkeypatch: pytest.MonkeyPatch) -> None:
    assert not laid_out(TITLES, rows(1), 80).groups
    assert laid_out(["a", "b"], [["1", "2"]], 80).groups == [[0, 1]]
    output.print_table(["a"], [[place] for place in range(100)], most=10)


def test_one_number_is_rounded_in_one_way() -> None:
    assert output.cell(0.0875) == half_up(0.0875, 3) == "0.088"
    assert half_up(0.35 / 4, 3) == "0.088" and half_up(-0.0005, 3) == "-0.001" and half_up(float("nan"), 3) == "nan"
