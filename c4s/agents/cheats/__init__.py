"""Agents that build nonsense which a judge might take for a scene: what each of them reaches, a judge gives away."""

__all__ = ["agent", "layouts"]
