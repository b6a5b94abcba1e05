"""Orders and cancellations of move_base as messages."""

import math
from typing import Any

import pytest

from fleet_tui.model.commands import CancelOrder, ClearOrders, PauseRobot, PlaceOrder, ResumeRobot
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation import Goal
from fleet_tui.model.order import Stop, at_vertices
from fleet_tui.robots.adapter import ServiceCall
from fleet_tui.text.errors import CommandError
from tests.support.move_base_adapter import NEVER, OWN, RVIZ, adapter, listed, robot, sent


class TestSent:
    """Commands as messages."""

    def test_an_order_is_a_goal_with_a_name_of_ours_and_no_stamps(self) -> None:
        (goal,) = sent(PlaceOrder("r1", (Stop(pose=Pose(1.0, 2.0, math.pi)),)), robot())
        assert (goal.address, goal.type) == ("/r1/move_base/goal", "move_base_msgs/MoveBaseActionGoal")
        assert goal.name == OWN
        assert goal.message["goal_id"] == {"stamp": NEVER, "id": OWN}
        assert goal.message["goal"] == {
            "target_pose": {
                "header": {"stamp": NEVER, "frame_id": "map"},
                "pose": {
                    "position": {"x": 1.0, "y": 2.0, "z": 0.0},
                    "orientation": {"x": 0.0, "y": 0.0, "z": 1.0, "w": pytest.approx(0.0)},
                },
            }
        }

    def test_a_goal_leads_to_one_stop(self) -> None:
        with pytest.raises(CommandError, match="has one stop"):
            sent(PlaceOrder("r1", at_vertices("1", "2")), robot())
        assert adapter().kind.gives_stops

    def test_a_cancel_names_its_goal_and_no_stamp(self) -> None:
        ours, other = listed((OWN, 1, ""), (RVIZ, 1, ""))
        (cancel,) = sent(CancelOrder("r1", other.id), robot(ours, other))
        assert (cancel.address, cancel.type) == ("/r1/move_base/cancel", "actionlib_msgs/GoalID")
        assert cancel.message == {"stamp": NEVER, "id": RVIZ}
        with pytest.raises(CommandError, match="unknown goal 99999999: see the queue of r1"):
            sent(CancelOrder("r1", "99999999"), robot(ours, other))

    def test_a_clear_takes_back_only_goals_of_this_console(self) -> None:
        ours, other = listed((OWN, 1, ""), (RVIZ, 1, ""))
        known = robot(Goal(**{**_fields(ours), "is_ours": True}), other)
        assert [one.message["id"] for one in sent(ClearOrders("r1"), known)] == [OWN]
        assert sent(ClearOrders("r1"), robot(other)) == []

    def test_a_pause_cancels_every_goal_by_its_id_also_one_that_is_on_its_way(self) -> None:
        goals = listed((OWN, 1, ""), (RVIZ, 6, ""), ("/x-1-1.0", 3, ""))
        ids = [one.message["id"] for one in sent(PauseRobot("r1"), robot(*goals, named="fleet-tui-new"))]
        assert ids == [OWN, RVIZ, "fleet-tui-new"]
        assert sent(ResumeRobot("r1"), robot(*goals)) == []

    def test_a_pause_of_a_robot_that_never_listed_its_goals_means_all_at_once(self) -> None:
        (cancel,) = sent(PauseRobot("r1"), robot(received=False))
        assert cancel.message == {"stamp": NEVER, "id": ""}

    def test_a_lock_is_published(self) -> None:
        profile: dict[str, Any] = {
            "topics": {"pause_navigation": "/{robot}/pause"},
            "settings": {"move_base": {"pause": "lock"}},
        }
        assert sent(PauseRobot("r1"), robot(), **profile)[0].message == {"data": True}
        assert ("/r1/pause", "std_msgs/Bool") in list(adapter(**profile).publications("r1"))
        services = {"pause": "/{robot}/halt", "resume": "/{robot}/go"}
        calls = adapter(services=services).outgoing(PauseRobot("r1"), 1, robot())
        assert calls == (ServiceCall("/r1/halt", "std_srvs/Trigger", {}),)

    def test_a_topic_that_is_empty_is_named(self) -> None:
        with pytest.raises(CommandError, match=r"\[profile.topics\] goal is empty"):
            sent(PlaceOrder("r1", at_vertices("1")), robot(), topics={"goal": ""})


def _fields(goal: Goal) -> dict[str, Any]:
    return {name: getattr(goal, name) for name in goal.__struct_fields__}
