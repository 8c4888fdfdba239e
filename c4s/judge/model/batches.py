"""Which claims share a request: those that are seen in the same pictures, so many at a time as the configuration
says."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Batch:
    """Claims with the views that are shown for all of them, in the order in which they are shown."""

    claims: tuple[str, ...]
    views: tuple[str, ...]


def batches(
    wanted: Mapping[str, Sequence[str]], order: Sequence[str], *, most_claims: int, most_views: int
) -> list[Batch]:
    """Batches over all claims, in the order of their first claims. Equal claims give equal batches.

    A claim joins the first batch that shows one of its views and has room for it and for its other views.

    Args:
        wanted: views by claim, the most wanted first; what is beyond ``most_views`` is left out.
        order: of the views.
        most_claims: in a batch.
        most_views: in a batch.
    """
    made: list[tuple[list[str], dict[str, None]]] = []
    for claim, names in wanted.items():
        kept = dict.fromkeys(list(names)[:most_views])
        for claims, views in made:
            shared = any(name in views for name in kept)
            if shared and len(claims) < most_claims and len({**views, **kept}) <= most_views:
                claims.append(claim)
                views |= kept
                break
        else:
            made.append(([claim], kept))
    place = {name: number for number, name in enumerate(order)}
    return [Batch(tuple(claims), tuple(sorted(views, key=place.__getitem__))) for claims, views in made]


def halves(batch: Batch) -> list[Batch]:
    """The same in two requests, where one is too long for the model."""
    middle = len(batch.claims) // 2
    return [Batch(claims, batch.views) for claims in (batch.claims[:middle], batch.claims[middle:])]
