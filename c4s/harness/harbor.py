"""Cases as Harbor task folders (schema 1.4).

::

    <out>/<alias>/task.toml          limits, the tool server, the artifact, an environment each for agent and verifier
    <out>/<alias>/instruction.md     what every agent is told first
    <out>/<alias>/environment/case/  the agent's folder of the case: uploaded into the agent's environment
    <out>/<alias>/solution/          solve.sh and the truth, for the agent ``oracle`` of Harbor alone
    <out>/<alias>/tests/             test.sh and the case as a suite of one, truth included, for the verifier alone

The verifier is separate: agents have a shell and are root where they work, so nothing that lies there is trusted but
the saved scene, which passes the gate like any other. An agent's environment holds one case, since the start levels of
two repairs of one scene tell each other's truth. Agent and verifier have one image, each a container of its own;
Harbor uploads ``tests/`` into the verifier's only where that names no image of its own.
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Sequence
from pathlib import Path

from c4s.agents.briefing import SERVER, briefing
from c4s.errors import BadInput, unknown
from c4s.folders import beside, check_new, put_folder
from c4s.packs.suite_check import check_case
from c4s.records.suite import AgentCase, SuiteCase, SuiteFolder, WithheldCase, WithheldFolder

HARNESS = "harbor"
SCHEMA = "1.4"
IMAGE = "c4s-harbor"
ROOT = "/c4s"
"""Where an environment holds what is c4s's; the working directory, into which Harbor uploads ``environment/``."""
ATTEMPT = f"{ROOT}/attempt"
AGENT_GRACE_S, VERIFIER_S = 300, 3600
CPUS, MEMORY_MB, STORAGE_MB = 2, 8192, 20_480
TASK = "task.toml"
_TASK = """\
schema_version = {schema}
artifacts = [{attempt}]

[task]
name = {name}
description = {description}
keywords = ["unreal", "3d", "code4scene"]

[metadata]
suite = {suite}
suite_sha256 = {digest}
case = {case}
title = {title}
setting = {setting}
scene = {scene}
tool_calls = {calls}

[agent]
timeout_sec = {agent_s}

[verifier]
timeout_sec = {verifier_s}
environment_mode = "separate"

[verifier.environment]
workdir = {root}
cpus = {cpus}
memory_mb = {memory_mb}
storage_mb = {storage_mb}
network_mode = "no-network"

[environment]
docker_image = {image}
workdir = {root}
cpus = {cpus}
memory_mb = {memory_mb}
storage_mb = {storage_mb}

[[environment.mcp_servers]]
name = {server}
transport = "stdio"
command = "c4s"
args = [{serve}]
"""
_TEST = """\
#!/bin/sh
# Grades what the agent saved, in the verifier's own environment: the artifact {attempt} beside this folder.
set -eu
export C4S_HOME="${{C4S_HOME:-{root}/home}}"
mkdir -p {attempt} /logs/verifier "$C4S_HOME/suites"
cp -r /tests/suite "$C4S_HOME/suites/{suite}"
exec c4s grade {attempt} --case {case} --suite {suite} --harness {harness} --out /logs/verifier/reward.json --replace
"""
_SOLVE = """\
#!/bin/sh
# Saves the truth, which lies beside this file; for Harbor's agent `oracle`.
set -eu
export C4S_HOME="${{C4S_HOME:-{root}/home}}"
exec python -m c4s.harness.oracle {root}/case /solution/withheld {attempt}
"""


def export_harbor(suite: SuiteFolder, out: Path, *, cases: Sequence[str] = (), image: str = IMAGE) -> list[Path]:
    """Write a task folder for each case of a suite, or for those named; the folders.

    Args:
        suite: a built suite, as it was frozen.
        out: a new folder.
        cases: case ids; all where there are none.
        image: of agent and verifier, as ``deploy/harbor/Dockerfile`` makes it.

    Raises ``BadInput`` for an unknown case, a case that is not as it was frozen, and an ``out`` that is not new.
    """
    record = suite.suite()
    known = [case.case_id for case in record.cases]
    for named in cases:
        if named not in known:
            raise unknown("case", named, known, where=f"suite {record.suite_id}")
    if not image or any(character.isspace() or not character.isprintable() for character in image):
        raise BadInput(f"{image!r} names no image", where="--image")
    check_new(out)
    chosen = [case for case in record.cases if not cases or case.case_id in cases]
    for case in chosen:
        check_case(suite, case)
    with beside(out) as scratch:
        made = scratch / out.name
        for case in chosen:
            _write(suite, case, made / case.alias, image)
        if out.is_dir():
            for folder in sorted(made.iterdir()):
                folder.rename(out / folder.name)
        else:
            put_folder(made, out, marker=TASK)
    return [out / case.alias for case in chosen]


def _write(suite: SuiteFolder, case: SuiteCase, folder: Path, image: str) -> None:
    agent_side, withheld = suite.agent(case.alias), WithheldFolder(suite.withheld(case.case_id))
    shutil.copytree(agent_side, folder / "environment" / "case")
    _write_suite(suite, case, folder / "tests" / "suite")
    opened, of_case = suite.agent_case(case.alias), suite.withheld_case(case.case_id)
    names = {
        "suite": suite.suite().suite_id,
        "case": case.case_id,
        "root": ROOT,
        "attempt": ATTEMPT,
        "harness": HARNESS,
    }
    (folder / TASK).write_text(_task(suite, opened, of_case, image), encoding="utf-8")
    (folder / "instruction.md").write_text(_instruction(opened), encoding="utf-8")
    _script(folder / "tests" / "test.sh", _TEST.format(**names))
    if withheld.truth_level.is_file():
        truth = WithheldFolder(folder / "solution" / "withheld").truth_level
        truth.parent.mkdir(parents=True)
        shutil.copyfile(withheld.truth_level, truth)
        _script(folder / "solution" / "solve.sh", _SOLVE.format(**names))


def _write_suite(suite: SuiteFolder, case: SuiteCase, folder: Path) -> None:
    """The case as a suite of its own, under the suite's id."""
    record, one = suite.suite(), SuiteFolder(folder)
    shutil.copytree(suite.agent(case.alias), one.agent(case.alias))
    shutil.copytree(suite.withheld(case.case_id), one.withheld(case.case_id))
    one.freeze(record.suite_id, record.title, record.description, suite.agent_case(case.alias).packs)


def _task(suite: SuiteFolder, case: AgentCase, withheld: WithheldCase, image: str) -> str:
    record = suite.suite()
    serve = ["serve", f"{ROOT}/case", "--stdio", "--out", ATTEMPT, "--harness", HARNESS]
    return _TASK.format(
        schema=_text(SCHEMA),
        attempt=_text(ATTEMPT),
        name=_text(f"c4s/{record.suite_id}-{case.alias}"),
        description=_text(f"a {case.setting} case of {record.suite_id}"),
        title=_text(withheld.title),
        suite=_text(record.suite_id),
        digest=_text(record.sha256()),
        case=_text(withheld.case_id),
        setting=_text(case.setting),
        scene=_text(withheld.scene_id),
        calls=case.budget.tool_calls,
        agent_s=round(60 * case.budget.wall_minutes) + AGENT_GRACE_S,
        verifier_s=VERIFIER_S,
        image=_text(image),
        root=_text(ROOT),
        cpus=CPUS,
        memory_mb=MEMORY_MB,
        storage_mb=STORAGE_MB,
        server=_text(SERVER),
        serve=", ".join(map(_text, serve)),
    )


def _instruction(case: AgentCase) -> str:
    text = briefing(case, SERVER, pictures=0, alone=False)
    views = [f"`{ROOT}/case/{view}`" for view in case.reference_views]
    return text + (f"\nThese pictures show the scene as it should be: {', '.join(views)}.\n" if views else "")


def _script(path: Path, text: str) -> None:
    path.write_text(text, encoding="utf-8")
    path.chmod(0o755)


def _text(value: str) -> str:
    """A string as TOML has it; its escapes are those of JSON."""
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
