"""Ways to break a requirement bundle: a row a way, with the rule that catches it and what it says."""

from __future__ import annotations

import copy
import math
from collections.abc import Callable
from typing import Any

Bundle = dict[str, Any]


def nodes(made: Bundle, kind: str) -> list[Any]:
    return [node for node in made["graph"]["nodes"] if node["node_type"] == kind]


def edges(made: Bundle, kind: str) -> list[Any]:
    return [edge for edge in made["graph"]["edges"] if edge["edge_type"] == kind]


def first(made: Bundle) -> Any:
    """A scored predicate with arguments."""
    scored = {row["node_id"] for row in made["requirements"]}
    about = {edge["source_id"] for edge in edges(made, "argument")}
    return next(node for node in nodes(made, "predicate") if node["id"] in scored and node["id"] in about)


def said(made: Bundle) -> Any:
    return first(made)["semantic_parameters"]


def typed(made: Bundle, kind: str) -> Any:
    return next(node for node in nodes(made, "predicate") if node["predicate_type"] == kind)


def qualified(made: Bundle) -> Any:
    """The predicate of the fewest words that has a qualifier."""
    found = [node for node in nodes(made, "predicate") if node["semantic_parameters"]["qualifiers"]]
    return min(found, key=lambda node: len(node["text"]))


def row(made: Bundle, node: Any, name: str = "requirements") -> Any:
    return next(row for row in made[name] if row["node_id"] == node["id"])


def no_words(made: Bundle) -> None:
    """A prompt that says much more than its requirements, behind them."""
    view, prompt = made["provenance"]["semantic_prompt_view"], made["graph"]["prompt"]
    end = view["source_span"][1]
    more = " Further away " + "violet submarines glide " * 30
    made["graph"]["prompt"] = prompt[:end] + more + prompt[end:]
    view["source_span"] = [0, end + len(more)]


def one_word(made: Bundle) -> None:
    view, prompt = made["provenance"]["semantic_prompt_view"], made["graph"]["prompt"]
    end = view["source_span"][1]
    made["graph"]["prompt"] = prompt[:end] + " Submarines." + prompt[end:]
    view["source_span"] = [0, end + 12]


def contradict(made: Bundle) -> None:
    """The first scored predicate a second time, denied."""
    again = copy.deepcopy(first(made))
    again["id"], again["polarity"] = "predicate_denied", "negative"
    copied = [edge for edge in edges(made, "argument") if edge["source_id"] == first(made)["id"]]
    add(made, again, copied)


def repeat(made: Bundle) -> None:
    again = copy.deepcopy(first(made))
    again["id"] = "predicate_again"
    add(made, again, [edge for edge in edges(made, "argument") if edge["source_id"] == first(made)["id"]])


def count_twice(made: Bundle) -> None:
    for number, value in enumerate((3, 7)):
        node = copy.deepcopy(first(made))
        node["id"], node["predicate_type"] = f"predicate_count_{number}", "quantity"
        node["semantic_parameters"] |= {
            "requirement_type": "quantity",
            "qualifiers": [],
            "relation": None,
            "quantity": {"mode": "exact", "value": value, "lower": None, "upper": None, "qualitative": None},
        }
        add(made, node, edges(made, "argument")[:1])


def add(made: Bundle, node: Any, arguments: list[Any]) -> None:
    """A further scored predicate, sound but for what it says."""
    made["graph"]["nodes"].append(node)
    about = {edge["target_id"]: "candidate_all" for edge in arguments}
    made["graph"]["edges"] += [{**edge, "source_id": node["id"]} for edge in arguments]
    template = first(made)
    for name, own in (("requirements", "requirement_id"), ("evaluations", "binding_id")):
        made[name].append(
            copy.deepcopy(row(made, template, name)) | {own: node["id"], "node_id": node["id"], "entity_scopes": about}
        )
    made["requirements"][-1]["requirement_id"] = made["evaluations"][-1]["requirement_id"] = f"atomic_{node['id']}"
    made["evaluations"][-1]["parameters"]["predicate_type"] = node["predicate_type"]
    scored = [e for e in edges(made, "requirement_member") if e["role"] == "scored_facet"]
    made["graph"]["edges"].append({**scored[0], "target_id": node["id"]})
    for edge in edges(made, "requirement_member"):
        if edge["role"] == "scored_facet":
            edge["weight_fraction"] = 1 / (len(scored) + 1)


def own_logic(made: Bundle) -> None:
    """A logic predicate of two that are logic of it."""
    names = ["predicate_l0", "predicate_l1", "predicate_l2"]
    parts = {names[0]: names[1:], names[1]: [names[0], names[2]], names[2]: [names[1], names[0]]}
    for name in names:
        node = copy.deepcopy(first(made))
        node["id"], node["predicate_type"] = name, "logic"
        node["semantic_parameters"] |= {
            "requirement_type": "logic",
            "qualifiers": [],
            "logic": {"operator": "any_of", "requirement_ids": parts[name]},
        }
        made["graph"]["nodes"].append(node)
        made["graph"]["edges"] += [{"edge_type": "scope", "source_id": name, "target_id": part} for part in parts[name]]
        made["graph"]["edges"].append(
            {
                **edges(made, "requirement_member")[-1],
                "target_id": name,
                "role": "support_only",
                "weight_fraction": None,
            }
        )


def scored_operands(made: Bundle) -> None:
    """A logic predicate over two that are scored already."""
    scored = [r["node_id"] for r in made["requirements"][:2]]
    node = copy.deepcopy(first(made))
    node["id"], node["predicate_type"] = "predicate_logic", "logic"
    node["semantic_parameters"] |= {
        "requirement_type": "logic",
        "qualifiers": [],
        "logic": {"operator": "any_of", "requirement_ids": scored},
    }
    add(made, node, [])
    made["graph"]["edges"] += [{"edge_type": "scope", "source_id": node["id"], "target_id": part} for part in scored]


SUPPORT = {"role": "support_only", "weight_fraction": None}


def logic(operator: str, *parts: str) -> Any:
    return {"operator": operator, "requirement_ids": list(parts)}


def of_one(made: Bundle) -> None:
    retype(made, "logic", logic=logic("all_of", made["requirements"][-1]["node_id"]))


def same(rows: Any, field: str) -> None:
    rows[1][field] = rows[0][field]


def members(made: Bundle) -> None:
    a, b = nodes(made, "entity")[:2]
    a["member_ids"], b["member_ids"] = [b["id"]], [a["id"]]


def said_q(made: Bundle) -> Any:
    return qualified(made)["semantic_parameters"]["qualifiers"][0]


def far_away(made: Bundle) -> Any:
    """A qualifier at the words of the last entity, far from those of its predicate."""
    last = nodes(made, "entity")[-1]
    prompt, start = made["graph"]["prompt"], last["source_span"]["start"]
    return {
        "source_text": last["text"],
        "source_span": dict(last["source_span"]),
        "occurrence": prompt.count(last["text"], 0, start),
    }


def about(made: Bundle) -> Any:
    return next(edge for edge in edges(made, "argument") if edge["source_id"] == first(made)["id"])


def other(made: Bundle) -> str:
    mine = {edge["target_id"] for edge in edges(made, "argument") if edge["source_id"] == first(made)["id"]}
    found: str = next(node["id"] for node in nodes(made, "entity") if node["id"] not in mine)
    return found


def actor(made: Bundle) -> Any:
    return next(node for node in nodes(made, "entity") if node["grounding_mode"] in ("actor", "actor_collection"))


def facet(made: Bundle) -> Any:
    return next(edge for edge in edges(made, "requirement_member") if edge["role"] == "scored_facet")


def drop_arguments(made: Bundle) -> None:
    name = first(made)["id"]
    made["graph"]["edges"] = [
        e for e in made["graph"]["edges"] if not (e["edge_type"] == "argument" and e["source_id"] == name)
    ]


def drop_member(made: Bundle) -> None:
    name = facet(made)["target_id"]
    made["graph"]["edges"] = [e for e in made["graph"]["edges"] if e["target_id"] != name]


def retype(made: Bundle, kind: str, **parameters: Any) -> None:
    first(made)["predicate_type"] = kind
    said(made).update({"requirement_type": kind, "quantity": None, **parameters})


def quantity(mode: str, **numbers: Any) -> Any:
    return {"mode": mode, "value": None, "lower": None, "upper": None, "qualitative": None, "unit": None, **numbers}


BREAKS: list[tuple[str, str, Callable[[Bundle], Any]]] = [
    ("shape", "error", lambda b: b.pop("review")),
    ("shape", "error", lambda b: b.update(schema_version="3.0")),
    ("shape", "error", lambda b: b["graph"].update(schema_version="1.0")),
    ("shape", "error", lambda b: b["graph"].update(prompt="")),
    ("shape", "error", lambda b: b["graph"].update(prompt=b["graph"]["prompt"] + "\ud800")),
    ("shape", "error", lambda b: first(b).update(name="half \ud800 of a pair")),
    ("shape", "error", lambda b: b["provenance"].update(note=math.nan)),
    ("shape", "error", lambda b: b["graph"].pop("edges")),
    ("shape", "error", lambda b: b["graph"]["nodes"].append(7)),
    ("shape", "error", lambda b: b["graph"]["nodes"].append({"node_type": "wish"})),
    ("shape", "error", lambda b: first(b).update(source_span={"start": 9, "end": 9})),
    ("shape", "error", lambda b: first(b).update(source_span={"start": -1, "end": 9})),
    ("shape", "error", lambda b: first(b).update(polarity="perhaps")),
    ("shape", "error", lambda b: first(b).update(predicate_type="vibe")),
    ("shape", "error", lambda b: first(b).update(text="")),
    ("shape", "error", lambda b: said(b).update(quantity={"mode": "exact", "value": float("nan")})),
    ("shape", "error", lambda b: said(b).update(qualifiers=[{"kind": "color"}])),
    ("shape", "error", lambda b: said(b).update(logic=logic("most_of", "a", "b"))),
    ("shape", "error", lambda b: nodes(b, "entity")[0].pop("aliases")),
    ("shape", "error", lambda b: edges(b, "argument")[0].update(ordinal="first")),
    ("shape", "error", lambda b: b["requirements"][0].update(entity_scopes=[])),
    ("grounding.text", "error", lambda b: first(b).update(text="a purple submarine")),
    ("grounding.text", "error", lambda b: nodes(b, "entity")[0]["source_span"].update(end=10**6)),
    ("grounding.text", "error", lambda b: nodes(b, "requirement")[0].update(text="another scene")),
    ("grounding.text", "error", lambda b: b["graph"].update(prompt="x" + b["graph"]["prompt"])),
    ("grounding.view", "error", lambda b: b["provenance"]["semantic_prompt_view"].update(source_span=[0, 5])),
    ("grounding.occurrence", "warning", lambda b: said_q(b).update(occurrence=40)),
    ("grounding.qualifier", "warning", lambda b: said_q(b).update(far_away(b))),
    ("grounding.row", "error", lambda b: b["requirements"][0].update(source_text="else")),
    ("grounding.row", "error", lambda b: b["requirements"][0].update(source_span=[0, 1])),
    ("grounding.row", "error", lambda b: b["evaluations"][0]["source_provenance"].update(source_span=[0, 1])),
    ("references.id", "error", lambda b: b["graph"]["nodes"].append(copy.deepcopy(first(b)))),
    ("references.id", "error", lambda b: same(b["requirements"], "requirement_id")),
    ("references.id", "error", lambda b: same(b["evaluations"], "binding_id")),
    ("references.edge", "error", lambda b: edges(b, "argument")[0].update(target_id="entity_nobody")),
    ("references.edge", "error", lambda b: edges(b, "argument")[0].update(source_id="predicate_nobody")),
    ("references.edge", "error", lambda b: edges(b, "argument")[0].update(target_id=first(b)["id"])),
    ("references.edge", "error", lambda b: b["graph"]["edges"].append(dict(edges(b, "argument")[0]))),
    ("references.edge", "error", lambda b: edges(b, "requirement_member")[0].update(source_id="requirement_nobody")),
    ("references.root", "error", lambda b: b["graph"]["roots"][0].update(requirement_id="requirement_nobody")),
    ("references.member", "error", lambda b: nodes(b, "entity")[0].update(member_ids=["entity_nobody"])),
    ("references.argument", "error", lambda b: drop_arguments(b)),
    ("references.argument", "error", lambda b: b["graph"]["edges"].append({**about(b), "target_id": other(b)})),
    ("references.role", "warning", lambda b: edges(b, "argument")[0].update(role="bystander")),
    ("references.unused", "error", lambda b: b["graph"]["nodes"].append({**actor(b), "id": "entity_idle"})),
    ("references.row", "error", lambda b: b["requirements"][0].update(node_id="predicate_nobody")),
    ("scope.member", "error", lambda b: b["graph"]["edges"].append({**facet(b), **SUPPORT})),
    ("scope.member", "error", lambda b: drop_member(b)),
    ("scope.scored", "error", lambda b: b["requirements"].pop()),
    ("scope.scored", "error", lambda b: facet(b).update(SUPPORT)),
    ("scope.operands", "error", scored_operands),
    ("scope.entities", "error", lambda b: row(b, first(b))["entity_scopes"].clear()),
    ("scope.entities", "error", lambda b: row(b, first(b), "evaluations")["entity_scopes"].update(x="candidate_all")),
    ("scope.population", "warning", lambda b: b["requirements"][0].update(population_scope="candidate_few")),
    ("scope.weight", "error", lambda b: facet(b).update(weight_fraction=0.9)),
    ("scope.weight", "error", lambda b: facet(b).update(weight_fraction=-0.1)),
    ("scope.weight", "error", lambda b: facet(b).update(weight_fraction=None)),
    ("scope.weight", "error", lambda b: facet(b).update(role="support_only")),
    ("scope.weight", "error", lambda b: b["graph"]["roots"][0].update(weight=2.0)),
    ("cycles.logic", "error", own_logic),
    ("cycles.member", "error", members),
    ("consistency.type", "error", lambda b: said(b).update(requirement_type="quantity_of")),
    ("consistency.type", "error", lambda b: retype(b, "quantity")),
    ("consistency.qualifier", "warning", lambda b: retype(b, "material", qualifiers=[])),
    ("consistency.type", "error", lambda b: said(b).update(logic=logic("any_of", "a", "b"))),
    ("consistency.logic", "error", of_one),
    ("consistency.quantity", "error", lambda b: said(b).update(quantity=quantity("range", lower=5, upper=3))),
    ("consistency.quantity", "error", lambda b: said(b).update(quantity=quantity("exact", value=-1))),
    ("consistency.quantity", "error", lambda b: said(b).update(quantity=quantity("exact"))),
    ("consistency.quantity", "error", lambda b: said(b).update(quantity=quantity("range", lower=5))),
    ("consistency.quantity", "error", lambda b: said(b).update(quantity=quantity("qualitative"))),
    ("consistency.quantity", "error", lambda b: said(b).update(quantity=quantity("exact", value=9, upper=3))),
    ("consistency.mode", "warning", lambda b: said(b).update(quantity=quantity("plenty"))),
    ("consistency.entity", "warning", lambda b: nodes(b, "entity")[0].update(entity_type="ghost")),
    ("consistency.evaluations", "error", lambda b: b["evaluations"].reverse()),
    ("consistency.evaluations", "error", lambda b: b["evaluations"].pop()),
    ("consistency.evaluations", "error", lambda b: row(b, first(b), "evaluations")["parameters"].clear()),
    ("consistency.status", "warning", lambda b: b["requirements"][0].update(status="unplanned")),
    ("consistency.polarity", "error", contradict),
    ("consistency.twice", "warning", repeat),
    ("consistency.count", "error", count_twice),
    ("consistency.digest", "warning", lambda b: b["provenance"].update(prompt_sha256="0" * 64)),
    ("consistency.digest", "warning", lambda b: b.update(bundle_id="semantic_x_123")),
    ("consistency.review", "warning", lambda b: b["review"].update(approved=False)),
    ("coverage.ratio", "error", no_words),
    ("coverage.words", "warning", one_word),
]  # fmt: skip
