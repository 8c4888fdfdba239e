"""Descriptions drafted by a model from pictures of a scene, for an author to go on with."""

from cases.drafting.prompt import DRAFT_REPAIRS, MOST_PICTURES, Drafted, draft_description

__all__ = ["DRAFT_REPAIRS", "MOST_PICTURES", "Drafted", "draft_description"]
