"""What makes a requirement bundle sound: the one validator, a file a kind of rule (paper, Semantic Verifier)."""

__all__ = ["check", "coverage", "prompt", "report"]
