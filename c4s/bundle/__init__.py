"""Published evidence bundles (``code4scene.bundle.v1``): everything that scores one case offline, in one folder."""

from c4s.bundle.manifest import Manifest
from c4s.bundle.reading import EvidenceBundle, read_bundle
from c4s.bundle.scoring import BundleScore, score_bundle
from c4s.bundle.writing import pack_trial

__all__ = ["BundleScore", "EvidenceBundle", "Manifest", "pack_trial", "read_bundle", "score_bundle"]
