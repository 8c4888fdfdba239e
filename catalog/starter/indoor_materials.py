"""Materials of the two indoor packs. Plain colours are linear RGB; textures are sRGB."""

from __future__ import annotations

from catalog.shapes import MaterialSpec
from catalog.shapes.textures import bricks, carpet, fabric, mottled, painting, planks, screen, stripes, tiles, wood

SHARED = [
    MaterialSpec("OakWood", texture=wood((186, 148, 104), 11), roughness=0.6),
    MaterialSpec("WalnutWood", texture=wood((104, 70, 46), 12), roughness=0.55),
    MaterialSpec("WhiteLaminate", (0.80, 0.80, 0.78), 0.45),
    MaterialSpec("GreyLaminate", (0.32, 0.34, 0.36), 0.5),
    MaterialSpec("BlackPlastic", (0.018, 0.018, 0.02), 0.5),
    MaterialSpec("GreyPlastic", (0.22, 0.23, 0.24), 0.55),
    MaterialSpec("WhitePlastic", (0.78, 0.78, 0.76), 0.4),
    MaterialSpec("Steel", (0.55, 0.56, 0.58), 0.3, 0.9),
    MaterialSpec("DarkMetal", (0.06, 0.065, 0.07), 0.45, 0.7),
    MaterialSpec("Brass", (0.62, 0.44, 0.16), 0.35, 0.9),
    MaterialSpec("Glass", (0.62, 0.76, 0.80), 0.08, opacity=0.35),
    MaterialSpec("Ceramic", (0.84, 0.84, 0.82), 0.15),
    MaterialSpec("Terracotta", texture=mottled((176, 98, 66), 21)),
    MaterialSpec("Soil", texture=mottled((58, 42, 30), 22, strength=0.2, fine=0.15)),
    MaterialSpec("Leaf", texture=mottled((62, 112, 52), 23, strength=0.22), tile_m=0.3),
    MaterialSpec("LeafLight", texture=mottled((108, 150, 74), 24, strength=0.18), tile_m=0.3),
    MaterialSpec("Bark", texture=wood((92, 68, 48), 25, strength=0.25), tile_m=0.3),
    MaterialSpec("Plaster", texture=mottled((226, 222, 212), 26, strength=0.02, fine=0.012), tile_m=2.0),
    MaterialSpec("SkirtingWhite", (0.74, 0.74, 0.72), 0.5),
    MaterialSpec("LampShade", (0.82, 0.72, 0.52), 0.9, emissive=(0.55, 0.42, 0.22)),
    MaterialSpec("Bulb", (1.0, 0.95, 0.85), 0.5, emissive=(3.0, 2.7, 2.2)),
    MaterialSpec("Paper", (0.80, 0.79, 0.74), 0.95),
    MaterialSpec("BookRed", (0.36, 0.05, 0.04), 0.8),
    MaterialSpec("BookBlue", (0.05, 0.12, 0.32), 0.8),
    MaterialSpec("BookGreen", (0.06, 0.22, 0.10), 0.8),
    MaterialSpec("BookOchre", (0.50, 0.32, 0.08), 0.8),
    MaterialSpec("Painting", texture=painting(31)),
    MaterialSpec("PaintingDusk", texture=painting(32, sky=(226, 160, 120), hills=((120, 76, 96), (70, 52, 84)))),
]

OFFICE = [
    *SHARED,
    MaterialSpec("CarpetTile", texture=tiles((104, 112, 122), (92, 99, 108), 41, count=4, variation=0.05), tile_m=2.0),
    MaterialSpec("OfficePlanks", texture=planks((176, 140, 98), 42), tile_m=1.2),
    MaterialSpec("MeshFabric", texture=fabric((52, 56, 62), 43), tile_m=0.25),
    MaterialSpec("BlueFabric", texture=fabric((62, 96, 150), 44), tile_m=0.25),
    MaterialSpec("TealFabric", texture=fabric((52, 128, 126), 45), tile_m=0.25),
    MaterialSpec("OrangeFabric", texture=fabric((214, 122, 52), 46), tile_m=0.25),
    MaterialSpec("PartitionFelt", texture=mottled((132, 140, 146), 47, fine=0.08), tile_m=0.5),
    MaterialSpec("ScreenCode", texture=screen(48), emissive=(0.10, 0.12, 0.16)),
    MaterialSpec(
        "ScreenSheet",
        texture=screen(49, background=(222, 226, 230), bars=((70, 130, 90), (120, 130, 145))),
        emissive=(0.12, 0.12, 0.12),
    ),
    MaterialSpec("Whiteboard", (0.88, 0.89, 0.90), 0.2),
    MaterialSpec("Cork", texture=mottled((186, 142, 96), 50, strength=0.12, fine=0.12), tile_m=0.5),
    MaterialSpec("BrickWall", texture=bricks((164, 84, 62), (190, 182, 170), 51), tile_m=0.6),
    MaterialSpec(
        "CeilingTile", texture=tiles((232, 232, 228), (200, 200, 196), 52, count=2, variation=0.01), tile_m=1.2
    ),
    MaterialSpec("LightPanel", (1.0, 1.0, 1.0), 0.5, emissive=(2.2, 2.2, 2.1)),
    MaterialSpec("WaterBlue", (0.20, 0.45, 0.70), 0.1, opacity=0.5),
    MaterialSpec("RecycleBlue", (0.03, 0.16, 0.42), 0.6),
    MaterialSpec("AccentRed", (0.50, 0.04, 0.03), 0.5),
    MaterialSpec("AccentGreen", (0.10, 0.42, 0.14), 0.6),
    MaterialSpec("RugStripes", texture=stripes([(70, 84, 110), (180, 176, 164), (108, 122, 148)], 53), tile_m=0.6),
]

HOME = [
    *SHARED,
    MaterialSpec("Parquet", texture=planks((168, 122, 78), 61), tile_m=1.2),
    MaterialSpec("BathTiles", texture=tiles((214, 224, 226), (170, 180, 182), 62, count=4), tile_m=1.2),
    MaterialSpec(
        "ChessTiles", texture=tiles((224, 222, 214), (150, 148, 142), 63, count=4, second=(92, 98, 104)), tile_m=1.2
    ),
    MaterialSpec("WallGreen", texture=mottled((168, 184, 164), 64, strength=0.02, fine=0.012), tile_m=2.0),
    MaterialSpec("GreyFabric", texture=fabric((132, 134, 138), 65), tile_m=0.25),
    MaterialSpec("MustardFabric", texture=fabric((206, 158, 62), 66), tile_m=0.25),
    MaterialSpec("NavyFabric", texture=fabric((52, 66, 104), 67), tile_m=0.25),
    MaterialSpec("Linen", texture=fabric((228, 222, 208), 68), tile_m=0.25),
    MaterialSpec(
        "Duvet", texture=stripes([(206, 214, 226), (206, 214, 226), (120, 142, 178), (206, 214, 226)], 69), tile_m=0.5
    ),
    MaterialSpec("CurtainFabric", texture=stripes([(196, 120, 96), (208, 136, 110)], 70, upright=True), tile_m=0.2),
    MaterialSpec("PersianRug", texture=carpet((140, 40, 42), (52, 50, 84), (214, 180, 120), 71)),
    MaterialSpec("BlueRug", texture=carpet((78, 108, 148), (226, 220, 204), (196, 204, 214), 72)),
    MaterialSpec("Worktop", texture=mottled((88, 86, 84), 73, strength=0.15, fine=0.12), tile_m=0.5, roughness=0.3),
    MaterialSpec("CabinetSage", (0.34, 0.44, 0.36), 0.5),
    MaterialSpec("BathLiquid", (0.35, 0.60, 0.72), 0.05, opacity=0.6),
    MaterialSpec("MirrorGlass", (0.62, 0.70, 0.74), 0.03, 0.8),
    MaterialSpec(
        "TvScreen",
        texture=painting(74, sky=(70, 130, 200), hills=((40, 90, 60), (24, 54, 40))),
        emissive=(0.08, 0.1, 0.12),
    ),
    MaterialSpec("GlobeSea", texture=mottled((46, 96, 150), 75, strength=0.45, fine=0.02, cells=5)),
    MaterialSpec("ToyRed", (0.56, 0.05, 0.04), 0.5),
    MaterialSpec("ToyYellow", (0.72, 0.50, 0.04), 0.5),
    MaterialSpec("ToyBlue", (0.04, 0.18, 0.55), 0.5),
    MaterialSpec("TeddyFur", texture=mottled((150, 104, 62), 76, fine=0.2), tile_m=0.3),
    MaterialSpec("FruitOrange", (0.70, 0.25, 0.03), 0.6),
    MaterialSpec("FruitGreen", (0.28, 0.45, 0.05), 0.6),
    MaterialSpec("VaseBlue", (0.05, 0.16, 0.34), 0.2),
    MaterialSpec("FlowerPink", (0.65, 0.16, 0.26), 0.8),
]
