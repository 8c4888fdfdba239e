"""Several tests at once."""

from __future__ import annotations

import numpy as np

from c4s.stats.bootstrap import Floats


def holm(p: object) -> Floats:
    """p-values adjusted for their number (Holm 1979): below a level, the chance of one false finding is below it.

    Args:
        p: shape (tests,), in [0, 1]; NaN is no test.

    Returns:
        The same shape, in the same order; at least as large as given.
    """
    given = np.asarray(p, dtype=np.float64)
    adjusted = np.full(given.shape, np.nan)
    (tests,) = np.nonzero(~np.isnan(given))
    order = tests[np.argsort(given[tests], kind="stable")]
    factors = np.arange(len(order), 0, -1)
    adjusted[order] = np.minimum(1.0, np.maximum.accumulate(factors * given[order]))
    return adjusted
