"""Where the benchmark's own data lies for tests: the folder ``shared`` beside the checkout, if it is there."""

from pathlib import Path

SHARED = Path(__file__).resolve().parents[2] / "shared"
