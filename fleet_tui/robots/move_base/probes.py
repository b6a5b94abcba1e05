"""Probes of a robot with move_base: its bridge, its localisation, its battery."""

from collections.abc import Iterator

from fleet_tui.robots.probes import BridgeProbe, Diagnosis, Probe
from fleet_tui.robots.ros.names import Names
from fleet_tui.robots.ros_navigation.probes import message_probes


def probes(names: Names, robot: str) -> Iterator[Probe]:
    """Return the checks of one robot, and of its bridge."""
    yield BridgeProbe("distribution", judge_bridge)
    yield from message_probes(names, robot)


def judge_bridge(ros: int, distro: str) -> Diagnosis:
    if ros == 2:
        remedy = "move_base needs ROS 1: correct the url, or the kind (nav2?)"
        return Diagnosis("fail", f"ROS 2 bridge{f' ({distro})' if distro else ''}", remedy)
    return Diagnosis("ok", distro or "not reported by the bridge")
