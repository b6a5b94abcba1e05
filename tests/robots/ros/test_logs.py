"""/rosout and /diagnostics of both ROS, however a bridge writes them."""

import json

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.ros_logs import Health, Severity
from fleet_tui.robots.ros.logs import (
    LONGEST_TEXT,
    MOST_PARTS,
    MOST_VALUES,
    RobotNames,
    byte,
    diagnosed_errors,
    diagnoses,
    log_line,
    logged_errors,
    not_allowed,
)
from fleet_tui.text.errors import WireError
from tests.support.fleets import T0
from tests.support.transcripts import frames, parsed, recording

ROS1_LOG = {
    "header": {"seq": 7, "stamp": {"secs": 1, "nsecs": 2}, "frame_id": ""},
    "level": 4,
    "name": "/robot_0/base",
    "msg": "wheel slips",
    "file": "base.cpp",
    "function": "spin",
    "line": 12,
    "topics": ["/rosout"],
}
ROS2_LOG = {
    "stamp": {"sec": 1, "nanosec": 2},
    "level": 30,
    "name": "robot_0.base",
    "msg": "wheel slips",
    "file": "base.cpp",
    "function": "spin",
    "line": 12,
}


def wire(msg: object) -> msgspec.Raw:
    return msgspec.Raw(json.dumps(msg).encode())


@pytest.mark.parametrize("msg", [ROS1_LOG, ROS2_LOG])
def test_a_line_of_either_ros(msg: dict[str, object]) -> None:
    line = log_line(wire(msg), T0)
    assert (line.severity, line.text, line.at) == (Severity.WARN, "wheel slips", T0)
    assert "base" in line.node
    assert log_line(msg, T0) == line  # as it comes from CBOR
    assert line.stamp == 1.000000002


def test_a_line_without_a_stamp_has_none() -> None:
    assert log_line({"level": 2, "name": "/a", "msg": "b"}, T0).stamp is None


@pytest.mark.parametrize(
    ("levels", "severities"),
    [
        ((1, 2, 4, 8, 16), tuple(Severity)),
        ((10, 20, 30, 40, 50), tuple(Severity)),
        ((0, 3, 25, -1, 255), (None,) * 5),
    ],
)
def test_levels_of_either_ros(levels: tuple[int, ...], severities: tuple[Severity | None, ...]) -> None:
    assert tuple(log_line({**ROS1_LOG, "level": one}, T0).severity for one in levels) == severities


def status(level: object, **more: object) -> dict[str, object]:
    return {"level": level, "name": "battery", "message": "low", "hardware_id": "b1", **more}


@pytest.mark.parametrize("level", [2, "Ag==", [2], "\x02", "2"])
def test_the_byte_of_a_level_in_every_spelling(level: object) -> None:
    values = [{"key": "voltage", "value": "21.3"}]
    (found,) = diagnoses(wire({"header": {}, "status": [status(level, values=values)]}), T0)
    assert found.level == Health.ERROR
    assert (found.name, found.message, found.hardware) == ("battery", "low", "b1")
    assert found.values == (("voltage", "21.3"),)


@pytest.mark.parametrize("level", ["", "nonsense", [], [1, 2], "AgI="])
def test_what_is_no_byte_is_refused_by_name(level: object) -> None:
    with pytest.raises(WireError, match="level"):
        diagnoses(wire({"status": [status(level)]}), T0)


@given(st.binary(min_size=1, max_size=1))
def test_any_byte_comes_back_from_base64(value: bytes) -> None:
    import base64

    assert byte(base64.b64encode(value).decode()) == value[0]


@pytest.mark.parametrize("msg", [{}, {"level": "x", "name": "n", "msg": "m"}, [], None, {"status": [1]}])
def test_anything_else_is_refused(msg: object) -> None:
    for read in (log_line, diagnoses):
        with pytest.raises(WireError):
            read(wire(msg), T0)


def test_what_is_too_long_is_cut() -> None:
    line = log_line(wire({**ROS1_LOG, "msg": "x" * 100_000}), T0)
    assert len(line.text) < LONGEST_TEXT + 50 and "100,000 characters" in line.text
    many = [{"key": str(n), "value": "v" * 600} for n in range(MOST_VALUES + 5)]
    found = diagnoses(wire({"status": [status(0, values=many), *[status(0)] * (MOST_PARTS + 3)]}), T0)
    assert len(found) == MOST_PARTS and len(found[0].values) == MOST_VALUES
    assert len(found[0].values[0][1]) < 560


SEVERAL = RobotNames(["robot_1", "robot_10"])


@pytest.mark.parametrize(
    ("node", "level", "msg", "found"),
    [
        ("/robot_10/move_base", 8, "No valid control found.", [("robot_10", "No valid control found")]),
        (
            "robot_1.bt_navigator",
            40,
            "Goal failed error_code:105 error_msg:Failed to make progress.",
            [("robot_1", "Failed to make progress (error 105)")],
        ),
        ("/robot_1/move_base", 4, "wheel slips", []),
        ("/rosbridge", 8, "of the bridge itself", []),
        ("/robot_100/move_base", 8, "of another robot", []),
    ],
)
def test_an_error_of_the_log_is_that_of_the_robot_whose_node_wrote_it(
    node: str, level: int, msg: str, found: list[tuple[str, str]]
) -> None:
    line = log_line(wire({**ROS1_LOG, "name": node, "level": level, "msg": msg}), T0)
    assert [(one.robot, one.text) for one in logged_errors(line, SEVERAL)] == found
    alone = [one.text for one in logged_errors(line, RobotNames(["agv"]))]
    assert len(alone) == (level != 4 and node != "/rosbridge")


@pytest.mark.parametrize(
    ("node", "level", "msg", "is_told"),
    [
        ("planner_server", 30, "GridBased plugin failed to plan", True),
        ("bt_navigator_navigate_to_pose_rclcpp_node", 30, "Timed out while waiting", True),
        ("robot_1.controller_server", 30, "Control loop missed its desired rate of 20.0000 Hz", False),
        ("bt_navigator", 40, "Goal failed", False),
        ("bt_navigator", 30, "[navigate_to_pose] [ActionServer] Aborting handle.", False),
        ("slam_toolbox", 30, "New subscription discovered", False),
        ("rosbridge_websocket", 40, "[Client 44] call_service: /rosapi/x does not exist", False),
        ("rosapi", 40, "Timeout exceeded", False),
        ("/rosapi_params", 40, "Timeout exceeded", False),
    ],
)
def test_of_navigation_warnings_count_too_and_of_the_bridge_and_of_what_follows_nothing(
    node: str, level: int, msg: str, is_told: bool
) -> None:
    line = log_line(wire({**ROS2_LOG, "name": node, "level": level, "msg": msg}), T0)
    found = [*logged_errors(line, RobotNames(["robot_1"]))]
    assert [one.is_warning for one in found] == ([level == 30] if is_told else [])


def test_only_errors_of_the_diagnostics_are_told_with_their_part() -> None:
    parts = [status(level, name=f"robot_1: part {level}") for level in range(4)]
    found = diagnosed_errors(diagnoses(wire({"header": {}, "status": parts}), T0), SEVERAL)
    assert [(one.robot, one.text, one.is_diagnosed) for one in found] == [("robot_1", "part 2: low", True)]


def test_a_bridge_tells_in_its_log_which_topics_and_services_its_allow_lists_lack() -> None:
    lines = [
        frame["msg"]
        for frame in map(parsed, frames(recording("ros2-globs.jsonl.gz"), "in"))
        if "msg" in frame
    ]
    logged = [log_line(msgspec.Raw(json.dumps(msg)), T0) for msg in lines if "level" in msg]
    assert [name for line in logged if (name := not_allowed(line, "topic"))] == ["/s0/pose"]
    pause = "/robot_1/Application_layout/Pause"
    assert [name for line in logged if (name := not_allowed(line, "service"))] == [pause]
