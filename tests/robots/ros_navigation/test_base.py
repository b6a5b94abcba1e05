"""The common part of both navigation stacks: commands by their kind, messages by their feed."""

from collections.abc import Sequence
from typing import Any

import pytest

from fleet_tui.model import commands
from fleet_tui.model.events import BatteryReported
from fleet_tui.model.order import at_vertices
from fleet_tui.robots.adapter import ActionGoal, Feed, Outgoing, ServiceCall, Site
from fleet_tui.robots.nav2.vocabulary import VOCABULARY
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros_navigation.base import GoalMessages, NavigationAdapter
from fleet_tui.robots.ros_navigation.pauses import PauseSettings
from tests.support.fleets import R0, T0, fleet

ROBOT = fleet().robots[R0]


def said(what: str, *arguments: object) -> Sequence[Outgoing]:
    return (ActionGoal(what, "", {"told": arguments}),)


GOALS = GoalMessages(
    lambda _names, robot, stops, unique: said("order", robot.name, len(stops), unique),
    lambda _names, robot, order_id: said("cancel", robot.name, order_id),
    lambda _names, robot: said("cancel own", robot.name),
    lambda _names, robot: said("cancel all", robot.name),
)


def adapter(**profile: Any) -> NavigationAdapter:
    return NavigationAdapter(
        "nav2", VOCABULARY, Profile(kind="nav2", **profile), Site(), PauseSettings, GOALS
    )


@pytest.mark.parametrize(
    ("command", "expected"),
    [
        (commands.PlaceOrder(R0, at_vertices("1", "2")), said("order", R0, 2, "ab")),
        (commands.CancelOrder(R0, "3f2a"), said("cancel", R0, "3f2a")),
        (commands.ClearOrders(R0), said("cancel own", R0)),
        (commands.PauseRobot(R0), said("cancel all", R0)),
        (commands.ResumeRobot(R0), ()),
    ],
)
def test_each_command_becomes_the_goals_messages(
    command: commands.Command, expected: Sequence[Outgoing]
) -> None:
    assert tuple(adapter().outgoing(command, 7, ROBOT, "ab")) == expected


def test_a_site_with_a_pause_service_is_paused_by_it_and_its_goal_goes_on() -> None:
    services = {"pause": "/{robot}/pause", "resume": "/{robot}/resume"}
    it = adapter(services=services)
    for command, name in ((commands.PauseRobot(R0), "pause"), (commands.ResumeRobot(R0), "resume")):
        (call,) = it.outgoing(command, 7, ROBOT)
        assert isinstance(call, ServiceCall) and call.address == f"/{R0}/{name}"
    assert {name for _, name, _ in it.services(R0)} == {f"/{R0}/pause", f"/{R0}/resume"}


def test_a_message_is_read_as_its_feed_says() -> None:
    feed = Feed("battery", (R0,), "", "/b", "sensor_msgs/BatteryState")
    (battery,) = adapter().read(feed, {"percentage": 0.5}, T0)
    assert battery == BatteryReported(R0, T0, 0.5, is_raw=True)
    assert adapter().learned(ServiceCall("", "", {}), None, ROBOT, T0, T0) == ()
