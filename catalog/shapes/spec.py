"""What a pack is built from: materials, parametric assets and compositions of them."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from c4s.records.level import Vector
from catalog.shapes.builder import Builder
from catalog.shapes.textures import Texture

Colour = tuple[float, float, float]


@dataclass(frozen=True)
class MaterialSpec:
    """A material ``M_<name>``. Colours are linear RGB; a texture multiplies the colour and repeats every ``tile_m``
    metres (parts with fitted coordinates show it once)."""

    name: str
    color: Colour = (1.0, 1.0, 1.0)
    roughness: float = 0.8
    metallic: float = 0.0
    emissive: Colour = (0.0, 0.0, 0.0)
    opacity: float = 1.0
    texture: Texture | None = None
    tile_m: float = 1.0


@dataclass(frozen=True)
class AssetSpec:
    """A static mesh ``SM_<name>`` in the folder of its category; ``build`` adds its parts to a builder."""

    name: str
    category: str
    description: str
    tags: tuple[str, ...]
    build: Callable[[Builder], None]


@dataclass(frozen=True)
class BlueprintPartSpec:
    """A component of a composition: ``asset`` is the name of an asset of the pack, placed in cm and degrees."""

    asset: str
    location_cm: Vector = (0.0, 0.0, 0.0)
    yaw_deg: float = 0.0
    scale: Vector = (1.0, 1.0, 1.0)


@dataclass(frozen=True)
class BlueprintSpec:
    """A composition ``BP_<name>`` of assets of the pack."""

    name: str
    category: str
    description: str
    tags: tuple[str, ...]
    parts: tuple[BlueprintPartSpec, ...]


@dataclass(frozen=True)
class PackSpec:
    """A pack before it is built."""

    pack_id: str
    content_folder: str
    title: str
    description: str
    materials: Sequence[MaterialSpec]
    assets: Sequence[AssetSpec]
    blueprints: Sequence[BlueprintSpec] = ()
    category_descriptions: dict[str, str] = field(default_factory=dict)
    license: str = "Apache-2.0"


class Kit:
    """A list of assets, filled by decorating the functions that build them."""

    def __init__(self) -> None:
        self.assets: list[AssetSpec] = []

    def asset(
        self, name: str, category: str, description: str, tags: str = ""
    ) -> Callable[[Callable[[Builder], None]], Callable[[Builder], None]]:
        """Register a builder function as asset ``SM_<name>``; ``tags`` are words in one string."""

        def register(build: Callable[[Builder], None]) -> Callable[[Builder], None]:
            self.assets.append(AssetSpec(name, category, description, tuple(tags.split()), build))
            return build

        return register


def readable(name: str) -> str:
    """``OfficeDesk120`` as ``Office Desk120``: a blank before every capital that follows a small letter or digit."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", " ", name.replace("_", " "))


def asset_id(name: str) -> str:
    """``OfficeDesk`` as ``office_desk``."""
    return readable(name).lower().replace(" ", "_")
