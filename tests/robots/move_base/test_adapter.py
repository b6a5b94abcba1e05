"""Robots with move_base under the names of their site: what is listened to, and what is published."""

from fleet_tui.model import kind
from tests.support.move_base_adapter import adapter, feeds


def test_goals_and_cancels_are_published_and_nothing_is_called() -> None:
    assert dict(adapter().publications("r1")) == {
        "/r1/move_base/goal": "move_base_msgs/MoveBaseActionGoal",
        "/r1/move_base/cancel": "actionlib_msgs/GoalID",
    }
    assert not list(adapter().services("r1"))


def test_topics_are_those_of_the_profile_and_an_empty_one_is_none() -> None:
    found = feeds(adapter(topics={"odometry": "/fleet/{robot}/wheels", "battery": ""}))
    assert found["odometry"].address == "/fleet/r1/wheels"
    assert "battery" not in found and "status" in found


def test_such_robots_take_one_stop_at_a_time_and_a_pause_keeps_their_goal() -> None:
    its = adapter().kind
    assert its.gives_stops and its.keeps_goals and its.holds
    assert its.can(kind.ORDER) and its.can(kind.PAUSE)
    assert not adapter(settings={"move_base": {"pause": ""}}).kind.can(kind.PAUSE)
