"""The model judges that ship: a configuration each."""

__all__ = []
