"""All tricks, by name."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from c4s.agents.baselines.blind import outliner, places, poses
from c4s.agents.baselines.blind.guess import Guess
from c4s.agents.baselines.blind.scene import SeenLevel

TRICKS: dict[str, Callable[[SeenLevel], Iterator[Guess]]] = {
    "recomputed ids": outliner.recomputed_ids,
    "recomputed guids": outliner.recomputed_guids,
    "other ids": outliner.other_ids,
    "folders": outliner.folders,
    "tags and components": outliner.tags_and_components,
    "names": outliner.names,
    "order": outliner.order,
    "paint": outliner.paint,
    "mirrored": poses.mirrored,
    "odd sizes": poses.odd_sizes,
    "backwards": poses.backwards,
    "extreme sizes": poses.extreme_sizes,
    "odd turns": poses.odd_turns,
    "round numbers": poses.round_numbers,
    "copies": poses.copies,
    "rows": places.rows,
    "strangers": places.strangers,
    "hovering": places.hovering,
    "sinking": places.sinking,
}


def guesses(scene: SeenLevel) -> dict[str, list[Guess]]:
    """What every trick says of a scene, by the trick's name."""
    return {name: list(trick(scene)) for name, trick in TRICKS.items()}
