"""What runs inside a real editor. A project gets a copy: it asks the editor's Python for nothing but ``unreal``."""

__all__ = ["serve"]
