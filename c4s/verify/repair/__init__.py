"""Actor Repair F1: which targets a scene repair reached and what else it touched. See DESIGN.md in this folder."""

from c4s.protocol.repair import NOMINAL, PROFILES, RELAXED, REPAIR_POLICY, STRICT, Tolerances
from c4s.verify.repair.counts import RepairResult, repair
from c4s.verify.repair.verdict import repair_verdict, verify_repair

__all__ = [
    "NOMINAL",
    "PROFILES",
    "RELAXED",
    "REPAIR_POLICY",
    "STRICT",
    "RepairResult",
    "Tolerances",
    "batch",
    "repair",
    "repair_verdict",
    "verifier",
    "verify_repair",
]
