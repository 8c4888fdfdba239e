"""The materials of the kits by name. A material's name, read as words, is what names and descriptions call it."""

from __future__ import annotations

import functools

from catalog.shapes import MaterialSpec
from catalog.shapes.textures import (
    Rgb,
    Texture,
    bricks,
    carpet,
    fabric,
    mottled,
    painting,
    planks,
    screen,
    stripes,
    tiles,
    wood,
)


def linear(color: Rgb) -> tuple[float, float, float]:
    """An sRGB colour of bytes as linear RGB, rounded so that every machine writes the same digits."""
    red, green, blue = (round((part / 255) ** 2.2, 3) for part in color)
    return red, green, blue


_WOODS: dict[str, Rgb] = {
    "Oak": (186, 148, 104),
    "Walnut": (110, 76, 52),
    "Pine": (212, 176, 128),
    "DarkOak": (84, 62, 46),
    "Birch": (226, 204, 168),
    "Cherry": (150, 88, 58),
    "GreyWood": (142, 136, 126),
    "Ebony": (52, 44, 42),
}
_PLANKS: dict[str, Rgb] = {
    "Planks": (160, 122, 82),
    "DarkPlanks": (98, 74, 54),
    "PalePlanks": (206, 180, 142),
    "GreyPlanks": (138, 134, 126),
    "RedBoards": (150, 58, 46),
    "WhiteBoards": (222, 218, 206),
    "BlueBoards": (92, 124, 150),
    "GreenBoards": (104, 128, 92),
    "Parquet": (168, 122, 78),
}
_PLASTERS: dict[str, Rgb] = {
    "WhitePlaster": (232, 228, 216),
    "CreamPlaster": (228, 214, 184),
    "OchrePlaster": (214, 168, 88),
    "PinkPlaster": (222, 168, 156),
    "RedPlaster": (168, 76, 62),
    "BluePlaster": (126, 154, 178),
    "GreenPlaster": (140, 162, 132),
    "GreyPlaster": (168, 168, 164),
    "SandPlaster": (212, 186, 142),
    "Clay": (186, 132, 92),
    "Concrete": (158, 158, 154),
    "DarkConcrete": (108, 110, 112),
    "VioletPlaster": (150, 128, 172),
    "TealPlaster": (86, 146, 146),
}
_BRICKS: dict[str, tuple[Rgb, Rgb]] = {
    "RedBrick": ((152, 80, 60), (178, 166, 152)),
    "DarkBrick": ((100, 68, 58), (138, 128, 118)),
    "YellowBrick": ((206, 176, 120), (182, 172, 156)),
    "WhiteBrick": ((222, 218, 210), (188, 184, 176)),
}
_STONES: dict[str, tuple[Rgb, Rgb]] = {
    "Fieldstone": ((150, 146, 136), (102, 98, 90)),
    "Granite": ((140, 142, 146), (100, 102, 106)),
    "Sandstone": ((206, 176, 132), (164, 134, 96)),
    "Limestone": ((216, 208, 188), (176, 168, 150)),
    "DarkStone": ((92, 94, 98), (60, 62, 66)),
    "MossyStone": ((122, 132, 104), (84, 92, 70)),
    "Slate": ((86, 92, 102), (56, 60, 68)),
}
_ROOFS: dict[str, tuple[Rgb, Rgb]] = {
    "RedTile": ((176, 84, 54), (116, 54, 38)),
    "BrownTile": ((126, 84, 60), (84, 56, 40)),
    "SlateTile": ((84, 90, 100), (56, 60, 68)),
    "BlueTile": ((70, 104, 148), (46, 70, 104)),
    "GreenTile": ((84, 122, 92), (56, 84, 62)),
    "VioletTile": ((112, 84, 140), (76, 56, 98)),
    "Shingle": ((132, 108, 82), (90, 72, 54)),
    "OrangeTile": ((206, 118, 66), (150, 80, 44)),
}
_MOTTLED: dict[str, tuple[Rgb, float, float]] = {
    "Thatch": ((184, 152, 92), 0.16, 0.18),
    "Grass": ((104, 134, 62), 0.16, 0.12),
    "DryGrass": ((164, 152, 88), 0.16, 0.12),
    "Moss": ((92, 118, 58), 0.2, 0.1),
    "Soil": ((98, 74, 54), 0.18, 0.12),
    "DarkSoil": ((64, 50, 40), 0.18, 0.12),
    "Sand": ((222, 198, 150), 0.07, 0.06),
    "RedSand": ((196, 130, 86), 0.08, 0.06),
    "Gravel": ((162, 152, 136), 0.1, 0.16),
    "Cinder": ((84, 80, 78), 0.1, 0.16),
    "Snow": ((238, 242, 248), 0.03, 0.02),
    "Asphalt": ((84, 84, 86), 0.05, 0.08),
    "Rubber": ((52, 52, 56), 0.05, 0.06),
    "Leaf": ((86, 124, 54), 0.24, 0.18),
    "DarkLeaf": ((56, 96, 52), 0.24, 0.18),
    "PaleLeaf": ((138, 162, 82), 0.2, 0.16),
    "AutumnLeaf": ((202, 116, 46), 0.26, 0.18),
    "GoldenLeaf": ((216, 172, 62), 0.22, 0.16),
    "Blossom": ((236, 176, 192), 0.16, 0.14),
    "VioletLeaf": ((138, 96, 172), 0.22, 0.16),
    "Needle": ((48, 84, 58), 0.26, 0.2),
    "Bark": ((104, 80, 60), 0.24, 0.14),
    "PaleBark": ((206, 200, 186), 0.18, 0.1),
    "Straw": ((220, 184, 104), 0.16, 0.16),
    "Hay": ((200, 170, 96), 0.16, 0.18),
    "Rust": ((148, 84, 52), 0.22, 0.1),
    "Rock": ((132, 128, 122), 0.14, 0.1),
    "RedRock": ((172, 110, 80), 0.14, 0.1),
    "Crop": ((96, 140, 58), 0.22, 0.16),
    "Wheat": ((222, 186, 96), 0.14, 0.16),
    "Cork": ((188, 146, 100), 0.12, 0.12),
    "Marble": ((228, 224, 216), 0.05, 0.02),
    "BlackMarble": ((56, 56, 60), 0.14, 0.02),
    "Terracotta": ((180, 102, 70), 0.08, 0.04),
    "Fur": ((150, 108, 68), 0.16, 0.2),
    "Rope": ((184, 158, 112), 0.14, 0.16),
    "Net": ((86, 116, 96), 0.2, 0.24),
    "GreyCarpet": ((118, 122, 128), 0.06, 0.1),
    "BlueCarpet": ((70, 92, 136), 0.06, 0.1),
    "RedCarpet": ((150, 48, 50), 0.06, 0.1),
    "GreenCarpet": ((80, 116, 88), 0.06, 0.1),
    "Worktop": ((94, 92, 90), 0.15, 0.12),
}
_TILES: dict[str, tuple[Rgb, Rgb, Rgb | None, int]] = {
    "Cobble": ((132, 128, 120), (88, 84, 78), None, 8),
    "Paving": ((178, 172, 160), (144, 138, 128), None, 4),
    "Flagstone": ((150, 148, 142), (104, 102, 96), None, 3),
    "WhiteTiles": ((226, 230, 230), (180, 188, 190), None, 4),
    "BlueTiles": ((110, 152, 186), (190, 200, 204), None, 4),
    "GreenTiles": ((120, 168, 144), (196, 204, 196), None, 4),
    "ChessTiles": ((226, 222, 214), (150, 148, 142), (72, 76, 82), 4),
    "TerracottaTiles": ((186, 112, 80), (140, 100, 80), None, 4),
    "LinoTiles": ((196, 196, 186), (178, 178, 170), (206, 204, 192), 4),
    "CeilingTiles": ((232, 232, 228), (200, 200, 196), None, 2),
    "RedPaving": ((168, 104, 84), (128, 84, 70), None, 6),
    "YellowTiles": ((228, 196, 92), (190, 164, 84), None, 4),
}
_FABRICS: dict[str, Rgb] = {
    "GreyCloth": (132, 134, 138),
    "BlueCloth": (62, 96, 150),
    "NavyCloth": (50, 64, 102),
    "TealCloth": (52, 128, 126),
    "RedCloth": (160, 48, 46),
    "GreenCloth": (78, 116, 74),
    "MustardCloth": (206, 158, 62),
    "OrangeCloth": (214, 122, 52),
    "Linen": (228, 222, 208),
    "Burlap": (178, 150, 108),
    "VioletCloth": (116, 84, 146),
    "PinkCloth": (220, 150, 164),
    "BlackCloth": (50, 50, 54),
    "BrownLeather": (116, 76, 50),
    "WhiteSail": (236, 232, 220),
}
_STRIPES: dict[str, tuple[Rgb, ...]] = {
    "RedStripes": ((196, 62, 52), (236, 230, 216)),
    "BlueStripes": ((62, 104, 160), (236, 232, 222)),
    "GreenStripes": ((78, 132, 88), (236, 232, 218)),
    "YellowStripes": ((226, 180, 70), (238, 232, 216)),
    "HazardStripes": ((228, 180, 40), (40, 40, 42)),
}
_PAINTS: dict[str, Rgb] = {
    "WhitePaint": (232, 230, 224),
    "CreamPaint": (230, 218, 188),
    "BlackPaint": (38, 38, 42),
    "GreyPaint": (136, 140, 144),
    "RedPaint": (178, 42, 36),
    "BluePaint": (44, 88, 156),
    "GreenPaint": (52, 112, 70),
    "YellowPaint": (232, 184, 48),
    "OrangePaint": (226, 116, 40),
    "TealPaint": (40, 130, 134),
    "SkyPaint": (120, 178, 214),
    "PinkPaint": (226, 142, 160),
    "VioletPaint": (120, 80, 156),
    "BrownPaint": (112, 76, 54),
    "LimePaint": (150, 190, 70),
    "NavyPaint": (34, 48, 88),
    "MaroonPaint": (108, 34, 40),
    "SilverPaint": (186, 190, 194),
    "WhitePlastic": (228, 228, 224),
    "GreyPlastic": (130, 134, 138),
    "BlackPlastic": (36, 36, 40),
    "Porcelain": (238, 238, 234),
    "Paper": (232, 228, 214),
    "Wax": (240, 228, 198),
    "Bread": (206, 150, 88),
    "Cheese": (236, 196, 96),
    "Tomato": (196, 54, 42),
    "Orange": (232, 138, 40),
    "Lemon": (238, 214, 76),
    "Apple": (150, 180, 62),
    "Plum": (104, 60, 104),
    "Skin": (222, 180, 150),
}
_METALS: dict[str, tuple[Rgb, float]] = {
    "Steel": ((186, 188, 192), 0.35),
    "Iron": ((72, 74, 78), 0.5),
    "Brass": ((200, 166, 92), 0.35),
    "Copper": ((190, 116, 84), 0.4),
    "Verdigris": ((106, 158, 140), 0.6),
    "Bronze": ((134, 100, 66), 0.45),
    "Gold": ((226, 188, 88), 0.3),
    "Aluminium": ((204, 206, 208), 0.45),
}
_GLOWS: dict[str, tuple[Rgb, tuple[float, float, float]]] = {
    "WarmGlow": ((255, 236, 200), (2.4, 1.9, 1.2)),
    "WhiteGlow": ((250, 252, 255), (2.2, 2.2, 2.2)),
    "Ember": ((250, 130, 50), (2.2, 0.8, 0.2)),
    "NeonPink": ((250, 90, 180), (1.8, 0.3, 1.0)),
    "NeonBlue": ((80, 180, 250), (0.3, 1.1, 1.9)),
    "NeonGreen": ((90, 240, 140), (0.3, 1.6, 0.6)),
    "RedGlow": ((240, 60, 50), (1.6, 0.2, 0.15)),
    "GreenGlow": ((70, 220, 110), (0.2, 1.5, 0.5)),
    "CrystalBlue": ((120, 200, 240), (0.25, 0.7, 1.0)),
    "CrystalViolet": ((180, 130, 230), (0.6, 0.3, 0.9)),
}


def _seed(name: str) -> int:
    return sum((i + 1) * ord(letter) for i, letter in enumerate(name)) % 9973


def _plain() -> dict[str, MaterialSpec]:
    found = [
        *(MaterialSpec(n, linear(c), 0.5) for n, c in _PAINTS.items()),
        *(MaterialSpec(n, linear(c), rough, 0.85) for n, (c, rough) in _METALS.items()),
        *(MaterialSpec(n, linear(c), 0.6, emissive=light) for n, (c, light) in _GLOWS.items()),
        MaterialSpec("Glass", (0.55, 0.70, 0.76), 0.08, opacity=0.35),
        MaterialSpec("WindowGlass", linear((96, 122, 140)), 0.12),
        MaterialSpec("AmberWindow", linear((238, 196, 120)), 0.3, emissive=(0.55, 0.36, 0.12)),
        MaterialSpec("Mirror", (0.62, 0.70, 0.74), 0.03, 0.8),
        MaterialSpec("GreenBottle", (0.05, 0.18, 0.08), 0.1),
        MaterialSpec("BrownBottle", (0.16, 0.07, 0.03), 0.1),
    ]
    return {material.name: material for material in found}


def _textured() -> dict[str, tuple[Texture, float, float]]:
    """Texture, metres of a repeat, roughness."""
    found: dict[str, tuple[Texture, float, float]] = {}
    for name, color in _WOODS.items():
        found[name] = (wood(color, _seed(name)), 1.0, 0.6)
    for name, color in _PLANKS.items():
        found[name] = (planks(color, _seed(name)), 1.2, 0.75)
    for name, color in _PLASTERS.items():
        found[name] = (mottled(color, _seed(name), strength=0.05), 3.0, 0.9)
    for name, (color, mortar) in _BRICKS.items():
        found[name] = (bricks(color, mortar, _seed(name)), 1.2, 0.9)
    for name, (color, mortar) in _STONES.items():
        found[name] = (bricks(color, mortar, _seed(name), rows=4, columns=2), 1.6, 0.9)
    for name, (color, mortar) in _ROOFS.items():
        found[name] = (bricks(color, mortar, _seed(name), rows=8, columns=8), 2.0, 0.85)
    for name, (color, strength, fine) in _MOTTLED.items():
        found[name] = (mottled(color, _seed(name), strength=strength, fine=fine, cells=10), 1.6, 0.9)
    for name, (color, joint, second, count) in _TILES.items():
        found[name] = (tiles(color, joint, _seed(name), count=count, variation=0.08, second=second), 1.6, 0.7)
    for name, color in _FABRICS.items():
        found[name] = (fabric(color, _seed(name)), 0.25, 0.9)
    for name, colors in _STRIPES.items():
        found[name] = (stripes(colors, _seed(name), upright=True), 0.6, 0.85)
    found["Water"] = (mottled((62, 104, 120), 22, strength=0.12, cells=6), 8.0, 0.12)
    found["Furrows"] = (stripes([(104, 80, 58), (72, 54, 40), (92, 70, 50)], 23), 0.9, 0.95)
    found["LawnStripes"] = (stripes([(104, 140, 62), (120, 154, 72)], 24, upright=True), 8.0, 0.95)
    found["Landscape"] = (painting(31), 1.0, 0.7)
    found["Sunset"] = (painting(32, sky=(226, 160, 120), hills=((120, 76, 96), (70, 52, 84))), 1.0, 0.7)
    found["Seascape"] = (painting(33, sky=(190, 214, 228), hills=((70, 120, 150), (46, 84, 116))), 1.0, 0.7)
    found["RedRug"] = (carpet((140, 40, 42), (52, 50, 84), (214, 180, 120), 71), 1.0, 0.95)
    found["BlueRug"] = (carpet((78, 108, 148), (226, 220, 204), (196, 204, 214), 72), 1.0, 0.95)
    found["GreenRug"] = (carpet((88, 118, 84), (60, 64, 50), (216, 200, 150), 73), 1.0, 0.95)
    return found


@functools.cache
def library() -> dict[str, MaterialSpec]:
    """Every material of the kits by name."""
    made = _plain()
    for name, (texture, tile_m, roughness) in _textured().items():
        made[name] = MaterialSpec(name, texture=texture, tile_m=tile_m, roughness=roughness)
    made["Screen"] = MaterialSpec("Screen", texture=screen(48), emissive=(0.10, 0.12, 0.16))
    made["TimetableScreen"] = MaterialSpec(
        "TimetableScreen",
        texture=screen(49, background=(18, 22, 30), bars=((236, 190, 70), (220, 224, 226))),
        emissive=(0.12, 0.11, 0.08),
    )
    return made
