"""Probes: the doctor's checks besides topics and services, defined by the adapter."""

from collections.abc import Callable, Mapping
from typing import Literal, NamedTuple

from fleet_tui.model.events import Event


class Diagnosis(NamedTuple):
    """A verdict with its measurement and its remedy."""

    level: Literal["ok", "warn", "fail"]
    measured: str
    remedy: str = ""


class ActionProbe(NamedTuple):
    """An action server that must exist; `remedy` if it does not."""

    check: str
    action: str
    remedy: str


class QueryProbe(NamedTuple):
    """A read-only service: harmless to call at any time. `judge` gets its answer, a text if the call failed;
    `remedy` if the service does not exist."""

    check: str
    service: str
    type: str
    args: Mapping[str, object]
    judge: Callable[[object], Diagnosis]
    remedy: str


class MessageProbe(NamedTuple):
    """Messages of the feed `key`: `judge` gets the number of messages and the events of the last readable
    one, None if it had none; it returns None if it has nothing to add to the topic itself."""

    check: str
    key: str
    judge: Callable[[int, Event | None], Diagnosis | None]


class BridgeProbe(NamedTuple):
    """The bridge itself: `judge` gets its ROS version, 0 if unknown, and the distribution."""

    check: str
    judge: Callable[[int, str], Diagnosis]


class ListenerProbe(NamedTuple):
    """A topic on which consoles publish: a node must listen there. `key` is that of the profile, `lost` is
    impossible without it; `or_type` is a second type that will do."""

    key: str
    topic: str
    type: str
    lost: str
    or_type: str = ""


class ServiceProbe(NamedTuple):
    """A service that not every such robot has. `keys` are those of the profile, `lost` is impossible without
    it."""

    keys: tuple[str, ...]
    service: str
    type: str
    lost: str


Probe = ActionProbe | QueryProbe | MessageProbe | BridgeProbe | ListenerProbe | ServiceProbe
