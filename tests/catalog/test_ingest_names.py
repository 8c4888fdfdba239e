"""Names, sizes, pivots and licences of folders as people publish them: every file called ``model``."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from c4s.errors import BadInput
from c4s.records.pack import Pack
from catalog.ingest.debian import packaged_licence
from catalog.ingest.folder import ingest
from catalog.ingest.licence import licence
from catalog.ingest.licence_words import ai_use, licences_in
from catalog.ingest.naming import named
from tests.catalog.test_ingest_folder import gltf
from tests.shared import SHARED


@pytest.fixture
def source(tmp_path: Path) -> Path:
    place = tmp_path / "pack" / "source"
    place.mkdir(parents=True)
    return place


def box(path: Path, size: tuple[float, float, float] = (1, 1, 1), at: tuple[float, float, float] = (0, 0, 0)) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    made = trimesh.creation.box(extents=size)
    made.apply_translation(at)
    made.export(path)


def built(source: Path, tmp_path: Path, **more: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    report = ingest(source, "p", tmp_path / "packs", replace=True, **more)
    pack = Pack.read(tmp_path / "packs" / "p" / "pack.json")
    return report, {asset.id: asset for asset in pack.assets}


def told(report: dict[str, Any], file: str) -> list[str]:
    return [row["note"] for row in report["notes"] if row["file"] == file]


def test_names_come_from_folders_where_files_tell_none(source: Path, tmp_path: Path) -> None:
    for place in (
        "furniture/office_chair/model.glb",
        "furniture/TableLamp/mesh_final_2.glb",
        "toys/robot/source/1.glb",
    ):
        box(source / place)
    box(source / "toys/3f2b8c9d1e/untitled.glb")
    box(source / "vase/vase.glb")
    report, found = built(source, tmp_path)
    assert report["assets"] == 5
    assert {asset.name: asset.category for asset in found.values()} == {
        "Office chair": "furniture",
        "Table lamp": "furniture",
        "Robot": "toys",
        "Toys": "props",
        "Vase": "vase",
    }
    assert found["office_chair"].tags[:3] == ["office", "chair", "furniture"]
    assert all("model" not in asset.tags for asset in found.values())


def test_equal_names_in_many_folders_tell_nothing_either(tmp_path: Path) -> None:
    files = [Path("a", thing, "textured.obj") for thing in ("drill", "mug", "bowl")]
    files += [Path("a", thing, "nontextured_simplified.obj") for thing in ("drill", "mug", "bowl")]
    files += [Path("a", "left", "chair.obj"), Path("a", "right", "chair.obj"), Path("a", "model.obj")]
    found = {path.as_posix(): one.name for path, one in named(files, Path("a")).items()}
    assert found == {
        "a/drill/textured.obj": "drill_textured",
        "a/mug/textured.obj": "mug_textured",
        "a/bowl/textured.obj": "bowl_textured",
        "a/drill/nontextured_simplified.obj": "drill_nontextured_simplified",
        "a/mug/nontextured_simplified.obj": "mug_nontextured_simplified",
        "a/bowl/nontextured_simplified.obj": "bowl_nontextured_simplified",
        "a/left/chair.obj": "chair",
        "a/right/chair.obj": "chair",
        "a/model.obj": "model",
    }


def test_files_beside_a_mesh_describe_it(source: Path, tmp_path: Path) -> None:
    box(source / "1/model.glb")
    (source / "1/metadata.json").write_text(
        json.dumps(
            {
                "name": "Garden bench",
                "tags": [{"name": "outdoor"}, {"slug": "wood"}],
                "categories": [{"name": "seating"}],
                "license": {"label": "CC Attribution", "url": "https://creativecommons.org/licenses/by/4.0/"},
            }
        )
    )
    box(source / "2/model.glb")
    (source / "2/model.yaml").write_text(
        "title: Desk lamp\nkeywords: brass, green; old\ndescription: A lamp of 1920.\n"
    )
    box(source / "3/model.glb")
    (source / "3/info.txt").write_text("Name: Mug\nCategory: crockery\nLicense: CC-BY-3.0 US\n")
    box(source / "4/model.glb")
    (source / "4/data.json").write_text("{broken")
    box(source / "many/left.glb")
    box(source / "many/right.glb")
    (source / "many/metadata.json").write_text('{"name": "Both"}')
    report, found = built(source, tmp_path)
    names = {asset.name: asset for asset in found.values()}
    assert set(names) == {"Garden bench", "Desk lamp", "Mug", "Model", "Left", "Right"}
    assert names["Garden bench"].category == "seating"
    assert names["Garden bench"].tags[:2] == ["outdoor", "wood"]
    assert {"bench", "garden"} <= set(names["Garden bench"].tags)
    assert names["Desk lamp"].tags[:3] == ["brass", "green", "old"]
    assert names["Desk lamp"].description == "A lamp of 1920."
    assert told(report, "4/model.glb")[0].startswith("data.json cannot be read and is left out: ")
    assert report["license"] == "CC-BY AND CC-BY-3.0-US"


def test_what_a_sidecar_says_is_data_and_never_a_path(source: Path, tmp_path: Path) -> None:
    box(source / "x/model.glb")
    (source / "x/model.json").write_text(
        json.dumps({"name": "../../etc/\u001b[31mpasswd\n", "tags": [["deep", {"name": 3}]]})
    )
    _, found = built(source, tmp_path)
    (asset,) = found.values()
    assert asset.name == "../../etc/ [31mpasswd"
    assert asset.mesh == "meshes/model.glb"
    (source / "x/model.json").unlink()
    (source / "x/model.json").symlink_to("/etc/hostname")
    report, _ = built(source, tmp_path)
    assert any("model.json cannot be read" in note for note in told(report, "x/model.glb"))


def test_units_are_looked_at_file_by_file(source: Path, tmp_path: Path) -> None:
    for name in ("chair_a", "chair_b", "table_a", "lamp_b"):
        box(source / f"{name}.glb", (0.8, 1.0, 0.8))
    box(source / "stool_cm.glb", (45, 60, 45))
    box(source / "thing_mm.glb", (900, 400, 400))
    report, found = built(source, tmp_path)
    assert report["units"]["proposed_scale"] is None
    (stool,) = told(report, "stool_cm.glb")
    assert "it is 60 m long and a real one is 0.35 to 1 m" in stool
    assert "--scale-of 'stool_cm.glb=0.01' fits" in stool
    (thing,) = told(report, "thing_mm.glb")
    assert "the middle of the folder is 1 m; --scale-of 'thing_mm.glb=0.001' fits" in thing
    report, found = built(source, tmp_path, scale_of=["stool*=0.01", "*_mm.glb=0.001"])
    assert not told(report, "stool_cm.glb")
    assert not told(report, "thing_mm.glb")
    assert found["stool_cm"].size_m == pytest.approx((0.45, 0.45, 0.6))
    for rule in ("=1", "a=", "a=zero", "a=-1", "a=nan", "a=1e9"):
        with pytest.raises(BadInput, match="not a rule like"):
            built(source, tmp_path, scale_of=[rule])


def test_a_folder_in_another_unit_is_one_proposal_and_its_exception_one_note(source: Path, tmp_path: Path) -> None:
    for name in ("chair_a", "chair_b", "table_a", "lamp_b"):
        box(source / f"{name}.glb", (80, 100, 80))
    box(source / "stool_m.glb", (0.45, 0.6, 0.45))
    report, _ = built(source, tmp_path)
    assert 0.007 <= report["units"]["proposed_scale"] <= 0.014
    assert [row["file"] for row in report["notes"] if "unlike" in row["note"]] == ["stool_m.glb"]


def test_real_packs_are_of_one_unit(tmp_path: Path) -> None:
    packs = sorted((SHARED / "assets" / "packs").glob("kaykit-*"))
    if not packs:
        pytest.skip("no shared assets here")
    report, _ = built(packs[0], tmp_path)
    assert report["skipped"] == []
    assert not [row for row in report["notes"] if "unlike" in row["note"]]


def test_a_pivot_outside_the_mesh_is_noted_and_moved_on_request(source: Path, tmp_path: Path) -> None:
    box(source / "far.glb", (1, 2, 1), (100, 0, -50))
    box(source / "near.glb", (1, 2, 1), (0.6, 1, 0))
    report, found = built(source, tmp_path)
    assert told(report, "far.glb") == ["its pivot lies 111 m outside the mesh; --recentre moves it"]
    assert told(report, "near.glb") == []
    report, found = built(source, tmp_path, recentre=True)
    assert told(report, "far.glb") == ["its pivot lay outside the mesh and is moved to the middle of its bottom"]
    assert found["far"].bounds_min_cm == pytest.approx((-50, -50, 0), abs=0.01)
    assert found["near"].bounds_min_cm == pytest.approx((10, -50, 0), abs=0.01)
    for name in ("far", "near"):
        corners = np.array(found[name].collision[0].vertices)
        assert corners.min(axis=0) == pytest.approx(found[name].bounds_min_cm, abs=0.01)
        assert corners.max(axis=0) == pytest.approx(found[name].bounds_max_cm, abs=0.01)


def test_authored_bodies_move_with_their_pivot(source: Path, tmp_path: Path) -> None:
    nodes = [
        {"children": [1, 2], "translation": [50, 0, 0]},
        {"mesh": 0, "name": "thing"},
        {"mesh": 0, "name": "UBX_thing"},
    ]
    gltf(source / "thing.gltf", nodes=nodes)
    _, found = built(source, tmp_path, recentre=True)
    (body,) = found["thing"].collision
    assert found["thing"].collision_source == "authored"
    assert body.center == pytest.approx((0, 0, found["thing"].bounds_max_cm[2] / 2), abs=0.01)


LICENCES = [
    ("CC BY 4.0", "CC-BY-4.0"),
    ("https://creativecommons.org/licenses/by/3.0/us/", "CC-BY-3.0-US"),
    (
        "Creative Commons Attribution 3.0 United States license\nhttp://creativecommons.org/licenses/by/3.0/us/",
        "CC-BY-3.0-US",
    ),
    ("CC-BY-3.0-USA", "CC-BY-3.0-US"),
    ("under the Creative Commons Attribution 3.0 Unported license", "CC-BY-3.0"),
    ("http://creativecommons.org/licenses/by-nc-sa/3.0/de/", "CC-BY-NC-SA-3.0-DE"),
    ("https://creativecommons.org/licenses/by-sa/2.0/uk/", "CC-BY-SA-2.0-UK"),
    ("https://creativecommons.org/licenses/by/4.0/legalcode.en", "CC-BY-4.0"),
    ("Creative Commons Attribution-ShareAlike 4.0 International", "CC-BY-SA-4.0"),
    ("Attribution-NonCommercial-NoDerivatives 4.0 International", "CC-BY-NC-ND-4.0"),
    ("CC Attribution", "CC-BY"),
    ("This file is under the Creative Commons Zero (Public Domain)", "CC0-1.0"),
    ("https://creativecommons.org/publicdomain/zero/1.0/", "CC0-1.0"),
    ("these models are in the public domain", "LicenseRef-PublicDomain"),
    ("SPDX-License-Identifier: BSD-3-Clause", "BSD-3-Clause"),
    ("http://www.apache.org/licenses/LICENSE-2.0", "Apache-2.0"),
    ("licensed under the MIT license", "MIT"),
    ("SIL Open Font License, Version 1.1", "OFL-1.1"),
    ("licensed under the GNU General Public License v3.0 or later", "GPL-3.0"),
    ("This program is free software under the GPLv2", "GPL-2.0"),
    ("GNU Lesser General Public License", "LGPL-3.0"),
    ("All rights reserved.", "LicenseRef-AllRightsReserved"),
    ("made with love in summer", None),
]


@pytest.mark.parametrize(("text", "expected"), LICENCES)
def test_licences_are_known_by_their_words_and_addresses(text: str, expected: str | None) -> None:
    assert licences_in(text)[:1] == ([expected] if expected else [])


@pytest.mark.parametrize("name", ["Apache-2.0", "GPL-2", "GPL-3", "LGPL-2.1", "LGPL-3", "CC0-1.0", "MPL-2.0"])
def test_whole_texts_of_licences_name_one(name: str) -> None:
    path = Path("/usr/share/common-licenses", name)
    if not path.is_file():
        pytest.skip("this system has no texts of licences")
    (found,) = licences_in(path.read_text())
    assert found.startswith(name)


@given(
    st.sampled_from(["by", "by-sa", "by-nc", "by-nd", "by-nc-sa", "by-nc-nd"]),
    st.sampled_from(["1.0", "2.0", "2.5", "3.0", "4.0"]),
    st.sampled_from(["", "us", "de", "at", "jp", "igo", "fr"]),
    st.sampled_from(["", "/", "/legalcode", "/deed.en"]),
)
def test_every_creative_commons_address_has_its_id(parts: str, version: str, port: str, behind: str) -> None:
    (found,) = licences_in(
        f"see https://creativecommons.org/licenses/{parts}/{version}{f'/{port}' if port else ''}{behind} ."
    )
    own = f"-{port.upper()}" if port and version != "4.0" else ""
    assert found == f"CC-{parts.upper()}-{version}{own}"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("CC0", "allowed"),
        ("CC-BY-4.0", "allowed"),
        ("MIT license", "allowed"),
        ("CC-BY-NC-4.0", "unknown"),
        ("CC-BY-SA-3.0", "allowed"),
        ("CC-BY-SA-4.0", "allowed"),
        ("CC-BY-SA-2.0", "unknown"),
        ("CC-BY-NC-SA-4.0", "unknown"),
        ("GPLv3", "unknown"),
        ("nothing said", "unknown"),
        ("CC-BY-4.0. This content may not be used to train AI models.", "forbidden"),
        ("All rights reserved. NoAI", "forbidden"),
        ("AI use: forbidden", "forbidden"),
        ("All rights reserved. AI use: allowed", "allowed"),
        ("marketplace licence, allowed for AI use", "allowed"),
        ("Using it for machine learning is prohibited. CC0", "forbidden"),
    ],
)
def test_what_is_said_of_ai(text: str, expected: str, source: Path, tmp_path: Path) -> None:
    box(source / "a.glb")
    (source / "LICENSE.txt").write_text(text)
    report, _ = built(source, tmp_path)
    assert report["ai_use"] == expected == Pack.read(tmp_path / "packs" / "p" / "pack.json").ai_use
    assert report["ai_use_reason"]


def test_licences_of_the_folders_above_and_below(source: Path, tmp_path: Path) -> None:
    box(source / "meshes/a/model.glb")
    (source.parent / "LICENSE").write_text("CC-BY-3.0")
    found = licence(source)
    assert (found.id, found.notes) == ("CC-BY-3.0", ("the licence is told by the folder 'pack' above",))
    (source / ".git").mkdir()
    assert licence(source).id == "unknown", "what a repository stands in is another's"
    (source / "meshes/a/LICENSE.md").write_text("CC0")
    files = [source / "meshes/a/model.glb"]
    assert licence(source, files).id == "CC0-1.0"
    (source / "LICENSE").write_text("Apache License 2.0")
    found = licence(source, files)
    assert found.id == "Apache-2.0 AND CC0-1.0"
    assert found.notes == ("some things have a licence of their own: CC0-1.0",)
    assert "CC0" in found.text


def test_a_readme_or_a_package_is_asked_last(source: Path) -> None:
    (source / "README.md").write_text("# Chairs\nWorks with MIT computers.\n\n## License\nCC BY-SA 4.0\n")
    assert licence(source).id == "CC-BY-SA-4.0"
    (source / "README.md").unlink()
    (source / "package.json").write_text('{"name": "x", "license": "ISC license"}')
    assert licence(source).id == "ISC"


def test_an_unknown_field_of_a_pack_is_not_written_where_nothing_is_known() -> None:
    pack = Pack(pack_id="p", content_folder="P", title="", license="", assets=[])
    assert "ai_use" not in pack.plain(), "manifests of older packs keep their digest"
    assert ai_use("CC0-1.0", "")[0] == "allowed"


DEP5 = """Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: things

Files: *
Copyright: 2020, Somebody
License: BSD-3-Clause
 Redistribution and use in source and binary forms, with or without
 modification, are permitted.

Files: Chairs/* Tables/*
Copyright: 2021, Another
License: CC-BY-3.0

Files: debian/*
Copyright: 2022, Packager
License: GPL-2+

License: CC-BY-3.0
 Creative Commons Attribution 3.0 Unported
"""


@pytest.mark.parametrize(
    ("installed", "copyright_file", "expected"),
    [
        (["walls/wall.obj"], DEP5, ["BSD-3-Clause"]),
        (["Chairs/chair.obj"], DEP5, ["CC-BY-3.0"]),
        (["walls/wall.obj", "Chairs/deep/chair.obj"], DEP5, ["BSD-3-Clause", "CC-BY-3.0"]),
        (["debian/wall.obj"], DEP5, ["BSD-3-Clause"]),
        (["wall.obj"], "It is licensed under the MIT license.\n", ["MIT"]),
        (["wall.obj"], DEP5.replace("Files: *\n", "Files: other/*\n"), []),
        (["wall.obj"], None, None),
        ([], DEP5, None),
    ],
)
def test_the_copyright_file_of_a_debian_package(
    tmp_path: Path, installed: list[str], copyright_file: str | None, expected: list[str] | None
) -> None:
    paths = [tmp_path / "usr/share/things" / name for name in installed]
    lists, docs = tmp_path / "var/lib/dpkg/info", tmp_path / "usr/share/doc/things"
    for folder in (lists, docs):
        folder.mkdir(parents=True)
    (lists / "other.list").write_text("/.\n/usr/share\n")
    (lists / "things:amd64.list").write_text("".join(f"/usr/share/things/{name}\n" for name in installed))
    if copyright_file is not None:
        (docs / "copyright").write_text(copyright_file)
    found = packaged_licence(paths, tmp_path)
    if expected is None:
        assert found is None
        return
    assert found is not None and found[0] == "things"
    assert [licences_in(text)[0] for text in found[1]] == expected


def test_files_that_no_package_installed_have_no_copyright_file(tmp_path: Path) -> None:
    (tmp_path / "usr/share").mkdir(parents=True)
    assert packaged_licence([tmp_path / "usr/share/own.obj", tmp_path / "home/own.obj"], tmp_path) is None
    assert packaged_licence([tmp_path / "own.obj"], tmp_path) is None


def test_a_file_that_is_given_tells_the_licence_alone(tmp_path: Path) -> None:
    folder, told = tmp_path / "pack", tmp_path / "terms.txt"
    folder.mkdir()
    (folder / "LICENSE.txt").write_text("MIT")
    told.write_text("SPDX-License-Identifier: CC-BY-NC-4.0\nMay not be used for AI training: no AI.")
    found = licence(folder, given=told)
    assert (found.id, found.ai_use) == ("CC-BY-NC-4.0", "forbidden")
    for wrong, says in ((tmp_path / "nowhere.txt", "no such file"), (tmp_path / "empty.txt", "tells no licence")):
        (tmp_path / "empty.txt").write_text("Ask us.")
        with pytest.raises(BadInput, match=says):
            licence(folder, given=wrong)
