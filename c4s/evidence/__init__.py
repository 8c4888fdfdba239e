"""What a clean engine says of a saved scene, the same for every engine: snapshot, dependencies, pictures, digests."""

from c4s.evidence.cameras import overview_cameras
from c4s.evidence.clean import CleanEngine, SceneUnreadable, open_clean, open_level
from c4s.evidence.collect import export_and_look, export_evidence, export_level, look
from c4s.evidence.pictures import take_pictures

__all__ = [
    "CleanEngine",
    "SceneUnreadable",
    "cameras",
    "clean",
    "collect",
    "export_and_look",
    "export_evidence",
    "export_level",
    "look",
    "open_clean",
    "open_level",
    "overview_cameras",
    "take_pictures",
]
