"""The pack ``c4s-harbour``: a northern harbour street, its quays, houses, working gear and boats.

Everything stands on its pivot (the centre of its base). Ground, quay and water pieces have the pivot in their upper
face, so a piece at z = 0 has its walkable top there. Fronts look to +Y.
"""

from __future__ import annotations

from catalog.shapes import MaterialSpec, PackSpec
from catalog.shapes.textures import bricks, mottled, planks, stripes, tiles
from catalog.starter import harbour_buildings, harbour_ground, harbour_street, harbour_water


def _materials() -> list[MaterialSpec]:
    plaster = {
        "PlasterRed": (168, 74, 60),
        "PlasterOchre": (214, 168, 84),
        "PlasterBlue": (112, 142, 166),
        "PlasterCream": (226, 214, 186),
        "PlasterGreen": (128, 152, 122),
    }
    paint = {
        "WhitePaint": (0.82, 0.81, 0.77),
        "DoorGreen": (0.05, 0.16, 0.10),
        "DoorBlue": (0.05, 0.10, 0.22),
        "DoorRed": (0.32, 0.04, 0.03),
        "CraneYellow": (0.75, 0.45, 0.04),
        "ContainerBlue": (0.04, 0.14, 0.32),
        "ContainerRust": (0.36, 0.10, 0.05),
        "CarRed": (0.45, 0.03, 0.03),
        "CarTeal": (0.03, 0.22, 0.25),
        "VanWhite": (0.75, 0.75, 0.73),
        "BoatBlue": (0.05, 0.15, 0.38),
        "BoatRed": (0.42, 0.05, 0.04),
        "BuoyOrange": (0.80, 0.20, 0.02),
        "SignBlue": (0.02, 0.12, 0.45),
        "SignRed": (0.60, 0.03, 0.03),
        "FruitRed": (0.55, 0.05, 0.03),
        "FruitYellow": (0.75, 0.50, 0.05),
        "FruitGreen": (0.16, 0.36, 0.05),
    }
    return [
        *(
            MaterialSpec(name, texture=mottled(color, 10 + i, strength=0.05), tile_m=3.0)
            for i, (name, color) in enumerate(plaster.items())
        ),
        *(MaterialSpec(name, color, roughness=0.5) for name, color in paint.items()),
        MaterialSpec("BrickRed", texture=bricks((150, 78, 58), (176, 164, 150), 1), tile_m=1.2),
        MaterialSpec("BrickDark", texture=bricks((104, 70, 60), (140, 130, 120), 2), tile_m=1.2),
        MaterialSpec("RoofTile", texture=bricks((170, 82, 52), (112, 52, 36), 3, rows=8, columns=8), tile_m=2.0),
        MaterialSpec("RoofSlate", texture=bricks((82, 86, 94), (56, 58, 64), 4, rows=8, columns=8), tile_m=2.0),
        MaterialSpec("Stone", texture=bricks((168, 164, 154), (120, 116, 108), 5, rows=4, columns=2), tile_m=1.6),
        MaterialSpec("StoneDark", texture=bricks((118, 116, 110), (82, 80, 76), 6, rows=4, columns=2), tile_m=1.6),
        MaterialSpec("Cobble", texture=tiles((128, 124, 118), (84, 80, 74), 7, count=8, variation=0.14), tile_m=1.0),
        MaterialSpec("Paving", texture=tiles((172, 166, 154), (140, 134, 124), 8, count=4, variation=0.06), tile_m=2.0),
        MaterialSpec("Asphalt", texture=mottled((78, 78, 80), 9, strength=0.05, fine=0.08, cells=16), tile_m=2.0),
        MaterialSpec("Wood", texture=planks((156, 118, 78), 20), tile_m=1.2),
        MaterialSpec("WoodDark", texture=planks((98, 74, 54), 21), tile_m=1.2),
        MaterialSpec("Water", roughness=0.15, texture=mottled((52, 92, 108), 22, strength=0.12, cells=6), tile_m=8.0),
        MaterialSpec("Leaves", texture=mottled((84, 122, 52), 23, strength=0.22, fine=0.16, cells=12), tile_m=1.5),
        MaterialSpec("Bark", texture=mottled((98, 80, 62), 24, strength=0.15), tile_m=1.0),
        MaterialSpec("Soil", texture=mottled((86, 66, 48), 25, strength=0.12), tile_m=1.0),
        MaterialSpec("Canvas", texture=stripes([(200, 60, 50), (238, 230, 212)] * 4, 26, upright=True), tile_m=2.0),
        MaterialSpec("CanvasBlue", texture=stripes([(60, 92, 150), (238, 230, 212)] * 4, 27, upright=True), tile_m=2.0),
        MaterialSpec("Net", texture=tiles((70, 110, 96), (38, 60, 54), 28, count=16), tile_m=0.8),
        MaterialSpec("Rope", texture=mottled((176, 148, 104), 29, strength=0.15, cells=24), tile_m=0.5),
        MaterialSpec("Glass", (0.06, 0.09, 0.12), roughness=0.1, metallic=0.2),
        MaterialSpec("Iron", (0.03, 0.03, 0.035), roughness=0.5, metallic=0.6),
        MaterialSpec("Steel", (0.45, 0.46, 0.48), roughness=0.4, metallic=0.8),
        MaterialSpec("Rubber", (0.02, 0.02, 0.02), roughness=0.9),
        MaterialSpec("LampGlow", (1.0, 0.85, 0.55), emissive=(1.2, 0.9, 0.5)),
    ]


def pack() -> PackSpec:
    """The specification of the pack."""
    kits = (harbour_ground.KIT, harbour_buildings.KIT, harbour_street.KIT, harbour_water.KIT)
    return PackSpec(
        "c4s-harbour",
        "C4SHarbour",
        "Harbour street",
        "Ground, quays, houses, street furniture, working gear and boats of a northern harbour.",
        _materials(),
        [asset for kit in kits for asset in kit.assets],
        category_descriptions={
            "ground": "Flat tiles whose top is at the pivot: cobbles, paving, road, planks, water.",
            "waterfront": "Quay walls, bridges, jetties, railings.",
            "buildings": "Townhouses, warehouse, lighthouse, kiosk.",
            "street": "Street furniture: lamps, benches, signs, bollards, planters, trees.",
            "market": "Market stalls, awnings and goods.",
            "cargo": "Crates, barrels, containers and the crane.",
            "vehicles": "Cars, vans and bicycles.",
            "boats": "Boats, buoys, nets and other gear of the water.",
        },
    )
