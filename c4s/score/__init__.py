"""Case scores, aggregation, policies, re-scoring."""

__all__ = ["batch", "case", "policies", "rescore"]
