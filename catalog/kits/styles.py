"""Styles: which materials play which role. A place may bend a style (``but``) to its own colours."""

from __future__ import annotations

from dataclasses import dataclass, replace

Names = tuple[str, ...]


@dataclass(frozen=True)
class Style:
    """Roles of materials, and what proportions and ornaments follow. Every role lists materials to choose from."""

    name: str
    wall: Names
    roof: Names
    wood: Names
    stone: Names
    metal: Names
    trim: Names
    door: Names
    cloth: Names
    paint: Names
    awning: Names
    leaf: Names
    bark: Names
    window: Names
    glow: Names
    steep: float = 1.0
    """Height of roofs and spires to a usual one."""
    ornate: bool = False
    """Whether things carry ornaments (finials, mouldings)."""
    old: bool = False
    """Whether things are of a time without engines and electricity."""

    def but(self, **roles: object) -> Style:
        """This style with other materials in some roles."""
        return replace(self, **roles)  # type: ignore[arg-type]


HISTORICAL = Style(
    "historical",
    wall=("WhitePlaster", "CreamPlaster", "OchrePlaster", "Fieldstone", "RedBrick", "PinkPlaster"),
    roof=("RedTile", "BrownTile", "SlateTile", "Thatch"),
    wood=("Oak", "DarkOak", "Walnut"),
    stone=("Fieldstone", "Limestone", "Granite"),
    metal=("Iron", "Bronze"),
    trim=("DarkOak", "Oak"),
    door=("DarkPlanks", "Planks", "GreenPaint", "MaroonPaint"),
    cloth=("RedCloth", "Linen", "GreenCloth", "Burlap", "BrownLeather"),
    paint=("MaroonPaint", "GreenPaint", "BrownPaint", "NavyPaint"),
    awning=("RedStripes", "GreenStripes", "Linen", "YellowStripes"),
    leaf=("Leaf", "DarkLeaf", "PaleLeaf"),
    bark=("Bark",),
    window=("WindowGlass", "AmberWindow"),
    glow=("WarmGlow",),
    steep=1.15,
    ornate=True,
    old=True,
)
FANTASY = Style(
    "fantasy",
    wall=("WhitePlaster", "VioletPlaster", "TealPlaster", "MossyStone", "Clay", "Sandstone"),
    roof=("VioletTile", "BlueTile", "GreenTile", "OrangeTile", "Thatch"),
    wood=("DarkOak", "Oak", "Cherry"),
    stone=("MossyStone", "DarkStone", "Limestone"),
    metal=("Gold", "Verdigris", "Iron"),
    trim=("DarkOak", "Gold"),
    door=("VioletPaint", "TealPaint", "DarkPlanks", "RedPaint"),
    cloth=("VioletCloth", "TealCloth", "RedCloth", "MustardCloth"),
    paint=("VioletPaint", "TealPaint", "RedPaint", "YellowPaint"),
    awning=("YellowStripes", "BlueStripes", "VioletCloth", "RedStripes"),
    leaf=("VioletLeaf", "Leaf", "Blossom", "GoldenLeaf"),
    bark=("Bark", "PaleBark"),
    window=("AmberWindow",),
    glow=("CrystalBlue", "CrystalViolet", "WarmGlow"),
    steep=1.6,
    ornate=True,
    old=True,
)
URBAN = Style(
    "urban",
    wall=("RedBrick", "YellowBrick", "GreyPlaster", "CreamPlaster", "WhiteBrick", "Concrete"),
    roof=("SlateTile", "RedTile", "DarkConcrete"),
    wood=("Oak", "Walnut", "Pine"),
    stone=("Granite", "Limestone", "Concrete"),
    metal=("Steel", "Iron", "Aluminium"),
    trim=("WhitePaint", "GreyPaint", "CreamPaint"),
    door=("GreenPaint", "NavyPaint", "RedPaint", "BlackPaint", "TealPaint"),
    cloth=("GreyCloth", "BlueCloth", "RedCloth", "MustardCloth"),
    paint=("RedPaint", "BluePaint", "WhitePaint", "SilverPaint", "BlackPaint", "TealPaint", "YellowPaint"),
    awning=("RedStripes", "BlueStripes", "GreenStripes", "OrangeCloth"),
    leaf=("Leaf", "PaleLeaf", "DarkLeaf"),
    bark=("Bark",),
    window=("WindowGlass",),
    glow=("WarmGlow", "WhiteGlow"),
)
TRANSIT = URBAN.but(
    name="transit",
    wall=("WhiteTiles", "BlueTiles", "Concrete", "GreyPlaster"),
    roof=("DarkConcrete", "SlateTile"),
    metal=("Steel", "Aluminium"),
    trim=("BluePaint", "GreyPaint", "YellowPaint"),
    door=("SilverPaint", "BluePaint"),
    cloth=("BlueCloth", "GreyCloth", "TealCloth"),
    paint=("BluePaint", "YellowPaint", "WhitePaint", "RedPaint", "SilverPaint"),
    glow=("WhiteGlow",),
)
INDUSTRIAL = URBAN.but(
    name="industrial",
    wall=("RedBrick", "DarkBrick", "Concrete", "GreyPaint"),
    roof=("DarkConcrete", "Rust", "SlateTile"),
    wood=("Pine", "GreyWood", "Oak"),
    stone=("Concrete", "DarkConcrete"),
    metal=("Iron", "Steel", "Rust"),
    trim=("YellowPaint", "GreyPaint", "Iron"),
    door=("BluePaint", "Rust", "GreenPaint"),
    cloth=("BlueCloth", "OrangeCloth", "BlackCloth"),
    paint=("YellowPaint", "OrangePaint", "BluePaint", "GreenPaint", "RedPaint", "GreyPaint"),
    awning=("HazardStripes", "BlueCloth"),
    glow=("WhiteGlow", "RedGlow"),
)
DOMESTIC = URBAN.but(
    name="domestic",
    wall=("WhiteBoards", "BlueBoards", "CreamPlaster", "RedBrick", "GreenBoards", "YellowBrick"),
    roof=("BrownTile", "SlateTile", "RedTile"),
    wood=("Oak", "Birch", "Walnut", "Pine"),
    metal=("Iron", "Brass", "Steel"),
    trim=("WhitePaint", "CreamPaint"),
    cloth=("GreyCloth", "MustardCloth", "TealCloth", "Linen", "PinkCloth", "NavyCloth"),
    glow=("WarmGlow",),
)
OFFICE = URBAN.but(
    name="office",
    wall=("WhitePlaster", "GreyPlaster", "WhiteBrick", "Concrete"),
    roof=("DarkConcrete",),
    wood=("Birch", "Oak", "Walnut"),
    metal=("Steel", "Aluminium", "Iron"),
    trim=("GreyPaint", "WhitePaint"),
    cloth=("GreyCloth", "BlueCloth", "TealCloth", "OrangeCloth", "BlackCloth"),
    paint=("WhitePaint", "GreyPaint", "TealPaint", "BluePaint"),
    glow=("WhiteGlow",),
)
STYLISED = FANTASY.but(
    name="stylised",
    wall=("PinkPlaster", "BluePlaster", "WhitePlaster", "GreenPlaster", "OchrePlaster"),
    roof=("OrangeTile", "BlueTile", "RedTile", "VioletTile"),
    wood=("Pine", "Birch", "Cherry"),
    stone=("Limestone", "Granite"),
    metal=("Gold", "Steel"),
    trim=("WhitePaint", "YellowPaint", "PinkPaint"),
    door=("RedPaint", "SkyPaint", "YellowPaint", "LimePaint"),
    cloth=("PinkCloth", "MustardCloth", "TealCloth", "RedCloth"),
    paint=("RedPaint", "SkyPaint", "YellowPaint", "PinkPaint", "LimePaint", "OrangePaint"),
    awning=("RedStripes", "BlueStripes", "YellowStripes", "GreenStripes"),
    leaf=("Leaf", "Blossom", "PaleLeaf"),
    window=("WindowGlass",),
    glow=("WarmGlow", "NeonPink", "NeonBlue"),
    steep=1.3,
    old=False,
)
