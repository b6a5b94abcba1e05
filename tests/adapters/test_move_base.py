"""Robots with move_base on the wire: what their messages tell, and what leaves for them."""

import json
import math
from typing import Any

import pytest

from fleet_tui.adapters.adapter import Feed, Publication, ServiceCall, Site
from fleet_tui.adapters.discovery import Listed
from fleet_tui.adapters.move_base.adapter import MoveBase
from fleet_tui.adapters.move_base.discovery import discover
from fleet_tui.adapters.probes import BridgeProbe
from fleet_tui.adapters.profile import Profile
from fleet_tui.adapters.ros.operations import Publish, decode
from fleet_tui.errors import CommandError, WireError
from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    Command,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
)
from fleet_tui.model.events import Event
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation import Goal
from fleet_tui.model.navigation_events import Alive, GoalsReported, LocalisationReported, TargetReported
from fleet_tui.model.order import OrderState, Stop, at_vertices
from fleet_tui.model.robot import Robot, RobotMap
from tests.support.fleets import graph

UNIQUE = "0123456789abcdef0123456789abcdef"
OWN = "fleet-tui-01234567-89ab-cdef-0123-456789abcdef"
RVIZ = "/r1/move_base-4-1700000000.25"
NEVER = {"secs": 0, "nsecs": 0}


def adapter(**profile: Any) -> MoveBase:
    return MoveBase(Profile(kind="move_base", **profile), Site())


def feeds(it: MoveBase) -> dict[str, Feed]:
    return {feed.key: feed for feed in it.feeds("r1", ("hall",))}


def read(it: MoveBase, key: str, message: dict[str, Any]) -> list[Event]:
    operation = decode(json.dumps({"op": "publish", "topic": "/t", "msg": message}).encode())
    assert isinstance(operation, Publish)
    return list(it.read(feeds(it)[key], operation.msg, 5.0))


def status(*goals: tuple[str, int, str]) -> dict[str, Any]:
    header = {"seq": 9, "stamp": {"secs": 1700000009, "nsecs": 0}, "frame_id": ""}
    return {
        "header": header,
        "status_list": [
            {"goal_id": {"stamp": {"secs": 1700000000, "nsecs": 0}, "id": id_}, "status": state, "text": text}
            for id_, state, text in goals
        ],
    }


def listed(*goals: tuple[str, int, str]) -> tuple[Goal, ...]:
    reported = read(adapter(), "status", status(*goals))[0]
    assert isinstance(reported, GoalsReported)
    return reported.goals


def robot(*goals: Goal, heard: bool = True, named: str = "") -> Robot:
    chart = RobotMap(graph=graph(1, 2, 3).graph)
    known = {"move_base": goals} if heard else {}
    return Robot("r1", 1, "rosbridge", {"hall": chart}, floor="hall", goals=known, named=named)


def sent(command: Command, known: Robot, **profile: Any) -> list[Publication]:
    found = adapter(**profile).outgoing(command, 1, known, UNIQUE)
    assert all(isinstance(one, Publication) for one in found)
    return [one for one in found if isinstance(one, Publication)]


class TestHeard:
    """Messages as facts."""

    def test_a_status_lists_the_goals_of_all_and_is_a_sign_of_life(self) -> None:
        facts = read(adapter(), "status", status((OWN, 1, "")))
        assert [type(fact) for fact in facts] == [GoalsReported, Alive]
        ours, other = listed((OWN, 1, "active"), (RVIZ, 0, ""))
        assert (ours.id, ours.uuid, ours.state, ours.word) == (
            "01234567",
            OWN,
            OrderState.IN_PROCESS,
            "active",
        )
        assert (other.uuid, other.state, len(other.id)) == (RVIZ, OrderState.QUEUED, 8)
        assert ours.stamp == 1700000000.0

    def test_an_empty_list_is_news_too(self) -> None:
        assert listed() == ()

    @pytest.mark.parametrize(
        ("number", "text", "state"),
        [
            (2, "", OrderState.CANCELLED),
            (2, "This goal was canceled because another goal was received by the s", OrderState.REPLACED),
            (8, "This goal was canceled because another goal was recieved by the s", OrderState.REPLACED),
            (3, "Goal reached.", OrderState.DONE),
            (4, "Failed to find a valid plan.", OrderState.FAILED),
            (5, "", OrderState.REFUSED),
            (6, "", OrderState.IN_PROCESS),
            (7, "", OrderState.CANCELLED),
            (8, "", OrderState.CANCELLED),
            (9, "", OrderState.LOST),
            (77, "", None),
        ],
    )
    def test_each_state(self, number: int, text: str, state: OrderState | None) -> None:
        (goal,) = listed((OWN, number, text))
        assert (goal.state, goal.said, goal.is_ending) == (state, text, number == 6)

    def test_a_goal_without_an_id_is_left_out_and_said(self) -> None:
        reported = read(adapter(), "status", status(("", 1, ""), (OWN, 1, "")))[0]
        assert isinstance(reported, GoalsReported)
        assert [goal.uuid for goal in reported.goals] == [OWN]
        assert reported.fault == "goal_id.id is empty, which means all goals"
        huge = read(adapter(), "status", status(("x" * 600, 1, "")))[0]
        assert isinstance(huge, GoalsReported) and huge.fault == "goal_id.id has 600 characters"

    def test_ids_of_others_differ_from_one_another(self) -> None:
        found = listed(*[(f"/patrol-{n}-1700000000.5", 1, "") for n in range(50)])
        assert len({goal.id for goal in found}) == 50

    def test_the_target_of_a_goal_that_begins(self) -> None:
        pose = {"position": {"x": 2.0, "y": 3.0, "z": 0.0}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}
        message = {"header": {"frame_id": "map", "stamp": NEVER}, "pose": pose}
        assert read(adapter(), "target", message) == [TargetReported("r1", 5.0, Pose(2.0, 3.0))]

    def test_feedback_places_only_robots_that_tell_it_nowhere_else(self) -> None:
        pose = {"position": {"x": 2.0, "y": 3.0, "z": 0.0}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}
        base = {"header": {"frame_id": "map", "stamp": NEVER}, "pose": pose}
        message = {"header": {"frame_id": ""}, "status": {}, "feedback": {"base_position": base}}
        assert read(adapter(), "feedback", message) == [Alive("r1", 5.0)]
        alone = adapter(topics={"pose": ""})
        assert LocalisationReported("r1", 5.0, Pose(2.0, 3.0), "map", None, None) in read(
            alone, "feedback", message
        )
        assert "pose" in alone.kind.reports and alone.kind.silence["pose"] == math.inf

    def test_what_is_no_message_of_its_type(self) -> None:
        for key in ("status", "target", "feedback"):
            with pytest.raises(WireError):
                read(adapter(), key, {"data": 1})


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
        (cancel,) = sent(PauseRobot("r1"), robot(heard=False))
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


TYPES = {
    "move_base/status": "actionlib_msgs/GoalStatusArray",
    "move_base/current_goal": "geometry_msgs/PoseStamped",
    "move_base/NavfnROS/plan": "nav_msgs/Path",
    "move_base/TrajectoryPlannerROS/local_plan": "nav_msgs/Path",
    "odom": "nav_msgs/Odometry",
    "amcl_pose": "geometry_msgs/PoseWithCovarianceStamped",
    "battery_state": "sensor_msgs/BatteryState",
}


class TestFound:
    """Such robots among what a bridge lists."""

    def test_by_namespaces(self) -> None:
        topics = {f"/{robot}/{name}": type_ for robot in ("a", "b") for name, type_ in TYPES.items()}
        found = discover(Listed({**topics, "/map": "nav_msgs/OccupancyGrid"}, {}))
        assert found.robots == {"a": ["floor_0"], "b": ["floor_0"]}
        assert not found.topics and not found.is_guess

    def test_alone_on_its_bridge(self) -> None:
        topics = {f"/{name}": type_ for name, type_ in TYPES.items()}
        found = discover(Listed({**topics, "/map": "nav_msgs/OccupancyGrid"}, {}))
        assert found.robots == {"robot_0": ["floor_0"]}
        assert found.topics["goal"] == "/move_base/goal" and found.topics["odometry"] == "/odom"

    def test_another_planner(self) -> None:
        types = {name.replace("NavfnROS", "GlobalPlanner"): type_ for name, type_ in TYPES.items()}
        found = discover(Listed({f"/a/{name}": type_ for name, type_ in types.items()}, {}))
        assert found.topics["plan"] == "/{robot}/move_base/GlobalPlanner/plan"

    def test_not_where_actions_are_of_ros_2_or_of_something_else(self) -> None:
        assert not discover(Listed({"/a/dock/status": "actionlib_msgs/GoalStatusArray"}, {})).robots
        assert not discover(Listed({"/a/move_base/status": "std_msgs/String"}, {})).robots


def test_a_bridge_of_ros_2_is_the_wrong_one() -> None:
    (probe,) = [one for one in adapter().probes("r1") if isinstance(one, BridgeProbe)]
    assert probe.judge(2, "jazzy").level == "fail" and "ROS 2" in probe.judge(2, "jazzy").measured
    assert probe.judge(1, "noetic").level == "ok"
