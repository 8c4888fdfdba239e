"""The snapshot's catalog of material parameters. Runs inside an engine: stdlib and ``unreal`` only.

A material that cannot be asked is in the catalog with what was found and with the errors, as published.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

import unreal

from c4s.editor.values import plain

_KINDS = ("scalar", "vector", "texture")
_SOURCE = "ue_material_editing_library_resolved_parameters_v1"


class _Probe:
    """Asks one material, and keeps what went wrong."""

    def __init__(self, material: Any, kind: str) -> None:
        self._material = material
        self._of = "material_instance" if "MaterialInstance" in kind else "material_default"
        self.errors: list[str] = []

    def _ask(self, what: str, call: Callable[[], Any]) -> Any:
        try:
            answer = call()
        except Exception as error:  # Unreal raises bare Exceptions; the record tells them
            self.errors.append(f"{what}: {error}")
            return None
        if isinstance(answer, tuple) and len(answer) == 2 and isinstance(answer[0], bool):
            return answer[1] if answer[0] else None
        return answer

    def values(self, kind: str) -> dict[str, Any]:
        """Values by name of the parameters of one kind."""
        ask = getattr(unreal.MaterialEditingLibrary, f"get_{kind}_parameter_names", None)
        if ask is None:
            self.errors.append(f"{kind}_parameter_names_api_unavailable")
            return {}
        names = self._ask(f"{kind}_parameter_names", lambda: sorted({str(name) for name in ask(self._material)}))
        return {name: self._value(kind, name) for name in names or ()}

    def _value(self, kind: str, name: str) -> Any:
        own = getattr(self._material, f"get_{kind}_parameter_value", None)
        value = self._ask(f"{kind}_{name} direct", lambda: own(name)) if own is not None else None
        if value is not None:
            return value
        method = f"get_{self._of}_{kind}_parameter_value"
        ask = getattr(unreal.MaterialEditingLibrary, method, None)
        if ask is None:
            self.errors.append(f"{method}_api_unavailable")
            return None
        return self._ask(f"{method}_{name}", lambda: ask(self._material, name))

    def textures(self) -> list[str] | None:
        """Paths of all textures, or None where the engine cannot tell."""
        found = None
        methods = [
            name
            for name in ("get_material_used_textures", "get_used_textures")
            if hasattr(unreal.MaterialEditingLibrary, name)
        ]
        for name in methods:
            ask = getattr(unreal.MaterialEditingLibrary, name)
            found = self._ask(name, partial(_paths, ask, self._material))
            if found is not None:
                break
        if not methods:
            self.errors.append("material_used_textures_api_unavailable")
        return found


def _paths(ask: Callable[[Any], Iterable[Any]], material: Any) -> list[str]:
    return sorted({str(thing.get_path_name()) for thing in ask(material) if thing is not None})


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def material_record(material: Any, path: str, kind: str) -> dict[str, Any]:
    """One entry of the catalog, under the published names."""
    probe = _Probe(material, kind)
    scalars, vectors, textures = (probe.values(each) for each in _KINDS)
    scalars = {name: plain(value) for name, value in scalars.items()}
    vectors = {name: plain(value) for name, value in vectors.items()}
    used = probe.textures()
    return {
        "schema_version": "1.0",
        "material_path": path,
        "material_class_path": kind,
        "resolved_scalar_parameters": {name: value for name, value in scalars.items() if _is_number(value)},
        "resolved_vector_parameters": {
            name: value for name, value in vectors.items() if isinstance(value, list) and len(value) >= 3
        },
        "resolved_texture_parameters": {
            name: str(value.get_path_name()) for name, value in textures.items() if value is not None
        },
        "used_texture_paths": used,
        "probe_status": "partial" if probe.errors else "success",
        "probe_errors": probe.errors,
        "source": _SOURCE,
    }
