"""The turns of the agent ``api`` on one case.

It ends when the model makes no more calls, when the run takes no more, at the turn limit, when the model repeats
itself, or when it says nothing. ``<attempt>/agent/api.jsonl`` records every turn, error and trimming, pictures by their
SHA-256.
"""

from __future__ import annotations

import base64
import json
import random
from dataclasses import asdict
from pathlib import Path
from typing import Any

import mcp_types as wire

from c4s.agents.api.conversation import Conversation, Turn, picture_part
from c4s.agents.api.options import ApiOptions
from c4s.agents.base import AgentContext, AgentReport
from c4s.agents.briefing import briefing, reference_pictures
from c4s.chat.client import ChatClient, Reply
from c4s.chat.failures import ChatFailed
from c4s.chat.replicas import Address, bearer
from c4s.errors import AgentFault, MachineryFault
from c4s.files import append_json_line, digest_bytes, whole_characters
from c4s.toolbox.client import GatewayClient, call_fault
from c4s.toolbox.gateway_run import POLLING

VERSION = "api 1"
FILL, REFILL = 0.85, 0.6
"""Share of the context at which it is trimmed, and to which."""
EMPTY_ANSWERS = 3
DEFAULT_OUTPUT_TOKENS = 8_192
KEPT_FIELDS = ("role", "content", "tool_calls", "reasoning_details", "reasoning_content")
"""Fields of an answer that are sent back; endpoints want their reasoning again between tool calls."""


def play(context: AgentContext) -> AgentReport:
    """Play one case: ``AgentFault`` where the model cannot be asked, or withholds its answer."""
    if context.model is None:
        raise MachineryFault("no model was opened for this agent", where=context.configuration.name)
    log = context.folder / "api.jsonl"
    chat = ChatClient(
        [Address(f"{context.model.url}/v1", bearer(context.model.token))],
        wait=context.stopped,
        jitter=random.Random(f"{context.case.alias}/{context.attempt}"),
        note=lambda record: append_json_line(log, record),
    )
    try:
        with context.connect() as tools:
            message = _Play(context, ApiOptions.of(context.configuration), chat, tools, log).play()
    except ChatFailed as failure:
        if context.stopped(0):
            return AgentReport(client_version=VERSION, message=failure.what)
        if failure.kind != "context":
            context.model.blame(failure.what)
        raise AgentFault(failure.what) from failure
    finally:
        chat.close()
    return AgentReport(client_version=VERSION, message=message)


class _Play:
    def __init__(
        self, context: AgentContext, options: ApiOptions, chat: ChatClient, tools: GatewayClient, log: Path
    ) -> None:
        self._context, self._options, self._chat, self._tools, self._log = context, options, chat, tools, log
        self._specs = [
            {
                "type": "function",
                "function": {"name": tool.name, "description": tool.description or "", "parameters": tool.input_schema},
            }
            for tool in tools.tools()
        ]
        self._conversation = Conversation([{"role": "user", "content": self._first_message()}], self._specs)

    def _first_message(self) -> list[dict[str, Any]]:
        files = reference_pictures(self._context.case, self._context.agent_folder) if self._options.pictures else []
        text = briefing(self._context.case, "c4s", pictures=len(files))
        return [{"type": "text", "text": text}, *(picture_part(file.read_bytes()) for file in files)]

    def play(self) -> str:
        """All turns; the model's closing words or why it was stopped."""
        last, same, empty = "", 0, 0
        for number in range(1, self._options.max_turns + 1):
            if self._context.stopped(0):
                return "the run takes no more calls"
            reply = self._ask(number)
            calls = reply.message.get("tool_calls") or []
            words = str(reply.message.get("content") or "").strip()
            if reply.finish == "content_filter":
                raise AgentFault("the model's answer was withheld by a content filter")
            if not calls and (words or reply.finish == "length"):
                return words or "the model's answer was cut at its output limit"
            if not calls:
                empty += 1
                if empty >= EMPTY_ANSWERS:
                    return f"the model said nothing {EMPTY_ANSWERS} times"
                continue
            asked = json.dumps([call["function"] for call in calls], sort_keys=True)
            if any(call["function"]["name"] != POLLING for call in calls):  # waiting for a job is no loop
                last, same = asked, same + 1 if asked == last else 1
            empty = 0
            if same >= self._options.same_calls:
                return f"the model made the same call {same} times in a row"
            if self._turn(number, reply):
                return words or "the run takes no more calls"
        return f"the limit of {self._options.max_turns} turns is reached"

    def _ask(self, number: int) -> Reply:
        """The model's next answer, with the conversation kept within its context."""
        output = self._options.max_tokens or DEFAULT_OUTPUT_TOKENS
        room = max(self._options.context_tokens - output, self._options.context_tokens // 2)
        if self._conversation.tokens() > FILL * room:
            self._trim(number, round(REFILL * room), "the context fills up")
        while True:
            try:
                reply = self._chat.ask(
                    {
                        "model": self._context.configuration.model,
                        "messages": self._conversation.messages(),
                        "tools": self._specs,
                        "tool_choice": "auto",
                        **self._options.request_fields(),
                    }
                )
            except ChatFailed as failure:
                if failure.kind != "context" or not self._trim(
                    number, round(REFILL * self._conversation.tokens()), "the model says that the prompt is too long"
                ):
                    raise
                continue
            self._conversation.learn(reply.prompt_tokens)
            return reply

    def _trim(self, number: int, target: int, reason: str) -> bool:
        done = self._conversation.trim(target)
        if done is not None:
            append_json_line(self._log, {"event": "trim", "turn": number, "reason": reason, **asdict(done)})
        return done is not None

    def _turn(self, number: int, reply: Reply) -> bool:
        """Make the calls of an answer; True when the run takes no more."""
        calls = reply.message["tool_calls"]
        for index, call in enumerate(calls):
            call["id"] = str(call.get("id") or f"call_{number}_{index}")
            call.setdefault("type", "function")
        assistant = {name: reply.message[name] for name in KEPT_FIELDS if reply.message.get(name) is not None}
        turn = Turn({"content": None, **assistant, "role": "assistant"})
        stopped, digests = False, []
        for index, call in enumerate(calls):
            answer = self._tools.answer(call["function"]["name"], _arguments(call), call_id=f"{number}-{index}")
            text = "".join(block.text for block in answer.content if isinstance(block, wire.TextContent))
            turn.results.append({"role": "tool", "tool_call_id": call["id"], "content": text})
            stopped = stopped or "stop" in json.loads(text)
            for block in answer.content:
                if isinstance(block, wire.ImageContent):
                    digests.append(digest_bytes(base64.b64decode(block.data)))
                    turn.pictures += self._picture(call["function"]["name"], block)
        self._conversation.turns.append(turn)
        append_json_line(
            self._log,
            {
                "event": "turn",
                "turn": number,
                "finish": reply.finish,
                "pictures": digests,
                "prompt_tokens": reply.prompt_tokens,
                "fingerprint": reply.fingerprint,
                "assistant": turn.assistant,
                "results": [r["content"] for r in turn.results],
            },
        )
        return stopped

    def _picture(self, tool: str, block: wire.ImageContent) -> list[dict[str, Any]]:
        if not self._options.pictures:
            return [{"type": "text", "text": f"{tool} made a picture, which this model cannot see."}]
        return [
            {"type": "text", "text": f"Picture of {tool}:"},
            {"type": "image_url", "image_url": {"url": f"data:{block.mime_type};base64,{block.data}"}},
        ]


def _arguments(call: dict[str, Any]) -> dict[str, Any]:
    """The arguments of a call.

    In place of what is no JSON object, or cannot be sent, the gateway gets its beginning under a name that says so,
    which it counts and refuses.
    """
    given = call["function"].get("arguments") or "{}"
    try:
        value = whole_characters(json.loads(given) if isinstance(given, str) else given)
    except (ValueError, RecursionError):
        value = None
    fault = call_fault("", value) if isinstance(value, dict) else "arguments that are no JSON object"
    return value if fault is None else {fault: whole_characters(str(given)[:2000])}
