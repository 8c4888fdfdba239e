"""Offline search by meaning: a sentence model, and weighted words (BM25F) that a small word net has widened."""

from c4s.toolbox.search.document import Document
from c4s.toolbox.search.index import Index
from c4s.toolbox.search.sentences import sentence_model
from c4s.toolbox.search.words import stems_of

__all__ = ["Document", "Index", "sentence_model", "stems_of"]
