"""A real Nav2 behind a real bridge, as recorded: what the console knows of it."""

import math

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
