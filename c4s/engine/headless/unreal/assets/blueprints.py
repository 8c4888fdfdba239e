"""Blueprints."""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.unreal.assets.base import AssetObject
from c4s.engine.headless.unreal.core import Class, api, public
from c4s.records.pack import Asset


@public
class Blueprint(AssetObject):
    """A Blueprint of a pack: an actor class made of meshes."""

    def _bind(self, asset: Asset, generated: Class) -> Any:
        self._asset = asset
        self._generated = generated
        return self

    @api
    def generated_class(self) -> Class:
        """The class whose actors it makes."""
        generated: Class = self._generated
        return generated

    def _references(self) -> list[str]:
        return [part.asset for part in self._asset.parts]
