"""Castles."""

from __future__ import annotations

import math
from collections.abc import Sequence

from cases.open190.layout import Box, StagedPlace


def castle(p: StagedPlace, box: Box, *, towers: Sequence[str], gatehouse: str, wall: str) -> None:
    """Curtain walls around a rectangle with towers at the corners and a gatehouse in the south."""
    x0, y0, x1, y1 = box
    for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1)):
        p.put(towers, x, y, yaw=p.random.choice((0, 90, 180, -90)))
    p.put(gatehouse, (x0 + x1) / 2, y0, yaw=180)
    reach = max(p.thing(t).width for t in towers) / 2 + 5
    gate = p.thing(gatehouse).width / 2 + 5
    length = p.thing(wall).width + 2
    for a, b in (
        ((x0 + reach, y0), ((x0 + x1) / 2 - gate, y0)),
        (((x0 + x1) / 2 + gate, y0), (x1 - reach, y0)),
        ((x1, y0 + reach), (x1, y1 - reach)),
        ((x1 - reach, y1), (x0 + reach, y1)),
        ((x0, y1 - reach), (x0, y0 + reach)),
    ):
        span, yaw = math.hypot(b[0] - a[0], b[1] - a[1]), math.degrees(math.atan2(b[1] - a[1], b[0] - a[0]))
        count = max(1, math.ceil(span / length - 0.4))
        for i in range(count):
            t = (i + 0.5) / count
            p.put(
                wall,
                a[0] + t * (b[0] - a[0]),
                a[1] + t * (b[1] - a[1]),
                yaw=yaw + 180,
                scale=(round(span / count / length, 4), 1.0, 1.0),
                slack=4,
            )
