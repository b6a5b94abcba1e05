"""Faults of the simulated hospital, each by what it changes."""

import pytest

from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.rmf.faults import FAULTS, PACKAGES
from fleet_tui.simulator.rmf.fleet import RmfFleet
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer

ONE = "tiny/robot_0"


def faulty(name: str) -> tuple[RmfFleet, RosbridgeServer]:
    fleet = RmfFleet(1, 1, seed=1, quiet=True)
    server = RosbridgeServer(fleet, dialect=ROS2)
    play(server, [(name, ONE)])
    return fleet, server


@pytest.mark.parametrize("name", FAULTS)
def test_each_can_be_played(name: str) -> None:
    fleet, _ = faulty(name)
    fleet.step(30.0)


def test_they_do_what_they_say() -> None:
    assert faulty("silent")[0].robots[ONE].silence
    assert faulty("issue")[0].robots[ONE].issues
    assert faulty("battery")[0].robots[ONE].body.battery < 10
    assert faulty("refuse")[0].dispatcher.refuses
    assert faulty("never")[0].dispatcher.deaf and faulty("no-answer")[0].dispatcher.mute
    assert faulty("unsourced")[1].bridge.services.unsourced >= set(PACKAGES)


def test_a_dispatcher_that_restarts_counts_from_one_again() -> None:
    fleet, _ = faulty("dispatcher")
    text = '{"type": "dispatch_task_request", "request": {"description": {"places": ["Store"]}}}'
    first = fleet.dispatcher.take(text, "a")
    fleet.step(30.0)
    again = fleet.dispatcher.take(text, "b")
    assert first is not None and again is not None
    assert first[1]["state"]["booking"] == again[1]["state"]["booking"]
