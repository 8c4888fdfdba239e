"""A consensus of rankings by Plackett and Luce, within each prompt (paper, ``sec:human-alignment``)."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Final

import numpy as np

from c4s.stats.bootstrap import Floats
from c4s.stats.human.preferences import HumanOrder, Preferences

L2: Final = 0.1
"""Coefficient of the sum of squared log-worths, so that unanimous preferences have finite ones."""
TIE: Final = 1e-8
"""Two numbers that differ by no more are one: the paper's numerical tie, of log-worths too."""
NOBODY: Final = -1
"""The annotator of preferences that are a consensus."""


def log_worths(
    rankings: Sequence[HumanOrder], prompts: int, candidates: int, among: Collection[int] | None = None
) -> Floats:
    """Log-worths of the candidates of each prompt, from the triplet rankings themselves.

    Args:
        rankings: of all prompts.
        among: prompts to fit; all that have a ranking without.

    Returns:
        Shape (prompts, candidates); NaN where a prompt has no ranking or is not asked for. They sum to 0 in each.
    """
    import choix

    found = np.full((prompts, candidates), np.nan)
    of_prompt: dict[int, list[tuple[int, ...]]] = {}
    for one in rankings:
        if among is None or one.prompt in among:
            of_prompt.setdefault(one.prompt, []).append(one.order)
    for prompt, orders in of_prompt.items():
        found[prompt] = choix.opt_rankings(candidates, orders, alpha=L2)
    return found


def consensus(worths: Floats) -> Preferences:
    """What a consensus says of every pair of candidates; a pair of equal worths has no label and is left out.

    Args:
        worths: shape (prompts, candidates); prompts of NaN say nothing.
    """
    first, second = np.triu_indices(worths.shape[1], k=1)
    gap = worths[:, first] - worths[:, second]
    with np.errstate(invalid="ignore"):
        prompt, pair = np.nonzero(np.abs(gap) > TIE)
    sign = np.sign(gap[prompt, pair]).astype(np.int64)
    return Preferences(
        prompt=prompt,
        annotator=np.full(len(sign), NOBODY),
        first=first[pair],
        second=second[pair],
        sign=sign,
        prompts=worths.shape[0],
        candidates=worths.shape[1],
    )
