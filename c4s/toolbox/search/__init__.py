"""Offline search by meaning: weighted words (BM25F) over documents that a word net of things has widened."""

from c4s.toolbox.search.index import Document, Index

__all__ = ["Document", "Index"]
