"""Furniture of the office: desks, seating, storage. The front faces +Y."""

from __future__ import annotations

import math

from catalog.shapes import Builder, Kit
from catalog.starter.furniture_parts import fronts, legs

KIT = Kit()


@KIT.asset("OfficeDesk", "desks", "Desk with oak top and steel frame, 160 x 80 cm, 74 cm high.", "desk table work")
def _desk(b: Builder) -> None:
    b.box("OakWood", (160, 80, 3), (0, 0, 71), bevel=0.5)
    for x in (-74, 74):
        for y in (-34, 34):
            b.box("DarkMetal", (5, 5, 71), (x, y, 0))
        b.box("DarkMetal", (5, 64, 4), (x, 0, 66), body=None)
        b.box("DarkMetal", (5, 64, 3), (x, 0, 6), body=None)
    b.box("DarkMetal", (143, 2, 30), (0, -33, 38))


@KIT.asset(
    "StandingDesk",
    "desks",
    "Height-adjustable desk raised for standing, white top, 140 x 70 cm, 108 cm high.",
    "desk standing adjustable",
)
def _standing(b: Builder) -> None:
    b.box("WhiteLaminate", (140, 70, 3), (0, 0, 105), bevel=0.5)
    for x in (-50, 50):
        b.box("GreyPlastic", (8, 10, 60), (x, 0, 3))
        b.box("Steel", (6, 8, 45), (x, 0, 60))
        b.box("GreyPlastic", (8, 62, 3), (x, 0, 0), bevel=0.8)
    b.box("GreyPlastic", (100, 6, 4), (0, 0, 101))
    b.box("BlackPlastic", (10, 4, 2), (50, 31, 103), body=None)


@KIT.asset(
    "MeetingTable",
    "desks",
    "Meeting table with rounded walnut top on two pedestals, 240 x 110 cm.",
    "table meeting conference",
)
def _meeting(b: Builder) -> None:
    outline = [
        (
            110 * abs(math.cos(a)) ** 0.35 * math.copysign(1, math.cos(a)) * 1.09,
            55 * abs(math.sin(a)) ** 0.45 * math.copysign(1, math.sin(a)),
        )
        for a in [2 * math.pi * i / 40 for i in range(40)]
    ]
    b.extrude("WalnutWood", outline, 4, (0, 0, 70))
    for x in (-60, 60):
        b.box("DarkMetal", (10, 40, 66), (x, 0, 4))
        b.box("DarkMetal", (14, 76, 4), (x, 0, 0), bevel=1)
    b.box("BlackPlastic", (30, 12, 1), (0, 0, 73.6), bevel=0.3, body=None)


@KIT.asset("RoundTable", "desks", "Round cafe table on one leg, 80 cm across, 74 cm high.", "table round cafe")
def _round(b: Builder) -> None:
    b.cylinder("WhiteLaminate", 40, 3, (0, 0, 71), segments=32)
    b.cylinder("DarkMetal", 4, 69, (0, 0, 2), segments=14)
    b.cylinder("DarkMetal", 24, 2, segments=24, top=22)


@KIT.asset("SideTable", "desks", "Low oak table, 70 x 50 cm, 41 cm high.", "table low lounge coffee")
def _side(b: Builder) -> None:
    b.box("OakWood", (70, 50, 3), (0, 0, 38), bevel=0.6)
    legs(b, "DarkMetal", (64, 44), 38, 3.5, round_=True)
    b.box("OakWood", (58, 38, 2), (0, 0, 14), body=None)


@KIT.asset(
    "ReceptionCounter",
    "desks",
    "Reception counter with a raised front and a lower desk behind, 220 cm wide.",
    "counter reception desk",
)
def _reception(b: Builder) -> None:
    b.box("OakWood", (220, 8, 108), (0, 36, 0))
    b.box("WhiteLaminate", (226, 30, 4), (0, 32, 108), bevel=0.8)
    b.box("WhiteLaminate", (212, 62, 3), (0, -1, 71), bevel=0.5)
    for x in (-107, 107):
        b.box("OakWood", (6, 72, 108), (x, -4, 0))
    for x in range(-88, 96, 22):
        b.box("GreyLaminate", (10, 1.5, 92), (x, 40.6, 8), body=None)


def _castor_base(b: Builder, height: float) -> None:
    for i in range(5):
        a = 2 * math.pi * i / 5 + math.pi / 2
        c, s = math.cos(a), math.sin(a)
        b.tube("BlackPlastic", [(0, 0, 9), (15 * c, 15 * s, 8.5), (29 * c, 29 * s, 6.5)], 2.0, segments=6)
        b.ellipsoid("BlackPlastic", (6, 6, 6), (29 * c, 29 * s, 0), segments=10, body=None)
    b.body_box((50, 50, 9))
    b.cylinder("Steel", 2.6, height - 9, (0, 0, 9), segments=12)


@KIT.asset(
    "TaskChair",
    "seating",
    "Swivel task chair with arm rests and a mesh back on five castors.",
    "chair swivel office task",
)
def _task(b: Builder) -> None:
    _castor_base(b, 43)
    b.box("BlueFabric", (48, 47, 7), (0, 0, 43), bevel=3)
    b.box("BlackPlastic", (6, 4, 34), (0, -25, 42), (-6, 90, 0), body=None)
    with b.moved((0, -24, 54), (0, 0, -8)):
        b.box("MeshFabric", (44, 5, 48), bevel=2.4)
        b.box("BlackPlastic", (30, 2, 8), (0, -3, 8), bevel=0.8, body=None)
    for x in (-27, 27):
        b.box("BlackPlastic", (5, 26, 3), (x, 0, 65), bevel=1)
        b.box("BlackPlastic", (3, 6, 20), (x, 0, 46), body=None)
        b.box("BlackPlastic", (10, 6, 2.5), (x * 0.85, 0, 45), body=None)


@KIT.asset(
    "ConferenceChair", "seating", "Padded conference chair on a steel cantilever frame.", "chair conference meeting"
)
def _conference(b: Builder) -> None:
    for x in (-24, 24):
        b.tube(
            "Steel",
            [
                (x, -22, 1.3),
                (x, 24, 1.3),
                (x, 26, 4),
                (x, 24, 40),
                (x, 22, 43),
                (x, -18, 43),
                (x, -23, 60),
                (x, -26, 84),
            ],
            1.3,
            segments=8,
        )
        b.body_box((3, 50, 3), (x, 1, 0))
        b.body_box((3, 3, 42), (x, 25, 0))
    b.tube("Steel", [(-24, -22, 1.3), (24, -22, 1.3)], 1.3)
    b.box("TealFabric", (47, 46, 6), (0, 2, 42), bevel=2)
    with b.moved((0, -22, 50), (0, 0, -9)):
        b.box("TealFabric", (47, 5, 42), bevel=2)


@KIT.asset(
    "VisitorChair", "seating", "Stackable visitor chair with orange shell and four legs.", "chair visitor stackable"
)
def _visitor(b: Builder) -> None:
    legs(b, "Steel", (46, 44), 43, 2.6, round_=True)
    b.box("OrangeFabric", (46, 44, 3.5), (0, 0, 43), bevel=1.4)
    with b.moved((0, -20.5, 46), (0, 0, -10)):
        b.box("OrangeFabric", (44, 3.5, 36), bevel=1.4)


@KIT.asset("BarStool", "seating", "High stool with a round oak seat and a foot ring.", "stool bar high")
def _stool(b: Builder) -> None:
    b.cylinder("OakWood", 18, 4, (0, 0, 71), segments=24)
    for i in range(4):
        a = math.pi / 4 + i * math.pi / 2
        c, s = math.cos(a), math.sin(a)
        b.tube("DarkMetal", [(21 * c, 21 * s, 0.5), (13 * c, 13 * s, 72)], 1.4)
    ring = [2 * math.pi * i / 20 for i in range(21)]
    b.tube("DarkMetal", [(18.6 * math.cos(a), 18.6 * math.sin(a), 24) for a in ring], 1.0)
    b.body_box((34, 34, 71))


@KIT.asset("OfficeSofa", "seating", "Two-seat sofa with teal cushions, 150 x 80 cm.", "sofa couch lounge two-seat")
def _sofa(b: Builder) -> None:
    legs(b, "OakWood", (140, 70), 12, 5, round_=True)
    b.box("TealFabric", (150, 78, 20), (0, 0, 12), bevel=3)
    for x in (-32, 32):
        b.box("TealFabric", (62, 60, 12), (x, 7, 32), bevel=4)
        with b.moved((x, -22, 42), (0, 0, -12)):
            b.box("TealFabric", (61, 14, 36), bevel=5)
    b.box("TealFabric", (150, 14, 46), (0, -33, 30), bevel=4)
    for x in (-69, 69):
        b.box("TealFabric", (12, 74, 32), (x, 0, 30), bevel=4)


@KIT.asset(
    "FilingCabinet",
    "storage",
    "Steel filing cabinet with four drawers, 46 x 62 cm, 132 cm high.",
    "cabinet filing drawers steel",
)
def _filing(b: Builder) -> None:
    b.box("GreyLaminate", (46, 60, 132), (0, -1, 0), bevel=0.6)
    fronts(b, "GreyPlastic", "Steel", 45, 28.5, 4, 127, 4)
    for row in range(4):
        b.box("Paper", (9, 0.4, 4), (0, 30.4, 4 + (row + 0.45) * 31.75), body=None)


@KIT.asset(
    "DrawerPedestal",
    "storage",
    "Under-desk pedestal with three drawers, 42 x 55 cm, 58 cm high.",
    "drawers pedestal under-desk",
)
def _pedestal(b: Builder) -> None:
    b.box("WhiteLaminate", (42, 53, 55), (0, -1, 3), bevel=0.5)
    fronts(b, "WhiteLaminate", "Steel", 41, 25, 4, 53, 3)
    legs(b, "BlackPlastic", (38, 48), 3, 4)


@KIT.asset(
    "TallBookshelf", "storage", "Oak bookshelf with five boards, 90 x 30 cm, 200 cm high.", "bookshelf shelf tall"
)
def _bookshelf(b: Builder) -> None:
    for x in (-44, 44):
        b.box("OakWood", (2.5, 30, 200), (x, 0, 0))
    for z in (4, 42, 80, 118, 156, 197.5):
        b.box("OakWood", (85.5, 29, 2.5), (0, 0, z))
    b.box("OakWood", (85.5, 1, 195), (0, -14, 3))


@KIT.asset(
    "LowCabinet", "storage", "Low cabinet with two sliding doors, 120 x 45 cm, 75 cm high.", "cabinet sideboard low"
)
def _low(b: Builder) -> None:
    b.box("WhiteLaminate", (120, 44, 69), (0, -0.5, 4))
    b.box("OakWood", (122, 46, 2), (0, 0, 73), bevel=0.4)
    b.box("GreyLaminate", (112, 38, 4), (0, -1, 0), body="box")
    fronts(b, "GreyLaminate", "Steel", 118, 21, 6, 65, 1, 2, upright=True)


@KIT.asset(
    "StaffLockers", "storage", "Block of six lockers in two rows, 90 x 45 cm, 180 cm high.", "locker storage staff"
)
def _lockers(b: Builder) -> None:
    b.box("GreyLaminate", (90, 44, 172), (0, -0.5, 8))
    b.box("BlackPlastic", (86, 38, 8), (0, -1, 0))
    fronts(b, "BlueFabric", "Steel", 88, 21.5, 9, 170, 2, 3, upright=True)


@KIT.asset(
    "CoatStand", "storage", "Coat stand with eight hooks and a round base, 175 cm high.", "coat stand rack hooks"
)
def _coats(b: Builder) -> None:
    b.cylinder("DarkMetal", 19, 2.5, segments=24, top=17)
    b.cylinder("WalnutWood", 2.2, 170, (0, 0, 2.5), segments=14)
    b.ellipsoid("WalnutWood", (6, 6, 6), (0, 0, 170), segments=12, body=None)
    for i in range(4):
        c, s = math.cos(i * math.pi / 2), math.sin(i * math.pi / 2)
        for z, reach in ((150, 15), (115, 11)):
            b.tube(
                "WalnutWood",
                [(c, s, z), (reach * c, reach * s, z + 3), ((reach + 4) * c, (reach + 4) * s, z + 11)],
                1.1,
                segments=6,
            )
