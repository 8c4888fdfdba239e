"""Asset packs: meshes, the store, and the checks of every byte."""

__all__ = ["basic_shapes", "check", "meshes", "store", "suite_check"]
