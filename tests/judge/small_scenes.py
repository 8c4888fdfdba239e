"""Small scenes and small bundles, and what stage 1 decides of them."""

from __future__ import annotations

from typing import Any

from c4s.protocol.bundle import read_requirements
from c4s.semantics.state import StateDecider


def asset(name: str, category: str = "prop", tags: tuple[str, ...] = (), color: Any = None, material: str = "M_X"):
    path = f"/Game/P/SM_{name.replace(' ', '')}"
    return {
        "name": name,
        "category": category,
        "tags": list(tags),
        "description": "",
        "materials": [
            {"path": f"/Game/P/{material}.{material}", "texture": None, "base_color": color or [0.5, 0.5, 0.5]}
        ],
    }, f"{path}.{path.rsplit('/', 1)[-1]}"


CATALOG = {
    path: facts
    for facts, path in [
        asset("Office chair", "chair", ("seat",), [0.6, 0.01, 0.01], "M_Wood_Oak"),
        asset("Desk", "table", ("table",)),
        asset("Table lamp", "lighting", ("lamp",)),
        asset("Crate Large 02", "storage", (), None, "M_Steel"),
        asset("Stone wall", "architecture", ("wall",)),
        asset("Fishing boat", "vessel", ("boat",)),
    ]
}
PATHS = {facts["name"]: path for path, facts in CATALOG.items()}


def thing(name: str, asset_name: str, centre, half=(50, 50, 50)) -> dict[str, Any]:
    path = PATHS.get(asset_name, asset_name)
    return {
        "name": name,
        "label": f"label of {name}",
        "class": "/Script/Engine.StaticMeshActor",
        "asset_path": path,
        "component_asset_paths": [path],
        "material_paths": [],
        "transform": {"location_cm": list(centre), "rotation_deg": [0, 0, 0], "scale": [1, 1, 1]},
        "bounds": {"origin_cm": list(centre), "extent_cm": list(half)},
    }


def entity(key: str, *aliases: str, collection=False, region=False) -> dict[str, Any]:
    return {
        "node_type": "entity",
        "id": f"entity_{key}",
        "name": key,
        "aliases": list(aliases),
        "entity_type": "region" if region else "object",
        "referent_kind": "collection" if collection else "individual",
        "grounding_mode": "derived_region" if region else "actor",
    }


def predicate(kind: str, *arguments: str, negative=False, **parameters) -> dict[str, Any]:
    return {
        "node_type": "predicate",
        "id": "p",
        "predicate_type": kind,
        "text": kind,
        "polarity": "negative" if negative else "affirmative",
        "source_span": {"start": 0, "end": 1},
        "semantic_parameters": parameters,
        "arguments": arguments,
    }


def bundle(entities, *predicates) -> dict[str, Any]:
    nodes, edges = list(entities), []
    for number, node in enumerate(predicates):
        made = dict(node, id=f"p{number}")
        for ordinal, key in enumerate(made.pop("arguments")):
            edges.append(
                {
                    "edge_type": "argument",
                    "source_id": made["id"],
                    "target_id": f"entity_{key}",
                    "ordinal": ordinal,
                    "role": "subject" if ordinal == 0 else "reference",
                }
            )
        nodes.append(made)
    return {
        "graph": {"prompt": "A scene.", "nodes": nodes, "edges": edges},
        "requirements": [{"node_id": f"p{i}"} for i in range(len(predicates))],
    }


def decide(scene, entities, *predicates):
    judge = StateDecider(read_requirements(bundle(entities, *predicates)), {"actors": scene}, CATALOG)
    found = [judge.decide(f"p{i}") for i in range(len(predicates))]
    return found[0] if len(found) == 1 else found
