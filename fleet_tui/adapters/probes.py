"""Probes: what beside topics and services a doctor looks at, described by the adapter that knows what it
means."""

from collections.abc import Callable, Mapping
from typing import Literal, NamedTuple

from fleet_tui.model.events import Event


class Diagnosis(NamedTuple):
    """A verdict with its measurement and its remedy."""

    level: Literal["ok", "warn", "fail"]
    measured: str
    remedy: str = ""


class ActionProbe(NamedTuple):
    """An action server that must be there; `remedy` where it is not."""

    check: str
    action: str
    remedy: str


class QueryProbe(NamedTuple):
    """A service that only tells: anybody may call it at any time. `judge` gets its answer, a text where the
    call failed; `remedy` where it is not there."""

    check: str
    service: str
    type: str
    args: Mapping[str, object]
    judge: Callable[[object], Diagnosis]
    remedy: str


class HeardProbe(NamedTuple):
    """Messages of the feed `key`: `judge` gets the number of messages and what the last readable one told,
    None where it told nothing; it returns None where there is nothing to say beside the topic itself."""

    check: str
    key: str
    judge: Callable[[int, Event | None], Diagnosis | None]


class BridgeProbe(NamedTuple):
    """The bridge itself: `judge` gets which ROS it is of, 0 where not known, and the distribution."""

    check: str
    judge: Callable[[int, str], Diagnosis]


Probe = ActionProbe | QueryProbe | HeardProbe | BridgeProbe
