"""The pack ``c4s-farm``: a small mixed farm with its fields, buildings, machines and animals.

Everything stands on its pivot (the centre of its base). Ground tiles have the pivot in their upper face. Fronts look
to +Y, vehicles and animals to +X.
"""

from __future__ import annotations

from catalog.shapes import MaterialSpec, PackSpec
from catalog.shapes.textures import bricks, mottled, planks, stripes, tiles
from catalog.starter import farm_buildings, farm_land, farm_yard


def _materials() -> list[MaterialSpec]:
    return [
        MaterialSpec("Grass", texture=mottled((104, 138, 66), 1, strength=0.12, fine=0.12, cells=8), tile_m=4.0),
        MaterialSpec("Soil", texture=stripes([(104, 76, 52), (82, 60, 42)] * 5, 2), tile_m=4.0),
        MaterialSpec("Earth", texture=mottled((122, 94, 66), 3, strength=0.14, fine=0.08), tile_m=2.0),
        MaterialSpec("Gravel", texture=mottled((164, 150, 126), 4, strength=0.08, fine=0.16, cells=16), tile_m=2.0),
        MaterialSpec("Flagstone", texture=tiles((158, 150, 136), (112, 106, 94), 5, variation=0.1), tile_m=2.0),
        MaterialSpec("BarnRed", texture=planks((142, 46, 38), 6, rows=8), tile_m=1.6),
        MaterialSpec("PlankGrey", texture=planks((136, 126, 112), 7), tile_m=1.2),
        MaterialSpec("Wood", texture=planks((150, 112, 74), 8), tile_m=1.0),
        MaterialSpec("Stone", texture=bricks((158, 150, 138), (118, 112, 102), 9, rows=6, columns=4), tile_m=1.4),
        MaterialSpec("Brick", texture=bricks((156, 84, 62), (180, 168, 152), 10), tile_m=1.2),
        MaterialSpec("Plaster", texture=mottled((226, 218, 196), 11, strength=0.04), tile_m=3.0),
        MaterialSpec("RoofTile", texture=bricks((158, 78, 54), (108, 52, 38), 12, rows=8, columns=8), tile_m=2.0),
        MaterialSpec(
            "RoofTin",
            texture=stripes([(122, 128, 132), (104, 110, 114)] * 6, 13, upright=True),
            roughness=0.5,
            tile_m=2.0,
        ),
        MaterialSpec("Thatch", texture=mottled((176, 146, 92), 14, strength=0.12, fine=0.18, cells=20), tile_m=1.5),
        MaterialSpec("Hay", texture=mottled((206, 172, 92), 15, strength=0.12, fine=0.2, cells=16), tile_m=1.0),
        MaterialSpec("Leaves", texture=mottled((82, 120, 54), 16, strength=0.22, fine=0.16, cells=12), tile_m=1.5),
        MaterialSpec("LeavesLight", texture=mottled((126, 152, 70), 17, strength=0.2, fine=0.16, cells=12), tile_m=1.5),
        MaterialSpec("Crop", texture=mottled((112, 150, 52), 18, strength=0.25, fine=0.2, cells=16), tile_m=1.0),
        MaterialSpec("Wheat", texture=mottled((208, 176, 84), 19, strength=0.15, fine=0.2, cells=20), tile_m=1.0),
        MaterialSpec("Bark", texture=mottled((98, 80, 62), 20, strength=0.15), tile_m=1.0),
        MaterialSpec("Rock", texture=mottled((140, 136, 128), 21, strength=0.14, fine=0.06), tile_m=1.5),
        MaterialSpec("Water", roughness=0.15, texture=mottled((76, 112, 122), 22, strength=0.1, cells=6), tile_m=6.0),
        MaterialSpec("Wool", texture=mottled((226, 220, 204), 23, strength=0.1, fine=0.1, cells=16), tile_m=0.5),
        MaterialSpec("Hide", texture=mottled((222, 218, 208), 24, strength=0.03), tile_m=1.0),
        MaterialSpec("HideDark", (0.03, 0.028, 0.026)),
        MaterialSpec("HideBrown", (0.20, 0.09, 0.04)),
        MaterialSpec("PigPink", (0.72, 0.38, 0.33)),
        MaterialSpec("FeatherWhite", (0.80, 0.78, 0.72)),
        MaterialSpec("CombRed", (0.55, 0.03, 0.03)),
        MaterialSpec("Beak", (0.75, 0.42, 0.05)),
        MaterialSpec("WhitePaint", (0.82, 0.81, 0.77), roughness=0.6),
        MaterialSpec("DoorGreen", (0.06, 0.18, 0.09), roughness=0.5),
        MaterialSpec("TractorRed", (0.50, 0.03, 0.02), roughness=0.35),
        MaterialSpec("TractorGreen", (0.03, 0.22, 0.06), roughness=0.35),
        MaterialSpec("HubYellow", (0.80, 0.55, 0.04), roughness=0.4),
        MaterialSpec("Glass", (0.06, 0.09, 0.12), roughness=0.1, metallic=0.2),
        MaterialSpec("Iron", (0.04, 0.04, 0.045), roughness=0.5, metallic=0.6),
        MaterialSpec("Steel", (0.52, 0.53, 0.55), roughness=0.4, metallic=0.8),
        MaterialSpec("Rubber", (0.02, 0.02, 0.02), roughness=0.9),
        MaterialSpec("Pumpkin", (0.75, 0.24, 0.02)),
        MaterialSpec("Cloth", (0.10, 0.16, 0.38)),
    ]


def pack() -> PackSpec:
    """The specification of the pack."""
    kits = (farm_land.KIT, farm_buildings.KIT, farm_yard.KIT)
    return PackSpec(
        "c4s-farm",
        "C4SFarm",
        "Small farm",
        "Ground, crops, buildings, machines, animals and tools of a small farm.",
        _materials(),
        [asset for kit in kits for asset in kit.assets],
        category_descriptions={
            "ground": "Flat tiles whose top is at the pivot: grass, ploughed soil, gravel, flagstones, pond.",
            "plants": "Trees, bushes and rows of crops.",
            "buildings": "Barn, farmhouse, silo, windmill, coop, shed.",
            "yard": "Fences, gates, hay, troughs and tools.",
            "vehicles": "Tractors, cart and plough.",
            "animals": "Cows, sheep, pigs, horses and hens.",
            "rocks": "Boulders and stones.",
        },
    )
