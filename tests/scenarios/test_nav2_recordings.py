"""A real Nav2 behind a real bridge, as recorded: what the console knows of it."""

import math

import pytest

from fleet_tui.cli.status.report import attention
from fleet_tui.model.commands import Stage
from fleet_tui.situation.activity import activities
from fleet_tui.situation.causes import cause_of_end
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.tables.doing import state_texts
from tests.support.fleets import R0
from tests.support.nav2_recordings import replayed


def test_a_robot_that_only_its_transforms_place_is_where_its_feedback_says_too() -> None:
    compared = 0
    for _, frame, state in replayed("tf-only-goto", pose=""):
        robot = state.robots[R0]
        if frame.get("topic") != "/navigate_to_pose/_action/feedback" or robot.pose is None:
            continue
        here = frame["msg"]["feedback"]["current_pose"]["pose"]["position"]
        # Recorded with transforms each two seconds, of a robot that drives up to 0.3 m/s and turns.
        assert math.dist((robot.pose.value.x, robot.pose.value.y), (here["x"], here["y"])) < 0.8
        assert robot.located_by == "transforms" and robot.frame_id == "map"
        compared += 1
    assert compared > 5


def test_without_transforms_the_feedback_tells_where_a_robot_is() -> None:
    placed = [
        state.robots[R0].pose
        for _, frame, state in replayed("tf-only-goto", pose="", tf="", tf_static="")
        if frame.get("topic") == "/navigate_to_pose/_action/feedback"
    ]
    assert len(placed) > 5 and all(placed)


@pytest.mark.parametrize(
    ("name", "causes"),
    [
        ("order-wall", ["Controller patience exceeded", "GridBased plugin failed to plan from (0.40, 0.16)"]),
        ("kill-controller2", ["CRITICAL FAILURE: SERVER controller_server IS DOWN after not receiving"]),
        ("lifecycle-pause-mid", ["Requested to deactivate server but goal is still executing"]),
        ("cancel-midway", ["Timed out while waiting for action server to acknowledge goal request"]),
        ("robot-frozen", ["Failed to transform end pose to global frame"]),
    ],
)
def test_the_log_tells_why_an_order_failed_whose_end_has_no_reason(name: str, causes: list[str]) -> None:
    *_, (_, _, state) = replayed(name)
    robot = state.robots[R0]
    failed = [one for one in robot.gone if one.stage is Stage.FAILED][: len(causes)]
    for gone, cause in zip(failed, causes, strict=True):
        assert cause in cause_of_end(robot, gone)


@pytest.mark.parametrize("name", ["lifecycle-pause-mid", "kill-controller2", "robot-frozen"])
def test_what_the_bridge_logs_is_of_no_robot(name: str) -> None:
    """Errors of the heartbeat of earlier consoles are in these recordings."""
    *_, (_, _, state) = replayed(name)
    logged = state.robots[R0].logged
    assert logged and not [line for line in logged if "[Client" in line.text]


@pytest.mark.parametrize(
    ("name", "row", "why", "status"),
    [
        (
            "cancel-midway",
            "order failed, still driving",
            "order failed, still driving",
            "Timed out while waiting for action server to acknowledge goal request for follow_path",
        ),
        (
            "kill-controller2",
            "Nav2 inactive: controller_server down",
            "Nav2 inactive: controller_server down",
            "Nav2 inactive: controller_server down",
        ),
        (
            "lifecycle-pause-mid",
            "order failed",
            "last order failed: [navigate_to_pose] [ActionServer] Requested to deactivate server",
            "Requested to deactivate server but goal is still executing",
        ),
        ("robot-frozen", "order failed", "blocked", "Failed to transform end pose to global frame"),
    ],
)
def test_row_reason_and_status_of_a_recording(name: str, row: str, why: str, status: str) -> None:
    rows, reasons_, lines = set[str](), set[str](), set[str]()
    for _, _, state in replayed(name):
        robot = state.robots[R0]
        told = state_texts(state, robot, activities(state, [robot]).get(R0), 60)
        rows.add(", ".join(text for text, _ in told))
        reasons_.add(reasons(state, robot)[0].name)
        lines.update(attention(state))
    assert any(row in one for one in rows), rows
    assert any(one.startswith(why) for one in reasons_), reasons_
    assert any(status in one for one in lines), lines
    assert not any("driving, driving" in one for one in rows)
