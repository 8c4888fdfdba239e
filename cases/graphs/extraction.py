"""From any prompt to a requirement bundle by a model: it answers in the intermediate representation, and what is wrong
with an answer is sent back, a bounded number of times, for a whole new one."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib.resources import files
from typing import Any, Final

from pydantic import ValidationError

from c4s.chat.client import Reply
from c4s.errors import MachineryFault
from c4s.files import digest, digest_bytes, parse_json
from c4s.protocol.graph.check import check_bundle
from c4s.protocol.graph.prompt import description_end
from c4s.protocol.graph.report import GraphFinding, GraphReport
from cases.graphs.compiler import COMPILER, COMPILER_VERSION, IRFaults, compile_bundle
from cases.graphs.ir import SemanticIR, answer_schema

INSTRUCTIONS: Final = files("cases.graphs").joinpath("instructions.md").read_text()
POLICY: Final = "local_validation_feedback_full_replacement_v1"
"""As published: every repair is a whole new answer to the report on the last one."""
PARSER: Final = "llm_full_prompt"
MAX_TOKENS: Final = 32_768
"""As published: of one answer."""
REPAIRS: Final = 3
MOST_REPAIRS: Final = 10
MOST_CHARACTERS: Final = 1 << 20
"""A longer answer is not read."""
MOST_TOLD: Final = 40
"""Findings of one report that are sent back."""
REVIEW: Final = {
    "approved": True,
    "human_reviewed": False,
    "review_method": "automated_policy",
    "reviewer": f"{COMPILER}:{COMPILER_VERSION}",
    "policy_name": "extracted-and-validated",
    "policy_version": "1",
    "basis": ["requirement_graph_contract_valid", "prompt_grounding_valid"],
}
Ask = Callable[[Mapping[str, Any]], Reply]
"""Asks a model once; raises what the chat client raises."""


@dataclass
class Extracted:
    """A bundle, and how it came about."""

    bundle: dict[str, Any]
    report: GraphReport
    answers: int
    """How many the model gave."""


@dataclass
class _Answer:
    """One answer, read: a bundle with its report, or what keeps it from being one."""

    text: str
    findings: list[GraphFinding] = field(default_factory=list)
    bundle: dict[str, Any] | None = None
    report: GraphReport = field(default_factory=GraphReport)

    @property
    def usable(self) -> bool:
        """Whether the bundle has no error; words may be left out."""
        return self.bundle is not None and not self.report.errors

    @property
    def whole(self) -> bool:
        """Whether there is nothing to send back."""
        return self.usable and not self.report.coverage.uncovered


def extract(
    case_id: str, prompt: str, model: str, ask: Ask, *, repairs: int = REPAIRS, fields: Mapping[str, Any] | None = None
) -> Extracted:
    """Ask a model for the requirements of a prompt, without the asset palette behind its description.

    Args:
        case_id: part of the bundle's id.
        prompt: the whole prompt; a blank line at its end is not part of it.
        model: id of the model.
        ask: sends one request.
        repairs: most answers after the first.
        fields: further fields of each request.

    Raises ``MachineryFault`` when no answer can be used. One that leaves words out is sent back while repairs are left,
    and used where the last one is no better.
    """
    prompt = prompt.rstrip("\n")
    description = prompt[: description_end(prompt)]
    recovery: list[str] = []
    best: _Answer | None = None
    answer: _Answer | None = None
    for number in range(repairs + 1):
        reply = ask(_request(model, description, answer, fields or {}))
        answer = _read(reply, case_id, prompt)
        if answer.usable and (best is None or _left_out(answer) < _left_out(best)):
            best = answer
        if answer.whole:
            break
        recovery += [f"answer {number + 1}: {line}" for line in _told(answer)]
    if best is None or best.bundle is None:
        last = _told(answer) if answer is not None else []
        raise MachineryFault(
            f"the model gave no requirement graph that can be used in {repairs + 1} answers: {'; '.join(last[:3])}",
            where=model,
            todo="try another model, or more repairs",
        )
    made = best.bundle
    made["provenance"] |= _provenance(model, description, number, recovery)
    return Extracted(made, check_bundle(made, making=True), number + 1)


def _left_out(answer: _Answer) -> int:
    return len(answer.report.coverage.uncovered)


def _provenance(model: str, description: str, repairs: int, recovery: list[str]) -> dict[str, Any]:
    instructions = digest_bytes(INSTRUCTIONS.encode())
    return {
        "authoring_client": {"client": "c4s", "model": model, "max_tokens": MAX_TOKENS},
        "cache_key": digest([model, instructions, description])[:24],
        "stage0_instructions_sha256": instructions,
        "stage0_max_tokens": MAX_TOKENS,
        "stage0_recovery_errors": recovery,
        "stage0_repair_attempt_count": repairs,
        "stage0_repair_policy": POLICY,
        "waived_unsupported_semantics": [],
        "waivers_allowed": False,
    }


def _request(model: str, description: str, last: _Answer | None, fields: Mapping[str, Any]) -> dict[str, Any]:
    messages: list[dict[str, Any]] = [
        {"role": "system", "content": INSTRUCTIONS},
        {"role": "user", "content": json.dumps({"description": description}, ensure_ascii=False)},
    ]
    if last is not None:
        lines = "\n".join(f"- {line}" for line in _told(last))
        messages += [
            {"role": "assistant", "content": last.text},
            {
                "role": "user",
                "content": f"The check found this wrong with your list:\n{lines}\nAnswer with a whole new list.",
            },
        ]
    schema = {"name": "semantic_ir", "strict": True, "schema": answer_schema()}
    return {
        "model": model,
        "messages": messages,
        "temperature": 0,
        "seed": 0,
        "max_tokens": MAX_TOKENS,
        "response_format": {"type": "json_schema", "json_schema": schema},
        **fields,
    }


def _read(reply: Reply, case_id: str, prompt: str) -> _Answer:
    text = reply.message.get("content")
    if not isinstance(text, str) or not text.strip():
        return _Answer("", [_fault("answer", "it is empty")])
    if len(text) > MOST_CHARACTERS:
        return _Answer("", [_fault("answer", f"it has {len(text)} characters, at most {MOST_CHARACTERS} are read")])
    if reply.finish == "length":
        return _Answer("", [_fault("answer", "it was cut at its output limit: say it shorter")])
    try:
        ir = SemanticIR.model_validate(parse_json(text.encode()))
        bundle = compile_bundle(case_id, prompt, ir, {"authoring_parser": PARSER}, REVIEW)
    except ValidationError as error:
        return _Answer(text, _shape(error))
    except IRFaults as error:
        return _Answer(text, error.findings)
    except (ValueError, RecursionError) as error:
        return _Answer(text, [_fault("answer", f"it is no JSON: {str(error)[:200]}")])
    report = check_bundle(bundle, making=True)
    left_out = [finding for finding in report.warnings if finding.rule == "coverage.words"]
    return _Answer(text, [*report.errors, *left_out], bundle, report)


def _shape(error: ValidationError) -> list[GraphFinding]:
    if error.error_count() > MOST_TOLD:
        return [_fault("answer", f"{error.error_count()} fields are wrong")]
    rows = error.errors(include_url=False, include_input=False, include_context=False)
    return [_fault(".".join(map(str, row["loc"]))[:200] or "answer", row["msg"]) for row in rows]


def _told(answer: _Answer) -> list[str]:
    lines = [f"{finding.place}: {finding.message} [{finding.rule}]" for finding in answer.findings[:MOST_TOLD]]
    more = len(answer.findings) - MOST_TOLD
    return [*lines, f"and {more} more"] if more > 0 else lines


def _fault(place: str, message: str) -> GraphFinding:
    return GraphFinding("ir.shape", "error", place, message)
