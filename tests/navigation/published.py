"""The published reachability probe: where its script lies, and the form of what it writes."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Final

from tests.shared import SHARED

SCRIPT: Final = Path(
    os.environ.get("C4S_PUBLISHED_PROBE") or SHARED / "upstream" / "ue_scripts" / "measure_reachability.py"
)
"""The benchmark's own ``measure_reachability.py``."""
TEXT, NUMBER, TRUTH = str, float, bool
POINT: Final = [NUMBER]
ROW: Final = {
    "actor_path": TEXT,
    "label": TEXT,
    "class": TEXT,
    "eligible": TRUTH,
    "ineligible_reason": TEXT,
    "projected_point_cm": POINT,
    "projection_offset_index": NUMBER,
    "connected": TRUTH,
}
FORM: Final[dict[str, Any]] = {
    "schema_version": TEXT,
    "measurement_type": TEXT,
    "map_path": TEXT,
    "runtime_provenance": {"project_file_path": TEXT, "engine_version": TEXT, "map_path": TEXT},
    "navmesh": {
        "actor_path": TEXT,
        "class": TEXT,
        "agent_radius_requested_cm": NUMBER,
        "agent_radius_properties_set": [TEXT],
        "agent_radius_errors": [TEXT],
        "rebuild": [{"method": TEXT, "status": TEXT}],
        "parameters_after_rebuild": {
            "agent_radius": NUMBER,
            "agent_height": NUMBER,
            "agent_max_slope": NUMBER,
            "agent_max_step_height": NUMBER,
            "cell_size": NUMBER,
            "cell_height": NUMBER,
        },
        "bounds_min_cm": POINT,
        "bounds_max_cm": POINT,
        "bounds_source": TEXT,
        "settle": {
            "settled": TRUTH,
            "method": TEXT,
            "path": TEXT,
            "probe_count": NUMBER,
            "wait_s": NUMBER,
            "passes": [{"attempt": NUMBER, "sample_count": NUMBER, "remaining_build_tasks": NUMBER}],
            "remaining_build_tasks_reported": NUMBER,
            "fallback_reason": TEXT,
        },
    },
    "samples": {
        "seed": NUMBER,
        "requested_count": NUMBER,
        "accepted_count": NUMBER,
        "projection_attempts": NUMBER,
        "projection_extent_cm": NUMBER,
        "points_cm": [POINT],
    },
    "components": {
        "count": NUMBER,
        "sizes": [NUMBER],
        "largest_size": NUMBER,
        "largest_representative_cm": POINT,
        "path_endpoint_tolerance_cm": NUMBER,
        "cost": {
            "query_batches": NUMBER,
            "path_queries": NUMBER,
            "query_budget": NUMBER,
            "query_budget_unit": TEXT,
            "query_budget_truncated": TRUTH,
        },
        "spread": [{"settled": TRUTH, "settle_path": TEXT, "count": NUMBER, "largest_size": NUMBER}],
    },
    "diagnostics": {
        "status": TEXT,
        "level_actor_count": NUMBER,
        "eligible_actor_count": NUMBER,
        "projected_actor_count": NUMBER,
        "connected_actor_count": NUMBER,
        "unresolved": [{"what": TEXT, "reason": TEXT}],
        "measurement_errors": [{"actor": TEXT, "error": TEXT}],
        "options": {},
    },
}
"""Keys and kinds of values of an output, ``actors`` aside: a mapping of ``ROW`` by actor path. Any may be null."""


def faults(value: Any, form: Any, at: str = "output") -> list[str]:
    """Where a value is not of a form: a key that is missing, a value of another kind."""
    if value is None:
        return []
    if isinstance(form, dict):
        if not isinstance(value, dict):
            return [at]
        return [
            fault
            for key, part in form.items()
            for fault in (faults(value[key], part, f"{at}.{key}") if key in value else [f"{at}.{key} is missing"])
        ]
    if isinstance(form, list):
        return [fault for one in value for fault in faults(one, form[0], at)] if isinstance(value, list) else [at]
    fits = type(value) in (int, float) if form is NUMBER else type(value) is form
    return [] if fits else [f"{at} is {value!r}"]


def faults_of(output: dict[str, Any]) -> list[str]:
    """Where an output is not of the probe's form."""
    rows = [fault for path, row in output["actors"].items() for fault in faults(row, ROW, path)]
    return faults(output, FORM) + rows
