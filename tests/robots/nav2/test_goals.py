"""Orders and cancellations of Nav2 as goals and calls: only a pause means all of them."""

import math
from typing import Any

import msgspec
import pytest

from fleet_tui.model.commands import CancelOrder, ClearOrders, PauseRobot, PlaceOrder, ResumeRobot
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation_events import GoalsReported
from fleet_tui.model.order import at_vertices
from fleet_tui.robots.adapter import ActionGoal, ServiceCall, Site
from fleet_tui.robots.nav2.adapter import Nav2
from fleet_tui.robots.nav2.goals import ALL
from fleet_tui.robots.profile import Profile
from fleet_tui.text.errors import CommandError
from tests.support.nav2_adapter import UUID, ZERO, adapter, known, robot


def test_a_goal_of_zeros_is_never_known_for_to_cancel_it_would_cancel_all() -> None:
    adapter = Nav2(Profile(kind="nav2"), Site())
    feed = next(one for one in adapter.feeds("robot_0", ["hall"]) if one.key == "navigate_to_pose")
    stamp = {"sec": 1, "nanosec": 0}
    listed = [{"goal_info": {"goal_id": {"uuid": id_}, "stamp": stamp}, "status": 2} for id_ in (ALL, UUID)]
    (fact,) = adapter.read(feed, msgspec.Raw(msgspec.json.encode({"status_list": listed})), 5.0)
    assert isinstance(fact, GoalsReported)
    assert [goal.uuid for goal in fact.goals] == [UUID]
    assert fact.fault == "goal_id.uuid is all zeros, which means all goals"


class TestOutgoing:
    def test_two_stops_are_waypoints_with_the_heading_of_the_way_there(self) -> None:
        command = PlaceOrder("tb2", at_vertices("1", "3"))
        (goal,) = adapter().outgoing(command, 1, robot(pose=Pose(0.0, -5.0)))
        assert isinstance(goal, ActionGoal)
        assert (goal.address, goal.type) == ("/tb2/follow_waypoints", "nav2_msgs/action/FollowWaypoints")
        poses: Any = goal.args["poses"]
        assert [one["header"] for one in poses] == [{"frame_id": "map"}] * 2
        assert [one["pose"]["position"]["x"] for one in poses] == [0.0, 2.0]
        yaws = [2 * math.asin(one["pose"]["orientation"]["z"]) for one in poses]
        assert yaws == pytest.approx([math.pi / 2, 0.0])

    def test_a_cancel_is_complete_and_of_one_goal(self) -> None:
        (call,) = adapter().outgoing(
            CancelOrder("tb2", "0a28bf7e"), 1, robot(known("0a28bf7e", "navigate_to_pose"))
        )
        assert call == ServiceCall(
            "/tb2/navigate_to_pose/_action/cancel_goal",
            "action_msgs/srv/CancelGoal",
            {"goal_info": {"goal_id": {"uuid": UUID}, "stamp": {"sec": 0, "nanosec": 0}}},
        )

    @pytest.mark.parametrize("id_", ["", "0", "00000000", "0a28", "k1"])
    def test_no_cancel_leaves_for_an_id_that_is_not_known(self, id_: str) -> None:
        with pytest.raises(CommandError, match="unknown goal"):
            adapter().outgoing(CancelOrder("tb2", id_), 1, robot(known("0a28bf7e", "navigate_to_pose")))

    def test_only_a_pause_means_all_goals_and_the_waypoints_first(self) -> None:
        it, busy = adapter(), robot(known("0a28bf7e", "dock_robot"))
        calls = it.outgoing(PauseRobot("tb2"), 1, busy)
        asked = [call.address.split("/")[2] for call in calls]
        assert asked[:3] == ["follow_waypoints", "navigate_to_pose", "dock_robot"]
        # Those of Nav2 itself come after what drives by them.
        assert {"follow_path", "spin", "backup", "drive_on_heading", "assisted_teleop"} < set(asked[3:])
        for call in calls:
            assert isinstance(call, ServiceCall)
            assert call.args == {"goal_info": {"goal_id": {"uuid": ZERO}, "stamp": {"sec": 0, "nanosec": 0}}}
        assert not it.outgoing(ResumeRobot("tb2"), 1, busy)

    def test_clear_means_the_goals_of_this_console(self) -> None:
        ours = known("0a28bf7e", "navigate_to_pose", is_ours=True)
        other = known("bbbbbbbb", "dock_robot", "u" * 22 + "==")
        (call,) = adapter().outgoing(ClearOrders("tb2"), 1, robot(ours, other))
        assert isinstance(call, ServiceCall) and UUID in str(call.args)

    def test_what_can_not_be_said_is_refused_with_a_reason(self) -> None:
        for command, detail in [
            (PlaceOrder("tb2", at_vertices("9")), "vertex 9"),
            (PlaceOrder("tb2", ()), "a destination"),
        ]:
            with pytest.raises(CommandError, match=detail):
                adapter().outgoing(command, 1, robot())
        lacking = adapter(actions={"follow_waypoints": ""})
        with pytest.raises(CommandError, match=r"\[profile.actions\] follow_waypoints is empty"):
            lacking.outgoing(PlaceOrder("tb2", at_vertices("1", "2")), 1, robot())
