"""Feedback that ceases although the robot reports: its navigation crashed."""

from msgspec.structs import replace

from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.navigation import Progress
from fleet_tui.model.navigation_events import ProgressReported
from fleet_tui.rules.feedback import CEASED_AFTER, feedback_ceased_at, is_unsteady
from fleet_tui.rules.why.navigation import silent as why_silent
from tests.support.fleets import R0, T0, fleet, link_lost, link_up, pose, queue, reduced, tick

LATER = T0 + 5 + CEASED_AFTER


def driving(*facts: Event, goal: str = "7") -> FleetState:
    """A robot that gave feedback on an order for five seconds, and then these facts, seen later."""
    feedback = ProgressReported(R0, T0 + 5, Progress(goal))
    return reduced(fleet(), link_up(T0), queue(T0, (7, 1, 2, "W"), current=7), feedback, *facts, tick(LATER))


def ceased(state: FleetState) -> float | None:
    return feedback_ceased_at(state, state.robots[R0])


def test_a_robot_that_reports_without_feedback_has_silent_navigation_since_the_last() -> None:
    state = driving(pose(LATER))
    assert ceased(state) == T0 + 5
    assert ceased(replace(state, now=LATER - 0.1)) is None
    assert {alarm.key for alarm in state.alarms} == {(R0, "navigation")}, "and this explains why it stands"


def test_silence_with_another_cause_is_none_of_its_navigation() -> None:
    assert ceased(driving()) is None, "the robot is offline"
    assert ceased(driving(pose(LATER), link_lost(LATER))) is None
    assert ceased(driving(link_lost(LATER - 2), link_up(LATER - 1), pose(LATER))) is None
    assert ceased(driving(pose(LATER), goal="6")) is None, "never any on this order"
    assert ceased(driving(pose(LATER), queue(LATER))) is None, "no order"


def test_a_server_that_crashes_with_each_order_is_one_alarm_until_the_robot_moves() -> None:
    silent = driving(pose(LATER))
    assert not is_unsteady(fleet(), fleet().robots[R0])
    # A new order, a moment of feedback on it: it stands as before.
    answers = ProgressReported(R0, LATER + 6, Progress("8"))
    again = reduced(
        silent, queue(LATER + 5, (8, 1, 2, "W"), current=8), answers, pose(LATER + 6), tick(LATER + 6)
    )
    (alarm,) = again.alarms
    assert ceased(again) is None and alarm.holds and alarm.count == 1
    assert alarm.text.startswith("navigation silent again and again, no movement for ")
    found = why_silent(again, again.robots[R0])
    assert found is not None and found.name == "navigation silent again and again"
    drives = reduced(again, pose(LATER + 7, x=3.0), tick(LATER + 7), pose(LATER + 8, x=6.0), tick(LATER + 8))
    assert (not is_unsteady(drives, drives.robots[R0]) and not drives.alarms[0].holds) or not drives.alarms
    gone = reduced(
        again, queue(LATER + 7), pose(LATER + 7), tick(LATER + 20), pose(LATER + 20), tick(LATER + 30)
    )
    assert all(one.condition.kind != "navigation" or not one.holds for one in gone.alarms)
