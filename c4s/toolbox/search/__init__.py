"""Offline search by meaning: a sentence model, and weighted words (BM25F) that a small word net has widened."""

from c4s.toolbox.search.document import Document
from c4s.toolbox.search.index import Index
from c4s.toolbox.search.meaning_index import vectors_of
from c4s.toolbox.search.sentences import sentence_model

__all__ = ["Document", "Index", "sentence_model", "vectors_of"]
