"""Museum of antiquities."""

from __future__ import annotations

from cases.open190.layout import StagedPlace
from cases.open190.scenes import scene
from catalog.kits import styles


@scene(
    "museum",
    "indoor",
    "Museum of antiquities",
    styles.URBAN.but(wall=("CreamPlaster",), stone=("Limestone", "Granite", "Marble"), wood=("Walnut", "Oak")),
    slot=True,
)
def museum(p: StagedPlace) -> None:
    """Halls with show cases, statues, columns, a skeleton, benches and barriers."""
    p.room(
        (-1600, -1000, 1600, 1000),
        "Marble",
        wall="CreamPlaster",
        high=460,
        S=("Plain", "Window", "Arch", "Window"),
        N=("Plain", "Window"),
    )
    for x in (-530, 530):
        for y, kind in ((-800, "Plain"), (-400, "Arch"), (0, "Plain"), (400, "Arch"), (800, "Plain")):
            p.put(p.one("room-wall", kind=kind, length=396.0, high=460.0, wall="CreamPlaster"), x, y, yaw=90)
    cased = p.kit("display", 9, kind="TallCase")
    tables, pedestals = p.kit("display", 6, kind="TableCase"), p.kit("display", 9, kind="Pedestal")
    p.put(p.one("display", kind="SkeletonPlinth"), 0, 0)
    p.put(p.one("display", kind="SkeletonPlinth", noun="DinosaurSkeleton"), 0, 560, yaw=180)
    p.row((-420, -800), (420, -800), p.kit("column", 2, broken=False, height=400.0), 4)
    ring_posts = p.kit("bollard", 1, stone="Brass")
    for x in range(-300, 301, 100):
        p.put(ring_posts, x, -210)
        p.put(ring_posts, x, 210)
    for side in (-1, 1):
        with p.at(side * 1060, 0):
            p.grid((-330, -760, 330, 760), cased + tables, 3, 6, jitter=10)
            p.grid((-165, -620, 165, 620), p.kit("bench", 3, back=False), 2, 4)
            p.along((489, -980), (489, 980), pedestals, 34, fill=True) if side > 0 else p.along(
                (-489, 980), (-489, -980), pedestals, 34, fill=True
            )
    p.row((-1450, 930), (-650, 930), p.kit("statue", 5), 5, yaw=180)
    p.row((1450, 930), (650, 930), p.kit("statue", 5), 5, yaw=0)
    p.row((-400, 930), (400, 930), p.kit("statue", 3, kind="Figure"), 4, yaw=180)
    p.put(p.one("counter", kind="ReceptionDesk", length=300.0), 330, -640, yaw=180)
    p.grid((-1500, -930, 1500, -930), [*p.kit("board", 3, kind="PosterStand"), *p.kit("house-plant", 3)], 14, 1)
    p.scatter(
        (-480, -560, 480, -260),
        [*p.kit("board", 2, kind="PosterStand"), *p.kit("bench", 2, back=False), *p.kit("house-plant", 2)],
        9,
        clear=30,
    )
    p.scatter(
        (-1550, -900, 1550, 900),
        [*pedestals, *p.kit("music", 2, kind="Easel"), *p.kit("bench", 2, back=False)],
        40,
        clear=50,
    )
    p.beams((-1600, -1000, 1600, 1000), 460, 8, "WhitePaint")
    for x in (-1060, 0, 1060):
        for y in (-600, 0, 600):
            p.light(x, y, 380, intensity=3600, radius=1200, colour=(255, 244, 226))
    p.sun(-60, 60, intensity=2.0, sky=0.7)
    p.view("hall", (-20, -760, 170), (10, 300, 110), 78)
    p.view("gallery", (1480, -900, 170), (900, 500, 100), 75)
