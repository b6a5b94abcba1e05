"""Probes of fleets of Open-RMF: the bridge, and a node that takes requests."""

from collections.abc import Iterator

from fleet_tui.robots.probes import BridgeProbe, Diagnosis, ListenerProbe, Probe
from fleet_tui.robots.ros.names import Names


def probes(names: Names) -> Iterator[Probe]:
    """Return the checks of a fleet."""
    yield BridgeProbe("distribution", judge_bridge)
    if topic := names.topic("requests", ""):
        yield ListenerProbe("requests", topic, names.type("requests"), "orders")


def judge_bridge(ros: int, distro: str) -> Diagnosis:
    """Judge the bridge by its generation: Open-RMF runs on ROS 2."""
    if ros == 1:
        return Diagnosis("fail", "ROS 1 bridge", "Open-RMF needs a ROS 2 bridge: correct the url or the kind")
    return Diagnosis("ok", distro or "not reported by the bridge")
