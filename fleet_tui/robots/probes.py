"""Probes: the doctor's checks besides topics and services, defined by the adapter."""

from collections.abc import Callable, Collection, Mapping
from typing import Literal, NamedTuple

from fleet_tui.model.events import Event
from fleet_tui.model.navigation import DOWN, MUTE, Servers
from fleet_tui.model.ros_logs import PartDiagnosis


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


class LifecycleProbe(NamedTuple):
    """The lifecycle of the servers that drive a robot: `service` of their manager tells whether they are
    active, harmless to call at any time, and `nodes` has the service of each that tells its state, of type
    `node_type`, in the order of their start; those `needed` are down if theirs is not listed. `judge` gets
    the manager's answer, a text if the call failed, or what it publishes about the part `diagnosed` of
    /diagnostics, and the states; `remedy` if it does not exist."""

    check: str
    service: str
    type: str
    nodes: Mapping[str, str]
    node_type: str
    needed: frozenset[str]
    judge: Callable[[object, Mapping[str, str]], Servers]
    remedy: str
    diagnosed: str = ""

    def is_active(self, answer: object) -> bool:
        """Tell whether the manager says that all are active: then none has to be asked."""
        return self.judge(answer, {}).is_active

    def diagnosis(self, health: Mapping[str, PartDiagnosis], listed: Collection[str]) -> PartDiagnosis | None:
        """Return what the manager publishes about itself, None if nothing is surely its own: a node leaves
        its namespace out by default, and with it which of several managers it is. `listed` are all
        services."""
        node, _, verb = self.service.rpartition("/")
        name = node.rpartition("/")[2]
        named = health.get(f"{node}: {self.diagnosed}")
        unnamed = health.get(f"{name}: {self.diagnosed}")
        if named is not None or unnamed is None:
            return named
        namesake = f"/{name}/{verb}"
        is_alone = not any(one.endswith(namesake) and one != self.service for one in listed)
        return unnamed if is_alone else None

    def unlisted(self, listed: Collection[str]) -> dict[str, str]:
        """Return the needed nodes that are not there, as states."""
        return {node: DOWN for node in self.nodes if node in self.needed and self.nodes[node] not in listed}


def lifecycle_label(answer: object) -> str:
    """Return the state of a node (lifecycle_msgs/GetState) in its answer."""
    state = answer.get("current_state") if isinstance(answer, Mapping) else None
    label = state.get("label") if isinstance(state, Mapping) else None
    return label if isinstance(label, str) and label else MUTE


class ServiceProbe(NamedTuple):
    """A service that not every such robot has. `keys` are those of the profile, `lost` is impossible without
    it."""

    keys: tuple[str, ...]
    service: str
    type: str
    lost: str


Probe = ActionProbe | MessageProbe | BridgeProbe | ListenerProbe | LifecycleProbe | ServiceProbe
