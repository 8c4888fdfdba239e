"""What a clean engine says of a saved scene, the same for every engine: snapshot, dependencies, pictures, digests."""

from c4s.evidence.clean import CleanEngine, SceneUnreadable, open_clean, open_level
from c4s.evidence.collect import export_and_look, export_evidence, export_level, look
from c4s.evidence.masks import Tracer
from c4s.evidence.pictures import glimpses, take_pictures
from c4s.evidence.shots import Shots, Taken

__all__ = [
    "CleanEngine",
    "SceneUnreadable",
    "Shots",
    "Taken",
    "Tracer",
    "clean",
    "collect",
    "export_and_look",
    "export_evidence",
    "export_level",
    "glimpses",
    "held_out",
    "look",
    "open_clean",
    "open_level",
    "shots",
    "take_pictures",
]
