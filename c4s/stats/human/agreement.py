"""How far people agree with each other and with a score: within prompts, then the mean over prompts (paper,
``sec:human-alignment``).

Candidates of a prompt are shared by its preferences, so whole prompts are drawn for intervals, never preferences.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Final

import numpy as np

from c4s.stats.alpha import nominal_alphas
from c4s.stats.bootstrap import LEVEL, Design, Floats, domain_means, percentile_interval
from c4s.stats.human.consensus import TIE, consensus, log_worths
from c4s.stats.human.preferences import HumanOrder, Preferences
from c4s.stats.repeats import tau_b

DRAWS: Final = 5_000
"""Of agreement and rank correlation."""
ALPHA_DRAWS: Final = 2_000
"""Of Krippendorff's alpha."""
SPLITS: Final = 10
"""Ways in which the annotators are split into two groups."""
Progress = Callable[[str, int, int], None]
"""Told what is done, how much of it, and how much there is."""


@dataclass(frozen=True)
class MacroMean:
    """A mean over prompts with the percentile interval of whole-prompt draws; NaN where there is none.

    One prompt has no interval.
    """

    value: float
    low: float
    high: float
    prompts: int
    """How many prompts have a value."""


def macro_mean(by_prompt: Floats, seed: int, draws: int = DRAWS, level: float = LEVEL) -> MacroMean:
    """The mean of the prompts that have a value.

    Args:
        by_prompt: shape (prompts,), NaN where a prompt has none.
    """
    known = by_prompt[~np.isnan(by_prompt)]
    if len(known) < 2:
        return MacroMean(float(known[0]) if len(known) else np.nan, np.nan, np.nan, len(known))
    design = Design.of(list(range(len(known))), ["prompts"] * len(known))
    drawn = domain_means(design, design.draw(draws, seed), known)[:, 0]
    low, high = percentile_interval(drawn, level)
    return MacroMean(float(known.mean()), float(low[0]), float(high[0]), len(known))


def between_annotators(preferences: Preferences) -> Floats:
    """Share of two annotators of one pair of candidates who prefer the same, by prompt, shape (prompts,)."""
    votes = preferences.units()
    raters = votes.won + votes.lost
    with np.errstate(invalid="ignore", divide="ignore"):
        equal = (votes.won * (votes.won - 1) + votes.lost * (votes.lost - 1)) / (raters * (raters - 1))
    return _by_prompt(votes.prompt, equal, preferences.prompts)


def with_scores(scores: Floats, preferences: Preferences) -> Floats:
    """Share of preferences that a score agrees with, by prompt, shape (prompts,).

    Scores that are numerically equal agree with nothing: preferences are strict. A prompt's pairs count the same, and
    so do the reviewers of a pair.

    Args:
        scores: shape (prompts, candidates).
    """
    votes = preferences.units()
    gap = scores[votes.prompt, votes.first] - scores[votes.prompt, votes.second]
    credit = np.where(gap > TIE, votes.won, np.where(gap < -TIE, votes.lost, 0.0)) / (votes.won + votes.lost)
    return _by_prompt(votes.prompt, np.where(np.isnan(gap), np.nan, credit), preferences.prompts)


def tau_by_prompt(scores: Floats, worths: Floats) -> Floats:
    """Kendall's tau-b of two scores of the candidates of each prompt, shape (prompts,); NaN where it has no value."""
    return _rank_correlation(scores, worths, tau_b)


def rho_by_prompt(scores: Floats, worths: Floats) -> Floats:
    """Spearman's rho with average ranks, as ``tau_by_prompt``."""
    from scipy.stats import spearmanr

    return _rank_correlation(scores, worths, lambda one, two: float(spearmanr(one, two).statistic))


def krippendorff_alpha(
    preferences: Preferences, seed: int, draws: int = ALPHA_DRAWS, level: float = LEVEL
) -> MacroMean:
    """Krippendorff's alpha: a unit is a pair of candidates of a prompt, a label which of the two won.

    The candidate of the lower number stands first in every pair. It is of all
    units together; its interval is of whole prompts drawn.
    """
    votes = preferences.units()
    counts = np.column_stack([votes.won, votes.lost])
    prompts, group = np.unique(votes.prompt, return_inverse=True)
    whole = float(nominal_alphas(counts, group, np.arange(len(prompts))[None])[0])
    if len(prompts) < 2:
        return MacroMean(whole, np.nan, np.nan, len(prompts))
    drawn = np.random.default_rng(seed).integers(0, len(prompts), (draws, len(prompts)))
    low, high = percentile_interval(nominal_alphas(counts, group, drawn)[:, None], level)
    return MacroMean(whole, float(low[0]), float(high[0]), len(prompts))


def left_out(
    rankings: Sequence[HumanOrder], prompts: int, candidates: int, progress: Progress | None = None
) -> dict[int, Floats]:
    """For each annotator the share of own preferences that the consensus of all others has, by prompt.

    Who clicks at random agrees with half of it.
    """
    annotators = sorted({one.annotator for one in rankings})
    found = {}
    for number, annotator in enumerate(annotators):
        own = [one for one in rankings if one.annotator == annotator]
        others = [one for one in rankings if one.annotator != annotator]
        worths = log_worths(others, prompts, candidates, among={one.prompt for one in own})
        found[annotator] = with_scores(worths, Preferences.of(own, prompts, candidates))
        if progress is not None:
            progress("leaving out one annotator", number + 1, len(annotators))
    return found


def between_groups(
    rankings: Sequence[HumanOrder], prompts: int, candidates: int, seed: int, progress: Progress | None = None
) -> tuple[Floats, Floats]:
    """How far the consensus of a part of the annotators agrees with that of all others.

    Annotators are split in two by the seed, ``SPLITS`` times or in every way there is.

    Returns:
        Share of pairs in one order and tau-b, each a mean over the splits, shape (prompts,).
    """
    annotators = sorted({one.annotator for one in rankings})
    ways = list(combinations(annotators, len(annotators) // 2))
    if len(ways) > SPLITS:
        chosen = np.random.default_rng(seed).choice(len(ways), SPLITS, replace=False)
        ways = [ways[way] for way in sorted(chosen.tolist())]
    shares, taus = [], []
    for number, way in enumerate(ways):
        one = log_worths([row for row in rankings if row.annotator in way], prompts, candidates)
        two = log_worths([row for row in rankings if row.annotator not in way], prompts, candidates)
        shares.append(with_scores(one, consensus(two)))
        taus.append(tau_by_prompt(one, two))
        if progress is not None:
            progress("comparing two groups of annotators", number + 1, len(ways))
    return _mean_known(shares), _mean_known(taus)


def _mean_known(rows: list[Floats]) -> Floats:
    table = np.array(rows)
    known = ~np.isnan(table)
    with np.errstate(invalid="ignore"):
        return np.asarray(np.where(known, table, 0.0).sum(axis=0) / known.sum(axis=0))


def _by_prompt(prompt: np.ndarray, values: Floats, prompts: int) -> Floats:
    known = ~np.isnan(values)
    sums = np.bincount(prompt[known], weights=values[known], minlength=prompts)
    with np.errstate(invalid="ignore"):
        return np.asarray(sums / np.bincount(prompt[known], minlength=prompts))


def _rank_correlation(scores: Floats, worths: Floats, of: Callable[[Floats, Floats], float | None]) -> Floats:
    found = np.full(len(scores), np.nan)
    for prompt, (one, two) in enumerate(zip(scores, worths, strict=True)):
        if np.isfinite([one, two]).all() and np.ptp(one) > 0 and np.ptp(two) > 0:
            value = of(one, two)
            found[prompt] = np.nan if value is None else value
    return found
