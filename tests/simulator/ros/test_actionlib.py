"""An action server of ROS 1: newer goals, cancels by id and by stamp, and what stays listed."""

import pytest

from fleet_tui.simulator.move_base.navigation import REACHED
from fleet_tui.simulator.ros.actionlib import (
    ACTIVE,
    KEPT,
    PENDING,
    PREEMPTED,
    PREEMPTING,
    RECALLED,
    RECALLING,
    REPLACED,
    SUCCEEDED,
    TOO_OLD,
)
from tests.support.move_base_navigation import FAR, NEAR, cancelled, finish, goal, results, stand, world


def test_a_newer_goal_preempts() -> None:
    it, navigation = world()
    for id_, spot in (("a", FAR), ("b", NEAR)):
        navigation.receive_goal(goal(id_, spot))
        it.step(2.0)
    assert results(navigation) == [("a", PREEMPTED, REPLACED)]
    assert stand(navigation) == {"a": PREEMPTED, "b": ACTIVE}
    finish(it, navigation)
    assert (navigation.robot.pose.x, navigation.robot.pose.y) == pytest.approx(NEAR)


def test_a_goal_that_still_waits_is_recalled_by_a_newer_one() -> None:
    it, navigation = world()
    for id_ in ("a", "b"):
        navigation.receive_goal(goal(id_))
    assert results(navigation) == [("a", RECALLED, REPLACED)]
    it.step(0.1)
    assert stand(navigation) == {"a": RECALLED, "b": ACTIVE}


def test_a_goal_that_is_older_than_the_current_one_is_recalled() -> None:
    it, navigation = world()
    it.step(10.0)
    navigation.receive_goal(goal("a", secs=9))
    it.step(0.1)
    navigation.receive_goal(goal("b", secs=8))
    assert results(navigation) == [("b", RECALLED, REPLACED)] and stand(navigation)["a"] == ACTIVE


def test_one_goal_is_cancelled_by_its_id() -> None:
    it, navigation = world()
    navigation.receive_goal(goal("a"))
    it.step(1.0)
    navigation.receive_cancel(cancelled("b"))
    it.step(1.0)
    assert stand(navigation) == {"a": ACTIVE, "b": RECALLING}
    navigation.receive_cancel(cancelled("a"))
    assert stand(navigation)["a"] == PREEMPTING
    it.step(0.1)
    assert results(navigation) == [("a", PREEMPTED, "")] and not navigation.robot.driving


def test_without_id_and_stamp_all_goals_are_cancelled() -> None:
    it, navigation = world()
    navigation.receive_goal(goal("a"))
    it.step(1.0)
    navigation.receive_goal(goal("b"))
    navigation.receive_cancel(cancelled())
    it.step(0.2)
    assert {id_ for id_, *_ in results(navigation)} == {"a", "b"} and not navigation.busy


@pytest.mark.parametrize(("secs", "id_", "ended"), [(5, "", False), (20, "", True), (20, "other", True)])
def test_a_stamp_cancels_every_goal_up_to_it_whatever_the_id(secs: int, id_: str, ended: bool) -> None:
    it, navigation = world()
    it.step(10.0)
    navigation.receive_goal(goal("a"))
    it.step(0.1)
    navigation.receive_cancel(cancelled(id_, secs))
    it.step(0.1)
    assert (stand(navigation)["a"] == PREEMPTED) is ended


def test_a_goal_not_later_than_the_last_cancel_is_cancelled_at_once() -> None:
    _, navigation = world()
    navigation.receive_cancel(cancelled(secs=30))
    navigation.receive_goal(goal("old", secs=30))
    assert results(navigation) == [("old", RECALLED, TOO_OLD)]
    navigation.receive_goal(goal("unstamped"))
    navigation.receive_goal(goal("new", secs=31))
    assert stand(navigation)["new"] == PENDING


def test_a_cancel_that_comes_before_its_goal_recalls_it() -> None:
    it, navigation = world()
    navigation.receive_cancel(cancelled("a"))
    it.step(60.0)  # without a stamp it is never forgotten
    assert stand(navigation) == {"a": RECALLING} and not navigation.busy
    navigation.receive_goal(goal("a"))
    assert results(navigation) == [("a", RECALLED, "")]
    it.step(1.0)
    assert not navigation.robot.driving


def test_a_known_id_is_ignored() -> None:
    it, navigation = world()
    for spot in (FAR, NEAR):
        navigation.receive_goal(goal("a", spot))
        it.step(1.0)
    finish(it, navigation)
    assert results(navigation) == [("a", SUCCEEDED, REACHED)]
    navigation.receive_goal(goal("a", NEAR))
    it.step(1.0)
    assert not navigation.busy and not navigation.robot.driving


def test_the_last_goal_stays_listed_and_those_before_it_for_a_while() -> None:
    it, navigation = world()
    navigation.receive_goal(goal("a", NEAR))
    finish(it, navigation)
    it.step(10 * KEPT)
    assert stand(navigation) == {"a": SUCCEEDED}
    navigation.receive_goal(goal("b"))
    it.step(KEPT - 1.0)
    assert stand(navigation) == {"a": SUCCEEDED, "b": ACTIVE}
    it.step(2.0)
    assert stand(navigation) == {"b": ACTIVE}
