"""Templates are compiled once for the sources that they are of, and again where what was kept is damaged."""

from __future__ import annotations

from pathlib import Path

import pytest

from reports.frame import templates

PAGE = "case.html.j2"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where this test's templates are kept."""
    monkeypatch.setattr(templates, "_PACKAGE", tmp_path)
    return tmp_path / "__pycache__"


def compiled(folder: Path) -> dict[Path, bytes]:
    return {path: path.read_bytes() for path in folder.glob("templates-*/*")}


def test_a_template_is_compiled_once(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    templates.environment.__wrapped__().get_template(PAGE)
    kept = compiled(folder)
    assert kept
    again = templates.environment.__wrapped__()
    monkeypatch.setattr(again, "compile", None)
    assert again.get_template(PAGE).name == PAGE and compiled(folder) == kept


@pytest.mark.parametrize("damage", [b"", b"j2", b"nothing of the kind"])
def test_what_is_damaged_is_compiled_again(folder: Path, damage: bytes) -> None:
    templates.environment.__wrapped__().get_template(PAGE)
    kept = compiled(folder)
    for path in kept:
        path.write_bytes(path.read_bytes()[:40] + damage)
    assert templates.environment.__wrapped__().get_template(PAGE).name == PAGE
    assert compiled(folder) == kept


def test_other_sources_take_nothing_of_it(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    templates.environment.__wrapped__().get_template(PAGE)
    before = set(folder.iterdir())
    monkeypatch.setattr(templates, "code_digest", lambda: "of other sources")
    templates.environment.__wrapped__().get_template(PAGE)
    assert len(set(folder.iterdir()) - before) == 1


def test_pages_are_made_where_nothing_can_be_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(templates, "writable", lambda folder: False)
    assert templates.environment.__wrapped__().get_template(PAGE).name == PAGE
