"""What an attempt used of models, in the classes that are priced apart, from its list of requests.

Requests are priced at ingest by the list rates of their day, so a model whose price is added later is priced when its
run is ingested again. Unknown is never 0: a sum is None as soon as one request does not tell.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from c4s.files import read_json_lines
from c4s.meter.prices import COST_CLASSES, Cost, PriceTable, cost_of
from c4s.meter.record import NOT_BILLED
from c4s.meter.usage import Usage

TOKEN_CLASSES = ("fresh_input_tokens", "cache_read_tokens", "cache_write_tokens")


def usage_columns(path: Path) -> dict[str, Any]:
    """The columns of an attempt's row that tell of its requests; none where no request is on record.

    Args:
        path: the attempt's list of requests; it need not be there.
    """
    lines = read_json_lines(path, what="list of requests") if path.is_file() else []
    requests = [line for line in lines if line.get("wire", "") is not None]
    if not requests:
        return {}
    prices = PriceTable.load()
    costs = [_cost(request, prices) for request in requests]
    return {
        "requests": len(requests),
        "unpriced_requests": sum(cost.usd is None for cost in costs),
        **{name: _sum([request.get(name) for request in requests]) for name in TOKEN_CLASSES},
        **{f"{name}_usd": _sum([cost.classes.get(name) for cost in costs]) for name in COST_CLASSES},
    }


def _cost(request: Mapping[str, Any], prices: PriceTable) -> Cost:
    ending = request.get("ending", "ok")
    if ending in NOT_BILLED:
        return Cost(0.0, classes=dict.fromkeys(COST_CLASSES, 0.0))
    if ending != "ok" or request.get("time") is None:
        return Cost(None, "the answer was not complete, or its day is unknown")
    day = datetime.fromtimestamp(request["time"], UTC).date()
    price = prices.price(request.get("model"), day) or prices.price(request.get("served_model"), day)
    return cost_of(Usage.parse({name: request.get(name) for name in Usage.model_fields}), price)


def _sum(values: Sequence[Any]) -> Any:
    return None if None in values else sum(values)
