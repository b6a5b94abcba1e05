"""Messages of robots with Nav2 as facts: what recordings of a real bridge tell, and what is refused."""

import json
import math
from typing import Any

import pytest

from fleet_tui.model.commands import PlaceOrder, Stage
from fleet_tui.model.events import BatteryReported
from fleet_tui.model.geometry import Pose
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
from fleet_tui.robots.adapter import ActionGoal
from fleet_tui.robots.ros.operations import Publish, decode
from fleet_tui.text.errors import WireError
from tests.support.fleets import recording
from tests.support.nav2_adapter import UUID, ZERO, adapter, read, robot


def came(name: str, topic: str) -> list[str]:
    """The frames of a topic in a recording."""
    frames = [one["text"] for one in recording(f"{name}.jsonl.gz") if one["dir"] == "in" and "text" in one]
    found = [frame for frame in frames if json.loads(_strict(frame)).get("topic") == topic]
    assert found, topic
    return found


def _strict(frame: str) -> str:
    return frame.replace("NaN", "null")


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
                feed = mine.get(operation.topic)
                if feed is not None and not feed.large and feed.wanted_for not in ("place", "stream"):
                    assert list(it.read(feed, operation.msg, 1.0))
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
