"""How an agent reaches its model: through a meter that is open for one attempt."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from c4s.errors import BadInput, MachineryFault
from c4s.meter.endpoints import ModelEndpoint, key_of, model_endpoint, spending_limit
from c4s.meter.meter import Meter
from c4s.meter.metered import MeterRun
from c4s.meter.prices import PriceTable
from c4s.meter.record import UPSTREAM_FAULTS
from c4s.meter.spending import Ledger
from c4s.records.folder import RunFolder
from c4s.records.guards import Guards
from c4s.records.plan import Configuration


class ModelOutage(MachineryFault):
    """The model endpoint failed, so the client did."""


@dataclass(frozen=True)
class ModelAccess:
    """What a client is given: an address and a token. ``run`` stays with the adapter."""

    url: str
    """Address of the meter, without a path."""
    model: str
    run: MeterRun

    @property
    def token(self) -> str:
        """Stands for the key; worth nothing outside the meter."""
        return self.run.token

    def blame(self, what: str) -> None:
        """Raise ``MachineryFault`` when the model endpoint, not the agent, is why it ended badly."""
        last = self.run.last_generation
        if last is None:
            raise MachineryFault(
                f"{what}, before it asked its model anything",
                where=self.run.run_id,
                todo="read the client's output in the attempt's agent folder",
            )
        if last.ending in UPSTREAM_FAULTS:
            raise ModelOutage(
                f"{what} after the model endpoint failed ({last.ending} {last.status or ''}: {last.problem})",
                where=self.run.run_id,
                todo="run the same command again",
            )


def check_model(configuration: Configuration, default_endpoint: str, wire: str) -> tuple[str, ModelEndpoint, list[str]]:
    """Name and description of the endpoint that a configuration asks for, and the models that it may use there.

    ``BadInput`` where it names no model, an unknown endpoint, or one that does not speak the client's wire format.
    """
    if not configuration.model:
        raise BadInput("the configuration names no model", where=configuration.name, todo="add `model:` to it")
    side = configuration.options.get("side_models", [])
    if not isinstance(side, list) or not all(isinstance(model, str) and model for model in side):
        raise BadInput("side_models must be a list of model names", where=configuration.name)
    name = str(configuration.options.get("endpoint", default_endpoint))
    endpoint = model_endpoint(name)
    if wire not in endpoint.formats:
        raise BadInput(
            f"client {configuration.client!r} speaks {wire}, and endpoint {name!r} speaks "
            + ", ".join(endpoint.formats),
            where=configuration.name,
        )
    return name, endpoint, [configuration.model, *side]


@contextmanager
def open_model(
    configuration: Configuration,
    default_endpoint: str,
    wire: str,
    *,
    usage: Path,
    ledger: Path | None,
    at_limit: Callable[[], None],
) -> Iterator[ModelAccess]:
    """Open a meter for an attempt.

    The configuration names ``model``; its options may name ``endpoint`` (of ``endpoints.yaml`` or a known one) and
    ``side_models``, further models that the client may use. ``BadInput`` for what is missing.
    """
    name, endpoint, models = check_model(configuration, default_endpoint, wire)
    books = _books(RunFolder(ledger.parent)) if ledger is not None else None
    run = MeterRun(
        configuration.name,
        endpoint,
        key_of(name, endpoint),
        usage,
        prices=PriceTable.load(),
        ledger=books,
        models=models,
        at_limit=at_limit,
    )
    with Meter() as meter:
        yield ModelAccess(meter.open_run(run), models[0], run)


def _books(run: RunFolder) -> Ledger:
    """What a run spent, with its limit as its guards have it, so on every machine alike."""
    limit = Guards.read(run.guards).spend_usd if run.guards.is_file() else spending_limit()
    return Ledger(run.spending, limit, run.elsewhere)
