"""What stands about: on pavements, in yards of today and of old."""

from __future__ import annotations

from cases.open190.layout import StagedPlace


def pavement_goods(p: StagedPlace) -> list[str]:
    """What stands on pavements."""
    return [
        *p.kit("bench", 2, back=True),
        *p.kit("bin", 2),
        *p.kit("hydrant", 4),
        *p.kit("planter", 3),
        *p.kit("sign", 4),
        *p.kit("bicycle", 2),
    ]


def yard_goods(p: StagedPlace) -> list[str]:
    """What stands about in works yards."""
    return [*p.kit("pallet", 5), *p.kit("barrel", 3), *p.kit("crate", 3), *p.kit("works", 5), *p.kit("bin", 1)]


def old_goods(p: StagedPlace) -> list[str]:
    """What stands about in yards."""
    return [*p.kit("crate", 3), *p.kit("barrel", 3), *p.kit("sack", 3), *p.kit("handcart", 2)]
