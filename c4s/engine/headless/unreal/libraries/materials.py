"""Dynamic material instances without an owner."""

from __future__ import annotations

from c4s.engine.headless.unreal.assets import MaterialInstanceDynamic, MaterialInterface
from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core import Object, api, public
from c4s.engine.headless.unreal.enums import MIDCreationFlags


@public
class MaterialLibrary(Object):
    """Dynamic material instances without an owner."""

    @classmethod
    @api
    def create_dynamic_material_instance(
        cls,
        world_context_object: Object | None,
        parent: MaterialInterface,
        optional_name: Name | str = "None",
        creation_flags: MIDCreationFlags = MIDCreationFlags.NONE,
    ) -> MaterialInstanceDynamic:
        """A transient instance."""
        name = "MaterialInstanceDynamic_0" if str(optional_name) == "None" else str(optional_name)
        made: MaterialInstanceDynamic = MaterialInstanceDynamic._owned(name, None, parent)
        return made
