"""The three settings of the benchmark: the only place that spells their names (paper, "Task settings")."""

from __future__ import annotations

from typing import Final, Literal, TypeAlias

Setting: TypeAlias = Literal["text-to-scene", "image-to-scene/indoor", "image-to-scene/outdoor"]

TEXT_TO_SCENE: Final = "text-to-scene"
INDOOR_REPAIR: Final = "image-to-scene/indoor"
OUTDOOR_REPAIR: Final = "image-to-scene/outdoor"
SETTINGS: Final[tuple[Setting, ...]] = (TEXT_TO_SCENE, INDOOR_REPAIR, OUTDOOR_REPAIR)

SETTING_TITLES: Final[dict[Setting, str]] = {
    TEXT_TO_SCENE: "Text to scene",
    INDOOR_REPAIR: "Image to scene, indoor",
    OUTDOOR_REPAIR: "Image to scene, outdoor",
}
"""As pages and tables show them."""


def is_construction(setting: Setting) -> bool:
    """Whether the agent builds a scene from a text; otherwise it repairs one that is given."""
    return setting == TEXT_TO_SCENE


def repair_setting(indoor: bool) -> Setting:
    """The setting of a repair in such a place."""
    return INDOOR_REPAIR if indoor else OUTDOOR_REPAIR


SETTING_ALIASES: Final[dict[str, Setting]] = {
    TEXT_TO_SCENE: TEXT_TO_SCENE,
    "t2s": TEXT_TO_SCENE,
    INDOOR_REPAIR: INDOOR_REPAIR,
    "indoor": INDOOR_REPAIR,
    "i2s-indoor": INDOOR_REPAIR,
    "image-to-scene-indoor": INDOOR_REPAIR,
    OUTDOOR_REPAIR: OUTDOOR_REPAIR,
    "outdoor": OUTDOOR_REPAIR,
    "i2s-outdoor": OUTDOOR_REPAIR,
    "image-to-scene-outdoor": OUTDOOR_REPAIR,
}
"""Published names and short forms of the settings."""
