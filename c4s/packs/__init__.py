"""Asset packs: meshes, the store, and the checks of every byte."""

__all__ = ["basic_shapes", "check", "gltf_bounds", "meshes", "pictures", "store", "suite_check"]
