"""Feedback that ceases although the robot reports: its navigation crashed."""

from msgspec.structs import replace

from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.navigation import Progress
from fleet_tui.model.navigation_events import ProgressReported
from fleet_tui.rules.feedback import CEASED_AFTER, feedback_ceased_at
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
