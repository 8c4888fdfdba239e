"""Bad input gives one clear line and exit code 2."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import pytest

from c4s.protocol.baselines import BASELINES
from tests.cli.warm import warm_process


def _c4s(home: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    done = warm_process().call(
        arguments, cwd=Path.cwd(), environment={**os.environ, "C4S_HOME": str(home)}, limit_s=200
    )
    return subprocess.CompletedProcess(arguments, done.code, done.out, done.err)


def _task(folder: Path, text: str) -> Path:
    folder.mkdir(parents=True)
    (folder / "task.yaml").write_text(text)
    return folder


PROMPT = "A yard.\\n\\n=== ASSET PALETTE ===\\n\\n- box | Box | props | 1x1x1 m | /Game/P/SM_Box.SM_Box\\n"
TASK = (
    f'id: yard\nkind: scene_generation\ninputs:\n  prompt: "{PROMPT}"\n  init_map: /Game/Blank\n  size_m: 200\n'
    "  budget:\n    tool_calls: 10\n    wall_minutes: 5\n"
)


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (("run", "nosuch"), "unknown suite 'nosuch'"),
        (("run",), "Missing argument"),
        (("frobnicate",), "No such command"),
        (("suite", "build", "nosuch"), "unknown shipped suite"),
        (("suite", "import", "code4scene", "/nowhere"), "no such folder"),
        (("suite", "import", "code4scene", "/nowhere", "--id", "../other"), "a suite id is"),
        (("suite", "make-cases", "yard", "--id", "yard"), "the scene's own id"),
        (("suite", "make-cases", "yard", "--id", "yard/2"), "a suite id is"),
        (("catalog", "build", ".", "--id", "/tmp/pack"), "a pack id is"),
        (("verify", "repair"), "--input is missing"),
        (("verify", "physics", "--snapshot", "/nowhere.json"), "no such snapshot"),
        (("score", "--batch", "/nowhere.jsonl"), "no such file"),
        (("sql", "SELECT nosuch"), "no warehouse"),
        (("catalog", "show", "nosuch"), "unknown pack"),
    ],
)
def test_one_line_and_exit_2(tmp_path: Path, arguments: tuple[str, ...], expected: str) -> None:
    done = _c4s(tmp_path, *arguments)
    assert done.returncode == 2 and expected in done.stderr
    assert done.stderr.count("\n") == 1 and done.stderr.startswith("c4s: ")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("id: [unclosed", "not valid YAML"),
        ("just text", "not a mapping"),
        (TASK.replace("kind: scene_generation", "kind: painting"), "unknown kind"),
        (TASK.replace("  size_m: 200\n", ""), "'inputs.size_m' is missing"),
        (TASK.replace("tool_calls: 10", "tool_calls: many"), "'inputs.budget.tool_calls': this is no positive number"),
        (TASK.replace("tool_calls: 10", "tool_calls: 0.5"), "'inputs.budget.tool_calls': this is no whole number"),
        (TASK.replace("tool_calls: 10", "tool_calls: 1.0e+30"), "no positive number up to 1,000,000"),
        (TASK.replace("wall_minutes: 5", "wall_minutes: 1.0e+200"), "no positive number up to 1,000,000"),
        (TASK.replace("size_m: 200", "size_m: 0x" + "f" * 390), "too long"),
        (TASK.replace("/Game/Blank", "/X.level/a"), "a start map lies below /Game"),
        (TASK.replace("1x1x1 m", "...x.x1 m"), "palette line cannot be read"),
        (TASK.replace("1x1x1 m", "1.1.1x1x1 m"), "palette line cannot be read"),
        (TASK.replace("1x1x1 m", "9" * 310 + "x1x1 m"), "larger than 100,000 m"),
        (TASK.replace("id: yard", "id: ../../etc"), "is no name"),
        (TASK.replace("1x1x1 m", "big"), "palette line cannot be read"),
        (TASK.replace("ASSET PALETTE", "NOTHING"), "no asset palette"),
    ],
)
def test_malformed_tasks(tmp_path: Path, text: str, expected: str) -> None:
    folder = _task(tmp_path / "tasks/yard", text)
    done = _c4s(tmp_path / "home", "suite", "import", "code4scene", str(folder))
    assert done.returncode == 2 and expected in done.stderr and done.stderr.count("\n") == 1
    assert "task.yaml" in done.stderr


def test_a_malformed_requirement_bundle_is_not_imported(tmp_path: Path) -> None:
    text = TASK + "verifiers:\n- name: semantic_requirements\n  verification_bundle: yard.bundle.json\n"
    folder = _task(tmp_path / "tasks/yard", text)
    (folder / "yard.bundle.json").write_text('{"graph": {"prompt": "", "nodes": [], "edges": [7]}, "requirements": []}')
    done = _c4s(tmp_path / "home", "suite", "import", "code4scene", str(folder))
    assert done.returncode == 2 and "requirement bundle cannot be used" in done.stderr and done.stderr.count("\n") == 1
    assert "yard.bundle.json" in done.stderr and not (tmp_path / "home" / "suites").exists()


def test_truncated_and_wrong_snapshots(tmp_path: Path) -> None:
    (tmp_path / "cut.json").write_text('{"schema_version": "0.3.0", "actors": [')
    (tmp_path / "list.json").write_text("[]")
    for name, expected in (("cut.json", "not valid JSON"), ("list.json", "no list of actors")):
        done = _c4s(tmp_path, "verify", "physics", "--snapshot", str(tmp_path / name))
        assert done.returncode == 2 and expected in done.stderr and name in done.stderr


def test_an_unknown_agent_and_a_missing_pack_stop_before_anything_runs(tmp_path: Path) -> None:
    folder = _task(tmp_path / "tasks/yard", TASK)
    assert _c4s(tmp_path, "suite", "import", "code4scene", str(folder), "--id", "yard").returncode == 0
    unknown = _c4s(tmp_path, "run", "yard", "-a", "nobody")
    assert unknown.returncode == 2 and "unknown agent 'nobody'" in unknown.stderr
    (pack := next(tmp_path.glob("packs/proxy-*/pack.json"))).unlink()
    missing = _c4s(tmp_path, "run", "yard", "-a", "noop")
    assert missing.returncode == 2 and pack.parent.name in missing.stderr and missing.stderr.count("\n") == 1


def test_a_task_without_an_original_has_no_oracle(tmp_path: Path) -> None:
    folder = _task(tmp_path / "tasks/yard", TASK)
    assert _c4s(tmp_path, "suite", "import", "code4scene", str(folder), "--id", "yard").returncode == 0
    for agents in (("noop", "oracle"), ("mixed.yaml",)):
        (tmp_path / "mixed.yaml").write_text("name: mixed\nclient: noop\nper_case: {yard: {client: oracle}}\n")
        named = [word for name in agents for word in ("-a", str(tmp_path / name) if name.endswith("yaml") else name)]
        refused = _c4s(tmp_path, "run", "yard", *named)
        assert refused.returncode == 2 and "without an original scene" in refused.stderr
        assert refused.stderr.count("\n") == 1 and not (tmp_path / "runs").exists()
    done = _c4s(tmp_path, "run", "yard", "--json")
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout)
    ran = [row["configuration"] for row in told["leaderboard"]]
    assert sorted(ran) == sorted(set(BASELINES) - {"oracle"})
    reason = "'yard' came without an original scene, so it has nothing to save"
    assert told["left_out"] == [{"agent": "oracle", "reason": reason}]
    assert done.stderr.splitlines()[0] == f"c4s: without oracle: {reason}"
    assert json.loads((tmp_path / "runs/yard/plan.json").read_text())["left_out"] == told["left_out"]


def test_json_reports(tmp_path: Path) -> None:
    folder = _task(tmp_path / "tasks/yard", TASK)
    done = _c4s(tmp_path, "suite", "import", "code4scene", str(folder), "--id", "yard", "--json")
    report = json.loads(done.stdout)
    assert report["runnable"] == 1 and report["cases"][0]["assets"] == 1
    pack = json.loads(_c4s(tmp_path, "catalog", "show", next(tmp_path.glob("packs/*")).name, "--json").stdout)
    box = pack["assets"][0]
    assert box["path"] == "/Game/P/SM_Box.SM_Box"
    assert [high - low for low, high in zip(box["bounds_min_cm"], box["bounds_max_cm"], strict=True)] == [100, 100, 100]


def test_doctor_says_what_is_missing(tmp_path: Path) -> None:
    done = _c4s(tmp_path, "doctor", "--json")
    found = {row["what"]: row for row in json.loads(done.stdout)}
    assert found["starter suite"]["found"] is False and "c4s suite build" in found["starter suite"]["text"]
    assert done.returncode == int(any(row["needed"] and not row["found"] for row in found.values()))


def test_a_verdict_that_could_not_be_made_is_a_fault_of_the_machinery(tmp_path: Path) -> None:
    def scene(name: str, x_cm: float, **more: object) -> str:
        actor = {
            "stable_actor_id": "a",
            "label": "A",
            "class": "/Script/Engine.StaticMeshActor",
            "transform": {"location_cm": [x_cm, 0.0, 0.0], "rotation_deg": [0.0, 0.0, 0.0], "scale": [1.0, 1.0, 1.0]},
        }
        path = tmp_path / f"{name}.json"
        path.write_text(json.dumps({"schema_version": "0.3.0", "units": "cm", "actors": [actor], **more}))
        return str(path)

    files = (
        "--input",
        scene("input", 50.0),
        "--truth",
        scene("truth", 0.0),
        "--candidate",
        scene("candidate", 0.0, export_metadata={"status": "failed"}),
    )
    done = _c4s(tmp_path, "verify", "repair", *files, "--json")
    assert done.returncode == 3
    assert json.loads(done.stdout)["status"] == "error"
