"""From a prompt to a frozen, bound requirement graph through the command line, with a model on loopback."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import pytest
import yaml

from c4s.files import digest_bytes
from c4s.protocol.graph.check import check_bundle
from tests.cases.model_endpoint import model_endpoint
from tests.cases.test_extraction import good
from tests.run.conftest import command_in
from tests.shared import SHARED

PUBLISHED = SHARED / "upstream/benchmark/public/text-to-scene/bazaar"
DESCRIPTION = "Two red cows graze beside a wooden barn or shed."
ROWS = [
    "- cow | Cow | animals | 2x1x1.4 m | /Game/P/SM_Cow.SM_Cow",
    "- barn | Barn | buildings | 9x6x5 m | /Game/P/SM_Barn.SM_Barn",
    "- cow_bell | Cow Bell | props | 0.1x0.1x0.1 m | /Game/P/SM_CowBell.SM_CowBell",
]
PROMPT = "\n".join([DESCRIPTION, "", "=== ASSET PALETTE ===", "", *ROWS, ""])


def c4s(home: Path, *arguments: object) -> subprocess.CompletedProcess[str]:
    return command_in(home)(*map(str, arguments), timeout=120)


def done(home: Path, *arguments: object) -> Any:
    """What a command says as JSON."""
    found = c4s(home, *arguments, "--json")
    assert found.returncode == 0, found.stderr
    return json.loads(found.stdout)


def task(folder: Path, bundle: str | None = "requirements/cows.bundle.json") -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    verifier = {"name": "semantic_requirements", "verification_bundle": bundle}
    inputs = {"prompt": PROMPT, "init_map": "/Game/Blank", "size_m": 50, "budget": {"tool_calls": 9, "wall_minutes": 5}}
    written = {"id": "cows", "kind": "scene_generation", "inputs": inputs, "verifiers": [verifier] if bundle else []}
    (folder / "task.yaml").write_text(yaml.safe_dump(written))
    return folder


@pytest.fixture(scope="module")
def authored(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A task with a bundle that the command extracted, imported; and what is needed to do it again."""
    root = tmp_path_factory.mktemp("authored")
    (root / "cows.txt").write_text(PROMPT)
    folder = task(root / "tasks/cows")
    (folder / "requirements").mkdir()
    out = folder / "requirements/cows.bundle.json"
    bad = good()
    bad["requirements"].pop(1)
    with model_endpoint([bad, good()]) as endpoint:
        endpoint.describe(root / "home")
        asked = (
            "suite",
            "requirements",
            "extract",
            root / "cows.txt",
            "--model",
            "m",
            "--endpoint",
            "near",
            "--out",
            out,
        )
        report = done(root / "home", *asked)
        assert (report["answers"], report["errors"], report["warnings"]) == (2, [], [])
        again = c4s(root / "home", *asked)
        assert again.returncode == 2 and "there already" in again.stderr
    review = {
        "schema_version": "c4s.reviewed-bindings.v1",
        "entities": {"entity_shed": {"add": ["/Game/P/SM_Barn.SM_Barn"]}},
    }
    (folder / "requirements/cows.bindings.json").write_text(json.dumps(review))
    made = done(root / "home", "suite", "import", "code4scene", folder, "--id", "cows")
    assert made["cases"][0]["note"] == "proxy assets"
    return root


def test_what_was_extracted_is_checked_and_bound_as_it_was_frozen(authored: Path) -> None:
    home = authored / "home"
    (checked,) = done(home, "suite", "requirements", "check", "cows")["bundles"]
    assert checked["coverage"]["coverage_ratio"] == 1
    assert done(home, "suite", "requirements", "check", "cows", "cows")["bundles"] == [checked]
    bound = done(home, "suite", "requirements", "bindings", "cows", "cows")
    assert bound["frozen"] is True and bound["reviewed_sha256"]
    entities = bound["entities"]
    assert entities["entity_cows"]["assets"] == ["/Game/P/SM_Cow.SM_Cow"]
    assert [row["asset"] for row in entities["entity_cows"]["proposed"]] == ["/Game/P/SM_CowBell.SM_CowBell"]
    assert entities["entity_shed"]["assets"] == ["/Game/P/SM_Barn.SM_Barn"]
    table = c4s(home, "suite", "requirements", "bindings", "cows", "cows")
    assert "Cow Bell (" in table.stdout and "(frozen)" in table.stdout


def test_a_case_of_a_suite_is_extracted_as_its_prompt_is(authored: Path, tmp_path: Path) -> None:
    home, out = authored / "home", tmp_path / "again.json"
    kept = (home / "endpoints.yaml").read_bytes()
    with model_endpoint([good()]) as endpoint:
        endpoint.describe(home)
        asked = "suite", "requirements", "extract", "cows", "cows", "--model", "m", "--endpoint", "near", "--out", out
        assert done(home, *asked)["answers"] == 1
    (home / "endpoints.yaml").write_bytes(kept)
    frozen = json.loads((home / "suites/cows/withheld/cows/requirements.bundle.json").read_text())
    assert json.loads(out.read_text())["graph"] == frozen["graph"]


def test_a_changed_bundle_or_binding_runs_nothing(authored: Path) -> None:
    withheld = authored / "home/suites/cows/withheld/cows"
    for name in ("requirements.bundle.json", "binding.json", "bindings.reviewed.json"):
        kept = (withheld / name).read_bytes()
        (withheld / name).write_bytes(
            kept.replace(b"cow", b"caw", 1) if name != "bindings.reviewed.json" else kept + b" "
        )
        refused = c4s(authored / "home", "run", "cows", "-a", "noop")
        assert refused.returncode == 2 and name in refused.stderr and refused.stderr.count("\n") == 1
        (withheld / name).write_bytes(kept)


def test_a_bundle_that_cannot_be_used_or_of_another_prompt_is_not_imported(authored: Path, tmp_path: Path) -> None:
    made = json.loads((authored / "tasks/cows/requirements/cows.bundle.json").read_text())
    for spoil, said in (
        (lambda b: b["graph"]["nodes"].pop(0), "references.edge"),
        (lambda b: b["evaluations"].pop(), "cannot be used"),
        (lambda b: b["graph"].update(prompt=b["graph"]["prompt"] + " And more."), "another prompt"),
    ):
        folder = task(tmp_path / "task", "cows.bundle.json")
        spoiled = json.loads(json.dumps(made))
        spoil(spoiled)
        (folder / "cows.bundle.json").write_text(json.dumps(spoiled))
        refused = c4s(tmp_path / "home", "suite", "import", "code4scene", folder)
        assert refused.returncode == 2 and said in refused.stderr and refused.stderr.count("\n") == 1
        assert not (tmp_path / "home/suites").exists()


def test_a_published_bundle_is_imported_byte_by_byte(tmp_path: Path) -> None:
    if not PUBLISHED.is_dir():
        pytest.skip("the published tasks are not here")
    made = done(tmp_path, "suite", "import", "code4scene", PUBLISHED, "--id", "bazaar")
    assert made["cases"][0]["note"] == "proxy assets"
    withheld = tmp_path / "suites/bazaar/withheld/bazaar"
    source = (PUBLISHED / "requirements/bazaar.bundle.json").read_bytes()
    assert (withheld / "requirements.bundle.json").read_bytes() == source
    noted = json.loads((tmp_path / "suites/bazaar/digests.json").read_text())
    assert noted["withheld/bazaar/requirements.bundle.json"] == digest_bytes(source)
    assert check_bundle(json.loads(source)).findings == ()
    bound = done(tmp_path, "suite", "requirements", "bindings", "bazaar", "bazaar")
    towers = bound["entities"]["entity_square_crenellated_towers"]["assets"]
    assert bound["frozen"] is True and len(towers) == 2
