"""Traces and metrics of a run through OpenTelemetry, where ``OTEL_EXPORTER_OTLP_ENDPOINT`` names a collector.

A trace a trial, with a span a stage. Metrics: ``c4s.slots.busy`` and ``c4s.slots.count`` by kind, ``c4s.queue`` (trials
that wait), ``c4s.spend`` (US dollars), ``c4s.trials`` by outcome. The library's own variables (``OTEL_SERVICE_NAME``,
``OTEL_EXPORTER_OTLP_HEADERS``, ``OTEL_METRIC_EXPORT_INTERVAL``, ...) hold. Without the variable nothing is imported.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Final

from c4s import extras
from c4s.records.journal import Event
from c4s.records.progress import Snapshot

if TYPE_CHECKING:
    from opentelemetry.metrics import CallbackOptions, Observation
    from opentelemetry.trace import Span, Tracer

VARIABLE: Final = "OTEL_EXPORTER_OTLP_ENDPOINT"
_SERVICE: Final = "OTEL_SERVICE_NAME"
Listener = Callable[[Event], None]


def is_asked_for() -> bool:
    """Whether a collector is named. ``BadInput`` where one is and the library is not there."""
    if not os.environ.get(VARIABLE, "").strip():
        return False
    extras.need("telemetry", VARIABLE)
    return True


@contextmanager
def sending(run_id: str, trial_id: Callable[[str], str], look: Callable[[], Snapshot]) -> Iterator[Listener | None]:
    """For the block, send what a run's events tell; gives the listener, or None where no collector is named.

    Args:
        run_id: the run.
        trial_id: the id of a trial by its path below the run's folder.
        look: gives the run's progress; it is called when metrics are sent, on another thread.
    """
    if not is_asked_for():
        yield None
        return
    from opentelemetry.exporter.otlp.proto.http.metric_exporter import OTLPMetricExporter
    from opentelemetry.exporter.otlp.proto.http.trace_exporter import OTLPSpanExporter
    from opentelemetry.sdk.metrics import MeterProvider
    from opentelemetry.sdk.metrics.export import PeriodicExportingMetricReader
    from opentelemetry.sdk.resources import Resource
    from opentelemetry.sdk.trace import TracerProvider
    from opentelemetry.sdk.trace.export import BatchSpanProcessor

    resource = Resource.create({"service.name": os.environ.get(_SERVICE) or "c4s", "c4s.run": run_id})
    traces = TracerProvider(resource=resource)
    traces.add_span_processor(BatchSpanProcessor(OTLPSpanExporter()))
    meters = MeterProvider(resource=resource, metric_readers=[PeriodicExportingMetricReader(OTLPMetricExporter())])
    gauges = _Gauges(look)
    meter = meters.get_meter("c4s")
    for name, unit, observe in gauges.all():
        meter.create_observable_gauge(name, [observe], unit=unit)
    outcomes = meter.create_counter("c4s.trials", description="trials that ended, by outcome")
    spans = _Spans(traces.get_tracer("c4s"), trial_id, lambda outcome: outcomes.add(1, {"outcome": outcome}))
    try:
        yield spans
    finally:
        spans.close()
        meters.shutdown()
        traces.shutdown()


class _Spans:
    """Makes spans of events: a trial's from its first stage to its end, with a child a stage."""

    def __init__(self, tracer: Tracer, trial_id: Callable[[str], str], count: Callable[[str], None]) -> None:
        self._tracer, self._trial_id, self._count = tracer, trial_id, count
        self._trials: dict[str, Span] = {}
        self._stages: dict[tuple[str, str | None, Any], Span] = {}

    def __call__(self, event: Event) -> None:
        if event.trial is None:
            return
        key = (event.trial, event.stage, event.attempt or event.verifier)
        if event.event == "started":
            self._stages[key] = self._start(event)
        elif event.event in ("ended", "failed") and key in self._stages:
            span = self._stages.pop(key)
            _describe(span, event)
            span.end(_nanoseconds(event))
        elif event.event in ("done", "pending"):
            self._count(event.status or event.event)
            if (trial := self._trials.pop(event.trial, None)) is not None:
                _describe(trial, event)
                trial.end(_nanoseconds(event))

    def close(self) -> None:
        """What has not ended ends now: the run was stopped."""
        for span in (*self._stages.values(), *self._trials.values()):
            span.set_attribute("c4s.cut_off", True)
            span.end()

    def _start(self, event: Event) -> Span:
        from opentelemetry.trace import set_span_in_context

        trial = event.trial or ""
        if trial not in self._trials:
            configuration, case, repeat = trial.split("/")
            told: dict[str, str | int] = {
                "c4s.configuration": configuration,
                "c4s.case": case,
                "c4s.repeat": int(repeat[1:]),
            }
            told["c4s.trial_id"] = self._trial_id(trial)
            self._trials[trial] = self._tracer.start_span(
                f"trial {configuration}", attributes=told, start_time=_nanoseconds(event)
            )
        name = f"{event.stage} {event.verifier}" if event.verifier else str(event.stage)
        stage: dict[str, str | int] = {"c4s.stage": str(event.stage), "c4s.slot": str(event.kind)}
        if event.attempt is not None:
            stage["c4s.attempt"] = event.attempt
        return self._tracer.start_span(
            name, set_span_in_context(self._trials[trial]), attributes=stage, start_time=_nanoseconds(event)
        )


class _Gauges:
    """What is measured when metrics are sent: one look at the run's progress for all."""

    def __init__(self, look: Callable[[], Snapshot]) -> None:
        self._look = look

    def all(self) -> Iterator[tuple[str, str, Callable[[CallbackOptions], Iterable[Observation]]]]:
        """Name, unit, and what gives the values."""
        yield "c4s.slots.busy", "{slot}", lambda _: self._by_kind(busy=True)
        yield "c4s.slots.count", "{slot}", lambda _: self._by_kind(busy=False)
        yield "c4s.queue", "{trial}", lambda _: self._one(self._look().waiting)
        yield "c4s.spend", "USD", lambda _: self._one(self._look().spent_usd or 0.0)

    def _by_kind(self, *, busy: bool) -> Iterator[Observation]:
        from opentelemetry.metrics import Observation

        counted: Counter[str] = Counter()
        for slot in self._look().slots:
            counted[slot.kind] = slot.busy if busy else slot.count
        for kind, count in counted.items():
            yield Observation(count, {"kind": kind})

    def _one(self, value: float) -> Iterator[Observation]:
        from opentelemetry.metrics import Observation

        yield Observation(value)


def _describe(span: Span, event: Event) -> None:
    from opentelemetry.trace import Status, StatusCode

    for name in ("ended_by", "cost_usd", "score", "status", "error"):
        value = getattr(event, name)
        if value is not None:
            span.set_attribute(f"c4s.{name}", value)
    if event.event in ("failed", "pending"):
        span.set_status(Status(StatusCode.ERROR, event.line))


def _nanoseconds(event: Event) -> int:
    return int(event.time * 1e9)
