"""Wilson's interval of a share, with scenes as clusters."""

from __future__ import annotations

import math
from collections.abc import Sequence

LEVEL = 0.95


def wilson(clusters: Sequence[tuple[int, int]], level: float = LEVEL) -> tuple[float, float]:
    """The interval of a share over clusters of (right, asked).

    The number asked is divided by the design effect (the variance between clusters over the binomial one, never below
    1: what is alike within a scene is not counted as independent), and the quantile is Student's with one degree of
    freedom less than there are clusters. One cluster, or a share of 0 or 1, has a design effect of 1. (0, 1) for
    nothing.
    """
    from scipy.special import stdtrit

    asked = [row for row in clusters if row[1]]
    n, right = sum(row[1] for row in asked), sum(row[0] for row in asked)
    if not n:
        return 0.0, 1.0
    share, many = right / n, len(asked)
    effect = 1.0
    if many > 1 and 0 < share < 1:
        between = many / (many - 1) * sum((hits - share * size) ** 2 for hits, size in asked) / n**2
        effect = max(1.0, between / (share * (1 - share) / n))
    z = float(stdtrit(max(many - 1, 1) if many > 1 else math.inf, 0.5 + level / 2))
    size = n / effect
    middle = (share + z * z / (2 * size)) / (1 + z * z / size)
    half = z / (1 + z * z / size) * math.sqrt(share * (1 - share) / size + z * z / (4 * size * size))
    return max(0.0, middle - half), min(1.0, middle + half)
