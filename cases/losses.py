"""Which points of physics a suite's own truth loses, and why: what no agent can win, however well it repairs or builds.

Each case's truth is judged as a perfect submission would be. A row tells the actor, and for a penetration its partner,
the depth, the tolerance and which collision body of each meets (``#2 hull``, counted from 0 in the actor), for a
floating actor its gap, for one that cannot be judged the reason. Lengths in cm.
"""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from c4s.collision import SceneBodies, scene_bodies
from c4s.collision.depth import BodyTable
from c4s.files import read_json
from c4s.packs.store import PackStore
from c4s.protocol.settings import Setting, is_construction
from c4s.records.suite import SuiteFolder, WithheldFolder
from c4s.verify.physics.verdict import verify_physics

Row = dict[str, Any]
MOST_NAMED = 5
"""Losses that a terminal names; a report has all."""


def truth_losses(folder: SuiteFolder, packs_root: Path, whole: Container[str] = ()) -> dict[str, Any]:
    """Physics of every case's truth: ``cases`` with score and losses, and their sums.

    ``whole``: ids of cases whose truth was measured already and loses nothing.
    """
    suite = folder.suite()
    store = PackStore([packs_root / pack.pack_id for pack in suite.packs])
    cases: list[dict[str, Any]] = []
    for case in suite.cases:
        if case.case_id in whole:
            cases.append({"case_id": case.case_id, "score": 1.0, "losses": []})
            continue
        withheld = WithheldFolder(folder.withheld(case.case_id))
        start = None if is_construction(case.setting) else read_json(withheld.input_snapshot)
        score, losses = losses_of(case.setting, read_json(withheld.truth_snapshot), start, store)
        cases.append({"case_id": case.case_id, "score": score, "losses": losses})
    return {
        "cases": cases,
        "judged": len(cases),
        "below_one": sum(1 for case in cases if case["score"] != 1.0),
        "losses": sum(len(case["losses"]) for case in cases),
    }


def losses_of(
    setting: Setting, truth: Mapping[str, Any], start: Mapping[str, Any] | None, store: PackStore
) -> tuple[float | None, list[Row]]:
    """The physics score of a truth, and what it loses."""
    verdict = verify_physics(setting, truth, start, meshes=store.recorded_mesh)
    floating, solid = verdict.measurements["leaf_results"]
    bodies = scene_bodies(truth)
    index = {str(actor.get("name") or actor.get("label")): i for i, actor in enumerate(truth["actors"])}
    rows: list[Row] = []
    for found in solid["violations"]:
        for contact in found["contacts"]:
            mine, other = body_pair(bodies, index[found["actor"]], index[contact["actor"]])
            rows.append(
                {
                    "leaf": "solid_penetration",
                    "actor": found["actor"],
                    "partner": contact["actor"],
                    "depth_cm": contact["depth_cm"],
                    "tolerance_cm": found["tolerance_cm"],
                    "body": mine,
                    "partner_body": other,
                }
            )
    gaps = {row["actor"]: row for row in floating.get("actors", [])}
    rows += [
        {"leaf": "floating", "actor": name, "gap_cm": gaps.get(name, {}).get("gap_cm")}
        for name in floating["floating_actors"]
    ]
    for leaf in (floating, solid):
        for name in leaf.get("unresolved_actors", []):
            told = {row["actor"]: row.get("reason", "") for row in leaf.get("actors", [])}
            rows.append({"leaf": leaf["leaf_id"], "actor": name, "reason": told.get(name) or "it cannot be told"})
    return verdict.score, rows


def body_pair(scene: SceneBodies, a: int, b: int) -> tuple[str, str]:
    """The two bodies of two actors (positions in the scene) that meet deepest, each by its number in its actor."""
    owners = np.array(scene.owners)
    mine, other = np.flatnonzero(owners == a), np.flatnonzero(owners == b)
    if not len(mine) or not len(other):
        return "", ""
    table = BodyTable(scene.bodies)
    i, j = (side.ravel() for side in np.meshgrid(mine, other, indexing="ij"))
    push_out = np.minimum(table.high[i] - table.low[j], table.high[j] - table.low[i]).min(axis=1)
    near = push_out > 0
    i, j, push_out = i[near], j[near], push_out[near]
    if not len(i):
        return "", ""
    best = int(np.argmax(table.depths(i, j, push_out, 0.0)[0]))
    return tuple(  # type: ignore[return-value]
        f"#{int(np.flatnonzero(side == one[best])[0])} {_kind(scene.bodies[int(one[best])])}"
        for side, one in ((mine, i), (other, j))
    )


def _kind(body: Any) -> str:
    return "hull" if body.form.corners is not None else "round" if body.form.radius else "box"


def told(report: Mapping[str, Any]) -> list[str]:
    """The report as lines for a terminal: a sum, and the losses most often met."""
    cases: Sequence[Mapping[str, Any]] = report["cases"]
    if not report["below_one"]:
        return [f"physics of the truth: 1.000 in all {report['judged']} cases"]
    lines = [
        f"physics of the truth: {report['below_one']} of {report['judged']} cases lose points that no agent can win "
        f"({report['losses']} losses)"
    ]
    counted: dict[str, list[str]] = {}
    for case in cases:
        for row in case["losses"]:
            counted.setdefault(loss_line(row), []).append(case["case_id"])
    ordered = sorted(counted.items(), key=lambda item: (-len(item[1]), item[0]))
    lines += [
        f"  {line}: {names[0]}{f' and {len(names) - 1} more' if len(names) > 1 else ''}"
        for line, names in ordered[:MOST_NAMED]
    ]
    if len(ordered) > MOST_NAMED:
        lines.append(f"  and {len(ordered) - MOST_NAMED} others (see --json)")
    return lines


def loss_line(row: Row) -> str:
    """One loss in words."""
    if "partner" in row:
        return (
            f"{row['actor']} ({row['body']}) sinks {row['depth_cm']:.1f} cm into {row['partner']} "
            f"({row['partner_body']}), {row['tolerance_cm']:g} allowed"
        )
    if "reason" in row:
        return f"{row['actor']} cannot be judged for {row['leaf']}: {row['reason']}"
    gap = row["gap_cm"]
    return f"{row['actor']} floats" + (f" {gap:.1f} cm above what is below" if gap is not None else "")
