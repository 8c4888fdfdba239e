"""Where the text-to-scene support rule is odd in a scene: advisories for the actors concerned. No score changes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from c4s.protocol.rules import GAP_CM, TINY_CM
from c4s.verify.actors.roles import is_non_solid
from c4s.verify.physics.support import Support


def support_advisories(snapshot: Mapping[str, Any], support: Support) -> list[dict[str, Any]]:
    """Advisories ``{"code", "text", "actors"}`` of a scene whose support was measured.

    Actors that float only because they reach a little into what they stand on; actors that count as supported deep
    under the ground plane; lights, effects and other helpers that the rule tests and finds floating.
    """
    actors = snapshot["actors"]
    tested = [index for index, state in enumerate(support.per_actor) if state != "excluded"]
    floating = [index for index in tested if support.per_actor[index] == "floating"]
    origin, half = (
        np.array([actors[i]["bounds"][field] for i in tested], dtype=float).reshape(-1, 3)
        for field in ("origin_cm", "extent_cm")
    )
    pivot = np.array([actors[i]["transform"]["location_cm"] for i in tested], dtype=float).reshape(-1, 3)
    bottom, top, reach = origin[:, 2] - half[:, 2], origin[:, 2] + half[:, 2], np.maximum(half[:, :2], TINY_CM)
    place = {index: row for row, index in enumerate(tested)}
    sunk = []
    for index in floating:
        row = place[index]
        over = (
            (top > bottom[row])
            & (top <= bottom[row] + GAP_CM)
            & (np.abs(origin[:, :2] - pivot[row, :2]) < 0.5 * reach[row] + reach).all(axis=1)
        )
        over[row] = False
        if over.any():
            sunk.append(index)
    buried = [index for index in tested if bottom[place[index]] < -GAP_CM]
    helpers = [index for index in floating if is_non_solid(actors[index])]

    def named(indices: list[int]) -> list[str]:
        return [str(actors[i].get("name") or actors[i].get("label")) for i in indices]

    found = [
        {
            "code": "sunk_into_its_support",
            "text": "these float only because they reach up to 5 cm into what they stand "
            "on; flush or just above would be supported",
            "actors": named(sunk),
        },
        {
            "code": "supported_below_ground",
            "text": "these reach more than 5 cm under z = 0 and count as supported",
            "actors": named(buried),
        },
        {
            "code": "helper_tested_for_support",
            "text": "lights, effects and other things without a body that the rule "
            "does not exclude by class or label, and finds floating",
            "actors": named(helpers),
        },
    ]
    return [advisory for advisory in found if advisory["actors"]]
