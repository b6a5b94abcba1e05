"""Messages of navigating robots, as bridges of both dialects write them."""

from typing import Any

import msgspec
import pytest

from fleet_tui.robots.ros import navigation


def read(text: str, kind: Any) -> Any:
    return msgspec.json.decode(text, type=kind)


def test_a_place_without_a_known_covariance_is_read() -> None:
    pose = '{"position": {"x": 1, "y": 2, "z": 0}, "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}'
    for covariance, numbers in (("[null, 0.5]", [None, 0.5]), ("[]", [])):
        text = f'{{"header": {{"frame_id": "map"}}, "pose": {{"pose": {pose}, "covariance": {covariance}}}}}'
        found = read(text, navigation.Located)
        assert (found.pose.covariance, found.pose.pose.position.x) == (numbers, 1.0)
    assert read(f'{{"pose": {pose}}}', navigation.PoseWithCovariance).covariance == []


def test_feedback_of_each_action_has_some_of_the_fields() -> None:
    goal = '"goal_id": {"uuid": "AAAA"}'
    to_pose = (
        '{"distance_remaining": 4.5, "estimated_time_remaining": {"sec": 3, "nanosec": 250000000},'
        ' "number_of_recoveries": 1, "unknown": 7}'
    )
    found = read(f'{{{goal}, "feedback": {to_pose}}}', navigation.FeedbackMessage).feedback
    assert (found.distance_remaining, found.number_of_recoveries) == (4.5, 1)
    assert found.estimated_time_remaining.seconds == pytest.approx(3.25)
    assert (found.current_waypoint, found.navigation_time) == (None, None)
    tour = read(f'{{{goal}, "feedback": {{"current_waypoint": 2}}}}', navigation.FeedbackMessage).feedback
    assert (tour.current_waypoint, tour.distance_remaining) == (2, None)


def test_one_bad_goal_of_a_list_does_not_cost_the_others() -> None:
    text = '{"status_list": [{"goal_info": {"goal_id": {"uuid": "AAAA"}}, "status": 2}, {"goal_info": 7}]}'
    good, bad = read(text, navigation.GoalStatusArray).status_list
    assert msgspec.convert(good, navigation.GoalStatus).status == 2
    with pytest.raises(msgspec.ValidationError):
        msgspec.convert(bad, navigation.GoalStatus)


def test_a_battery_that_is_not_measured_is_not_an_empty_one() -> None:
    assert read('{"percentage": null}', navigation.BatteryState).percentage is None
    with pytest.raises(msgspec.ValidationError):
        read("{}", navigation.BatteryState)
