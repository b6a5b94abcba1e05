"""Robots with Nav2 on the wire: what recordings of a real bridge tell, what is refused, what leaves."""

import json
import math
from typing import Any

import pytest

from fleet_tui.adapters.adapter import ActionGoal, Feed, Publication, ServiceCall, Site
from fleet_tui.adapters.nav2.adapter import Nav2
from fleet_tui.adapters.profile import Profile
from fleet_tui.adapters.ros.operations import Publish, decode
from fleet_tui.errors import CommandError, WireError
from fleet_tui.model import kind
from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.events import BatteryReported, Event
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation import Goal as KnownGoal
from fleet_tui.model.navigation_events import (
    BlockedReported,
    FloorReported,
    GoalsReported,
    LocalisationReported,
    OdometryReported,
    PlanReported,
    ProgressReported,
    Unmeasured,
)
from fleet_tui.model.order import OrderState, Stop, at_vertices
from fleet_tui.model.robot import Reading, Robot, RobotMap
from tests.support.fleets import graph, recording

ZERO = "AAAAAAAAAAAAAAAAAAAAAA=="
UUID = "Cii/ftYHQUKiCFVjZrbQVQ=="


def adapter(**profile: Any) -> Nav2:
    return Nav2(Profile(kind="nav2", **profile), Site())


def feeds(it: Nav2, robot: str = "tb2", *floors: str) -> dict[str, Feed]:
    return {feed.key: feed for feed in it.feeds(robot, floors or ("hall",))}


def read(it: Nav2, key: str, frame: str | dict[str, Any], robot: str = "tb2") -> list[Event]:
    """The facts of a message, or of a frame as it came."""
    if isinstance(frame, dict):
        frame = json.dumps({"op": "publish", "topic": "/t", "msg": frame})
    operation = decode(frame.encode())
    assert isinstance(operation, Publish)
    return list(it.read(feeds(it, robot)[key], operation.msg, 5.0))


def came(name: str, topic: str) -> list[str]:
    """The frames of a topic in a recording."""
    frames = [one["text"] for one in recording(f"{name}.jsonl.gz") if one["dir"] == "in" and "text" in one]
    found = [frame for frame in frames if json.loads(_strict(frame)).get("topic") == topic]
    assert found, topic
    return found


def _strict(frame: str) -> str:
    return frame.replace("NaN", "null")


def robot(*goals: KnownGoal, pose: Pose | None = None) -> Robot:
    chart = RobotMap(graph=graph(1, 2, 3).graph)
    return Robot(
        *("tb2", 1, "rosbridge", {"hall": chart}),
        pose=Reading(pose, 1.0) if pose else None,
        floor="hall",
        goals={goal.action: (goal,) for goal in goals},
    )


def known(id_: str, action: str, uuid: str = UUID, **more: Any) -> KnownGoal:
    return KnownGoal(id_, uuid, action, OrderState.IN_PROCESS, **more)


class TestRecorded:
    """Frames of a real bridge of ROS 2."""

    def test_goals_of_all_clients_with_their_states(self) -> None:
        frames = came("ros2-actions-observer", "/tb2/navigate_to_pose/_action/status")
        facts = [fact for frame in frames for fact in read(adapter(), "navigate_to_pose", frame)]
        assert all(isinstance(fact, GoalsReported) and not fact.fault for fact in facts)
        first = facts[0]
        assert isinstance(first, GoalsReported)
        (goal,) = first.goals
        assert (goal.id, goal.uuid, goal.state, goal.word) == (
            "0a28bf7e",
            UUID,
            OrderState.QUEUED,
            "accepted",
        )
        assert goal.stamp == pytest.approx(1795326222.849662894)
        states = {goal.state for fact in facts if isinstance(fact, GoalsReported) for goal in fact.goals}
        assert {OrderState.QUEUED, OrderState.IN_PROCESS, OrderState.DONE} <= states

    def test_feedback_is_progress_in_which_zero_is_not_known(self) -> None:
        frames = came("ros2-actions-observer", "/tb2/navigate_to_pose/_action/feedback")
        facts = [fact for frame in frames for fact in read(adapter(), "navigate_to_pose feedback", frame)]
        first = facts[0]
        assert isinstance(first, ProgressReported)
        told = first.progress
        assert (told.goal, told.metres, told.seconds, told.elapsed) == ("0a28bf7e", 2.0, 4.0, 0.0)
        assert (told.recoveries, told.stop) == (0, None)
        left = [fact.progress.seconds for fact in facts if isinstance(fact, ProgressReported)]
        assert None in left and 0.0 not in left

    def test_odometry_localisation_and_battery(self) -> None:
        it = adapter()
        (odometry,) = read(it, "odometry", came("ros2-topics", "/tb1/odom")[0])
        assert isinstance(odometry, OdometryReported)
        assert odometry.pose.x == pytest.approx(3.9215, abs=1e-3)
        assert odometry.stamp == pytest.approx(1795325918.69751439)
        (located,) = read(it, "pose", came("ros2-topics", "/tb3/amcl_pose")[0])
        assert isinstance(located, LocalisationReported)
        assert (located.pose, located.frame_id, located.variance) == (Pose(8.0, 3.0), "map", 0.5)
        (battery,) = read(it, "battery", came("ros2-topics", "/tb1/battery_state")[0])
        assert isinstance(battery, BatteryReported)
        assert battery.percent == pytest.approx(0.7425) and battery.is_raw

    def test_every_frame_of_the_recordings_is_read_or_no_topic_of_ours(self) -> None:
        it, count = adapter(), 0
        for name in ("ros2-actions-observer", "ros2-topics"):
            for one in recording(f"{name}.jsonl.gz"):
                if one["dir"] != "in" or "text" not in one:
                    continue
                operation = decode(one["text"].encode())
                if not isinstance(operation, Publish):
                    continue
                mine = {feed.address: feed for feed in it.feeds(operation.topic.split("/")[1], ("hall",))}
                if operation.topic in mine and not mine[operation.topic].large:
                    assert list(it.read(mine[operation.topic], operation.msg, 1.0))
                    count += 1
        assert count > 50

    def test_results_of_goals_in_words(self) -> None:
        ends = [json.loads(one["text"]) for one in recording("ros2-actions.jsonl.gz") if one["dir"] == "in"]
        ends = [one for one in ends if one["op"] == "action_result"]
        order, it = PlaceOrder("tb2", at_vertices("1")), adapter()
        found = {
            (one["status"], one["result"]): it.outcome(order, one["values"], one["result"], one["status"])[0]
            for one in ends
        }
        assert found[(4, True)] is Stage.DONE and found[(5, True)] is Stage.FAILED
        assert found[(6, True)] is Stage.FAILED and found[(0, False)] is Stage.REFUSED

    def test_a_goal_leaves_as_the_recorded_client_sent_it(self) -> None:
        sent = [json.loads(one["text"]) for one in recording("ros2-actions.jsonl.gz") if one["dir"] == "out"]
        first = next(one for one in sent if one["op"] == "send_action_goal")
        stop = Stop(pose=Pose(8.0, 3.0))
        (goal,) = adapter().outgoing(PlaceOrder("tb2", (stop,)), 1, robot())
        assert goal == ActionGoal(first["action"], first["action_type"], first["args"])


HEADER = {"stamp": {"sec": 1, "nanosec": 2}, "frame_id": "map"}
TURN = {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}
PLACE = {"position": {"x": 1.0, "y": 2.0, "z": 0.0}, "orientation": TURN}
LOCATED = {"header": HEADER, "pose": {"pose": PLACE, "covariance": [0.1] * 36}}


def status(uuid: object = UUID, state: object = 2) -> dict[str, Any]:
    return {"goal_info": {"goal_id": {"uuid": uuid}, "stamp": {"sec": 1, "nanosec": 0}}, "status": state}


class TestBadMessages:
    @pytest.mark.parametrize(
        ("key", "message", "named"),
        [
            ("odometry", {"header": HEADER}, "pose"),
            (
                "odometry",
                {**LOCATED, "pose": {"pose": {**PLACE, "position": {"x": 1e12, "y": 0}}}},
                "position",
            ),
            (
                "pose",
                {**LOCATED, "pose": {"pose": {**PLACE, "orientation": dict.fromkeys("xyzw", 0)}}},
                "orientation",
            ),
            ("pose", {**LOCATED, "header": {"stamp": 7, "frame_id": "map"}}, "stamp"),
            ("battery", {}, "percentage"),
            ("battery", {"percentage": "full"}, "percentage"),
            ("battery", {"percentage": -0.5}, "percentage"),
            ("battery", {"percentage": 140.0}, "percentage"),
            ("blocked", {"polygon_name": "x"}, "action_type"),
            ("navigate_to_pose", {"status_list": 7}, "status_list"),
            ("navigate_to_pose feedback", {"goal_id": {"uuid": "short"}, "feedback": {}}, "uuid"),
            ("navigate_to_pose feedback", {"feedback": {}}, "goal_id"),
            ("navigate_to_pose feedback", {"goal_id": {"uuid": ZERO}, "feedback": {}}, "uuid"),
            ("plan", {"poses": [{"pose": {}}]}, "position"),
        ],
    )
    def test_are_refused_with_the_field_that_is_wrong(
        self, key: str, message: dict[str, Any], named: str
    ) -> None:
        with pytest.raises(WireError, match=named):
            read(adapter(), key, message)

    def test_one_bad_goal_costs_no_other_and_is_named(self) -> None:
        message = {"status_list": [status(), status("AAAA"), {"status": 2}, status(state="on")]}
        (fact,) = read(adapter(), "navigate_to_pose", message)
        assert isinstance(fact, GoalsReported)
        assert [goal.uuid for goal in fact.goals] == [UUID] and "status_list[2]" in fact.fault

    def test_an_unknown_status_stays_as_it_is(self) -> None:
        (fact,) = read(adapter(), "navigate_to_pose", {"status_list": [status(state=9)]})
        assert isinstance(fact, GoalsReported)
        assert (fact.goals[0].state, fact.goals[0].word) == (None, "status 9")


class TestNotANumber:
    @pytest.mark.parametrize("word", ["null", "NaN"])
    def test_a_battery_that_is_not_measured_says_so(self, word: str) -> None:
        frame = f'{{"op":"publish","topic":"/t","msg":{{"voltage":12.0,"percentage":{word}}}}}'
        assert read(adapter(), "battery", frame) == [Unmeasured("tb2", 5.0, "battery")]

    def test_a_covariance_of_bare_nan_costs_no_pose(self) -> None:
        frame = json.dumps({"op": "publish", "topic": "/t", "msg": LOCATED}).replace("0.1", "NaN")
        (fact,) = read(adapter(), "pose", frame)
        assert isinstance(fact, LocalisationReported) and fact.variance is None
        assert fact.pose == Pose(1.0, 2.0)

    def test_a_place_of_nan_is_none(self) -> None:
        message = {**LOCATED, "pose": {"pose": {**PLACE, "position": {"x": math.nan, "y": 0.0, "z": 0.0}}}}
        with pytest.raises(WireError, match="position"):
            read(adapter(), "odometry", message)


@pytest.mark.parametrize(
    ("scales", "told", "percent", "is_raw"),
    [
        ({}, 0.5, 0.5, True),
        ({}, 50.0, 50.0, True),
        ({"battery": 100.0}, 0.5, 50.0, False),
        ({"battery": 1.0}, 50.0, 50.0, False),
    ],
)
def test_the_scale_of_a_battery(scales: dict[str, float], told: float, percent: float, is_raw: bool) -> None:
    (fact,) = read(adapter(scales=scales), "battery", {"percentage": told})
    assert fact == BatteryReported("tb2", 5.0, percent, is_raw)


def test_what_blocks_a_floor_and_a_path() -> None:
    it = adapter(topics={"floor": "/{robot}/floor"})
    stop = {"action_type": 1, "polygon_name": "front"}
    assert read(it, "blocked", stop) == [BlockedReported("tb2", 5.0, "stop", "front")]
    assert read(it, "blocked", {"action_type": 0}) == [BlockedReported("tb2", 5.0, "", "")]
    assert read(it, "blocked", {"action_type": 9}) == [BlockedReported("tb2", 5.0, "action 9", "")]
    assert read(it, "floor", {"data": "/hall"}) == [FloorReported("tb2", 5.0, "hall")]
    path = {"header": HEADER, "poses": [{"pose": {}}, {"header": HEADER, "pose": PLACE}]}
    assert read(it, "plan", path) == [PlanReported("tb2", 5.0, Pose(1.0, 2.0))]
    assert read(it, "plan", {"poses": []}) == []


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
        assert [call.address.split("/")[2] for call in calls] == [
            "follow_waypoints",
            "navigate_to_pose",
            "dock_robot",
        ]
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
        for command, words in [
            (PlaceOrder("tb2", at_vertices("9")), "vertex 9"),
            (PlaceOrder("tb2", ()), "a destination"),
        ]:
            with pytest.raises(CommandError, match=words):
                adapter().outgoing(command, 1, robot())
        lacking = adapter(actions={"follow_waypoints": ""})
        with pytest.raises(CommandError, match=r"\[profile.actions\] follow_waypoints is empty"):
            lacking.outgoing(PlaceOrder("tb2", at_vertices("1", "2")), 1, robot())


class TestPauses:
    def test_hold_is_what_stands_in(self) -> None:
        assert adapter().kind.holds and adapter().kind.can(kind.PAUSE)

    def test_a_lock_is_published(self) -> None:
        it = adapter(topics={"pause_navigation": "/{robot}/lock"}, settings={"nav2": {"pause": "lock"}})
        assert not it.kind.holds and it.kind.can(kind.PAUSE)
        said = [it.outgoing(one, 1, robot()) for one in (PauseRobot("tb2"), ResumeRobot("tb2"))]
        assert said == [
            (Publication("/tb2/lock", "std_msgs/Bool", {"data": True}),),
            (Publication("/tb2/lock", "std_msgs/Bool", {"data": False}),),
        ]

    def test_two_services_come_before_hold(self) -> None:
        it = adapter(services={"pause": "/{robot}/hold", "resume": "/{robot}/go"})
        assert not it.kind.holds
        assert it.outgoing(PauseRobot("tb2"), 1, robot()) == (
            ServiceCall("/tb2/hold", "std_srvs/Trigger", {}),
        )

    def test_without_any_this_kind_has_no_pause(self) -> None:
        it = adapter(settings={"nav2": {"pause": ""}})
        assert not it.kind.can(kind.PAUSE) and it.kind.lack(kind.PAUSE) == "this kind has no pause"


class TestAnswers:
    @pytest.mark.parametrize(
        ("values", "result", "stage"),
        [
            ({"return_code": 0, "goals_canceling": []}, True, Stage.ACCEPTED),
            ({"return_code": 1}, True, Stage.REFUSED),
            ({"return_code": 2}, True, Stage.REFUSED),
            ({"return_code": 3}, True, Stage.ACCEPTED),
            ({}, True, Stage.UNKNOWN),
            ("Service /x does not exist", False, Stage.REFUSED),
            ("Timeout exceeded while waiting for service response", False, Stage.UNKNOWN),
        ],
    )
    def test_of_a_cancel(self, values: object, result: bool, stage: Stage) -> None:
        assert adapter().outcome(CancelOrder("tb2", "x"), values, result)[0] is stage

    @pytest.mark.parametrize(
        ("values", "result", "stage"),
        [
            ({"return_code": 2}, True, Stage.ACCEPTED),
            ("Service /x does not exist", False, Stage.ACCEPTED),
            ("Timeout exceeded while waiting for service response", False, Stage.UNKNOWN),
        ],
    )
    def test_of_a_pause_of_a_robot_without_goals(self, values: object, result: bool, stage: Stage) -> None:
        assert adapter().outcome(PauseRobot("tb2"), values, result)[0] is stage

    @pytest.mark.parametrize(
        ("values", "status", "stage", "words"),
        [
            ({}, 4, Stage.DONE, ""),
            ({"missed_waypoints": []}, 4, Stage.DONE, ""),
            ({"missed_waypoints": [1]}, 4, Stage.FAILED, "1 stops missed"),
            ({"error_code": 208, "error_msg": ""}, 6, Stage.FAILED, "error 208 (no path to the goal)"),
            ({"error_code": 9001, "error_msg": "x"}, 6, Stage.FAILED, "error 9001 (navigator failed): x"),
            ({"error_code": 77}, 6, Stage.FAILED, "error 77"),
            ("broken", 6, Stage.FAILED, ""),
        ],
    )
    def test_of_a_goal(self, values: object, status: int, stage: Stage, words: str) -> None:
        order = PlaceOrder("tb2", at_vertices("1"))
        assert adapter().outcome(order, values, True, status) == (stage, words)


def test_names_at_another_site() -> None:
    it = adapter(
        topics={"odometry": "/fleet/{robot}/wheels", "blocked": ""},
        actions={"navigate_to_pose": "/{robot}/nav/go", "dock_robot": ""},
    )
    addresses = [feed.address for feed in it.feeds("tb2", ("hall",))]
    assert "/fleet/tb2/wheels" in addresses and "/tb2/nav/go/_action/status" in addresses
    assert not any("collision" in one or "/dock_robot" in one for one in addresses)
    assert "blocked" not in it.kind.reports


def test_without_odometry_a_pose_never_ages_by_itself() -> None:
    assert adapter(topics={"odometry": ""}).kind.silence_of("pose", 5.0) == math.inf
    assert adapter().kind.silence_of("pose", 5.0) == 5.0
