"""What runs beside agent code in any engine: how a job is run and told. It asks a Python for nothing but itself."""

__all__ = ["jobs"]
