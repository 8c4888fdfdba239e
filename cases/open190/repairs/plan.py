"""Which repair each source scene gets: operation group, chain of labels, tier, panel and nested set, from one seed.

The counts are the paper's (``app:case-construction-details``, ``app:public-private``, ``app:difficulty-results``); it
tells no chains of indoor cases, so these are ours. What a private case is, is dealt with the operator's seed: of the
private half the sums are known without it, and the groups that each place has. So no seed deals a place a group that
cannot be drawn there.
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final, Literal

from c4s.records.suite import Visibility
from cases.model import Difficulty, Group

Environment = Literal["indoor", "outdoor"]
PUBLIC_SEED: Final = "open-190/1"
A_SCENE: Final = 8
"""Repairs of a source scene."""
GROUPS: Final[Mapping[Environment, Mapping[Group, int]]] = {
    "indoor": {"Restore": 20, "Lifecycle": 20, "Layout": 10, "Symmetry": 10, "Transform": 20},
    "outdoor": {"Restore": 25, "Lifecycle": 16, "Layout": 19, "Symmetry": 7, "Transform": 13},
}
CHAINS: Final[Mapping[Environment, Mapping[tuple[int, Difficulty], int]]] = {
    "indoor": {
        (1, "easy"): 24,
        (2, "easy"): 3,
        (2, "medium"): 11,
        (3, "medium"): 15,
        (3, "hard"): 7,
        (4, "hard"): 17,
        (5, "hard"): 3,
    },
    "outdoor": {
        (1, "easy"): 25,
        (2, "easy"): 2,
        (2, "medium"): 1,
        (3, "medium"): 25,
        (3, "hard"): 1,
        (4, "hard"): 25,
        (5, "hard"): 1,
    },
}
"""Cases by length of chain and tier."""
PUBLIC: Final[Mapping[Environment, int]] = {"indoor": 25, "outdoor": 50}
PUBLIC_SYMMETRY: Final[Mapping[Environment, int]] = {"indoor": 3, "outdoor": 5}
NESTED: Final[Mapping[int, Mapping[str, int]]] = {
    61: {"text": 16, "indoor": 25, "outdoor": 20},
    75: {"text": 20, "indoor": 25, "outdoor": 30},
    95: {"text": 20, "indoor": 25, "outdoor": 50},
    128: {"text": 28, "indoor": 50, "outdoor": 50},
}
"""Cases of each kind in the nested sets; the first 95 are the public ones."""


@dataclass(frozen=True)
class WantedRepair:
    """What a repair of a scene is to be."""

    case_id: str
    scene_id: str
    environment: Environment
    group: Group
    chain: int
    """Labels, one an authored change."""
    tier: Difficulty
    visibility: Visibility
    nested: int
    """The smallest nested set that it is in; 190 for none."""


@dataclass(frozen=True)
class _Kind:
    group: Group
    chain: int
    tier: Difficulty


def planned(
    scenes: Mapping[Environment, Sequence[str]], visibility: Visibility, seed: str = PUBLIC_SEED
) -> list[WantedRepair]:
    """The repairs of a half of the suite, scene by scene.

    Args:
        scenes: ids of the source scenes of each environment, ten of each.
        visibility: which half.
        seed: deals the half to the scenes; of the private half that of the operator.
    """
    return [wanted for environment in scenes for wanted in _dealt(environment, scenes[environment], visibility, seed)]


def planned_texts(texts: Sequence[str]) -> dict[str, tuple[Visibility, int]]:
    """The half that each text belongs to, and the smallest nested set that it is in."""
    chance = random.Random(f"{PUBLIC_SEED}|texts")
    order = chance.sample(list(texts), len(texts))
    sets: list[int] = []
    for size, counts in NESTED.items():
        sets += [size] * (counts["text"] - len(sets))
    sets += [190] * (len(order) - len(sets))
    return {name: ("public" if size <= 95 else "private", size) for name, size in zip(order, sets, strict=True)}


def _dealt(
    environment: Environment, scenes: Sequence[str], visibility: Visibility, seed: str
) -> Iterator[WantedRepair]:
    halves = _halves(environment)
    kinds, chance = list(halves[visibility]), random.Random(f"{seed}|{environment}|{visibility}")
    chance.shuffle(kinds)
    kinds.sort(key=lambda kind: list(GROUPS[environment]).index(kind.group))
    public = _public_counts(environment, scenes)
    counts = {name: public[name] if visibility == "public" else A_SCENE - public[name] for name in scenes}
    hands: dict[str, list[_Kind]] = {name: [] for name in scenes}
    turn = 0
    for kind in kinds:
        while len(hands[scenes[turn % len(scenes)]]) == counts[scenes[turn % len(scenes)]]:
            turn += 1
        hands[scenes[turn % len(scenes)]].append(kind)
        turn += 1
    nested = iter(_nested(environment, visibility, chance))
    for name in scenes:
        first = 1 if visibility == "public" else public[name] + 1
        for number, kind in enumerate(hands[name], first):
            yield WantedRepair(
                f"{name}-{number}", name, environment, kind.group, kind.chain, kind.tier, visibility, next(nested)
            )


def _halves(environment: Environment) -> dict[Visibility, list[_Kind]]:
    """The kinds of all repairs of an environment, parted into the two halves."""
    chance = random.Random(f"{PUBLIC_SEED}|{environment}")
    chains = [pair for pair, count in CHAINS[environment].items() for _ in range(count)]
    chance.shuffle(chains)
    groups = [group for group, count in GROUPS[environment].items() for _ in range(count)]
    kinds = [_Kind(group, *pair) for group, pair in zip(groups, chains, strict=True)]
    chance.shuffle(kinds)
    symmetry = [kind for kind in kinds if kind.group == "Symmetry"]
    others = [kind for kind in kinds if kind.group != "Symmetry"]
    mine = PUBLIC_SYMMETRY[environment]
    rest = PUBLIC[environment] - mine
    return {"public": symmetry[:mine] + others[:rest], "private": symmetry[mine:] + others[rest:]}


def _public_counts(environment: Environment, scenes: Sequence[str]) -> dict[str, int]:
    """How many repairs of each scene are public: as even as can be."""
    each, more = divmod(PUBLIC[environment], len(scenes))
    chance = random.Random(f"{PUBLIC_SEED}|{environment}|counts")
    fuller = set(chance.sample(list(scenes), more))
    return {name: each + (name in fuller) for name in scenes}


def _nested(environment: Environment, visibility: Visibility, chance: random.Random) -> list[int]:
    """The smallest nested set of each repair of a half, in an order that the seed decides."""
    sets: list[int] = []
    for size, counts in NESTED.items():
        so_far = len(sets) if visibility == "public" else PUBLIC[environment] + len(sets)
        if (size <= 95) == (visibility == "public"):
            sets += [size] * (counts[environment] - so_far)
    whole = PUBLIC[environment] if visibility == "public" else sum(GROUPS[environment].values()) - PUBLIC[environment]
    sets += [190] * (whole - len(sets))
    chance.shuffle(sets)
    return sets


def histogram(wanted: Sequence[WantedRepair], environment: Environment) -> dict[str, Counter[object]]:
    """Groups, chains, tiers and nested sets of the repairs of an environment."""
    rows = [one for one in wanted if one.environment == environment]
    return {
        "groups": Counter(one.group for one in rows),
        "chains": Counter(one.chain for one in rows),
        "tiers": Counter(one.tier for one in rows),
        "visibility": Counter(one.visibility for one in rows),
        "nested": Counter(one.nested for one in rows),
    }
