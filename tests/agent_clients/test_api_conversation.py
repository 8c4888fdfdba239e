"""Trimming of the API loop's conversation, and its options."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from c4s.agents.api.conversation import KEPT_TURNS, Conversation, Turn, picture_part
from c4s.agents.api.options import ApiOptions
from c4s.errors import BadInput
from c4s.records.plan import Configuration

HEAD = [{"role": "user", "content": [{"type": "text", "text": "Build."}, picture_part(b"reference")]}]


def turn(number: int, results: list[int], pictures: int) -> Turn:
    calls = [
        {"id": f"{number}-{i}", "type": "function", "function": {"name": "t", "arguments": "{}"}}
        for i in range(len(results))
    ]
    return Turn(
        {"role": "assistant", "content": None, "tool_calls": calls},
        [{"role": "tool", "tool_call_id": f"{number}-{i}", "content": "x" * size} for i, size in enumerate(results)],
        [
            part
            for i in range(pictures)
            for part in ({"type": "text", "text": f"Picture {i}:"}, picture_part(bytes([number % 256, i])))
        ],
    )


TURNS = st.lists(st.tuples(st.lists(st.integers(0, 9000), min_size=1, max_size=3), st.integers(0, 2)), max_size=14)


@given(TURNS, st.integers(0, 60_000))
def test_trimming_keeps_the_conversation_whole(sizes: list[tuple[list[int], int]], target: int) -> None:
    conversation = Conversation(HEAD)
    conversation.turns = [turn(number, *size) for number, size in enumerate(sizes)]
    newest, before = conversation.turns[-KEPT_TURNS:], conversation.tokens()
    shown = [message for one in newest for message in one.messages()]
    trimming = conversation.trim(target)
    messages = conversation.messages()
    assert messages[0] == HEAD[0] and (not shown or messages[-len(shown) :] == shown)
    assert conversation.tokens() <= max(target, before if len(sizes) <= KEPT_TURNS else 0) or len(
        conversation.turns
    ) == min(KEPT_TURNS, len(sizes))
    open_calls: set[str] = set()
    for message in messages:
        if message["role"] == "tool":
            open_calls.remove(message["tool_call_id"])
        else:
            assert not open_calls
            open_calls = {call["id"] for call in message.get("tool_calls", ())}
    assert not open_calls
    if trimming is None:
        assert conversation.tokens() == before
    else:
        assert trimming.before_tokens == before and trimming.after_tokens == conversation.tokens()
        assert trimming.turns_removed == len(sizes) - len(conversation.turns)


def test_pictures_go_first_then_long_results_then_turns() -> None:
    conversation = Conversation(HEAD)
    conversation.turns = [turn(number, [7000], 1) for number in range(10)]
    first = conversation.trim(conversation.tokens() - 2 * 1500)
    assert first is not None and (first.pictures_removed, first.results_shortened, first.turns_removed) == (2, 0, 0)
    second = conversation.trim(conversation.tokens() - 6 * 1500)
    assert second is not None and second.pictures_removed == 4 and second.results_shortened > 0
    third = conversation.trim(100)
    assert third is not None and third.turns_removed == 6 and len(conversation.turns) == KEPT_TURNS
    assert conversation.trim(100) is None


def test_the_estimate_follows_what_the_model_counts() -> None:
    conversation = Conversation(HEAD)
    conversation.turns = [turn(0, [3500], 0)]
    conversation.learn(5000)
    assert conversation.tokens() == pytest.approx(5000, abs=1)
    conversation.learn(None)
    assert conversation.tokens() == pytest.approx(5000, abs=1)


@pytest.mark.parametrize(
    ("options", "fields"),
    [
        ({}, {}),
        ({"thinking": True}, {"reasoning": {"enabled": True}}),
        ({"thinking": False}, {"reasoning": {"enabled": False}}),
        ({"effort": "high"}, {"reasoning": {"enabled": True, "effort": "high"}}),
        ({"endpoint": "openai", "thinking": False}, {"reasoning_effort": "none"}),
        ({"endpoint": "openai", "thinking": True, "effort": "low"}, {"reasoning_effort": "low"}),
        ({"endpoint": "own", "thinking": False}, {"chat_template_kwargs": {"enable_thinking": False}}),
        (
            {
                "endpoint": "own",
                "thinking": True,
                "seed": 3,
                "temperature": 0.5,
                "extra": {"provider": {"only": ["x"]}},
            },
            {
                "chat_template_kwargs": {"enable_thinking": True},
                "seed": 3,
                "temperature": 0.5,
                "provider": {"only": ["x"]},
            },
        ),
    ],
)
def test_thinking_and_sampling_as_the_endpoint_wants_them(
    options: dict[str, object], fields: dict[str, object]
) -> None:
    assert ApiOptions.of(Configuration(name="a", client="api", options=options)).request_fields() == fields


@pytest.mark.parametrize("options", [{"thinkng": True}, {"temperature": -1}, {"context_tokens": 10}, {"same_calls": 1}])
def test_bad_options_are_named(options: dict[str, object]) -> None:
    with pytest.raises(BadInput, match=next(iter(options))):
        ApiOptions.of(Configuration(name="a", client="api", options=options))
