"""Feedback, or the list of goals, that ceases although the robot reports: its navigation crashed."""

from msgspec.structs import replace

from fleet_tui.cli.status.report import attention
from fleet_tui.model.events import Event, TimePassed
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation import Progress
from fleet_tui.model.navigation_events import OdometryReported, ProgressReported
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.facts import NAVIGATION_SILENT
from fleet_tui.situation.navigation import CEASED_AFTER, silent_navigation
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.tables.news import news
from tests.support.fleets import R0, T0, WALL, fleet, link_lost, link_up, pose, queue, reduced, tick
from tests.support.legs import goal as goal_of
from tests.support.legs import goals, lived, sent, site

LATER = T0 + 5 + CEASED_AFTER


def driving(*facts: Event, goal: str = "7") -> FleetState:
    """A robot that gave feedback on an order for five seconds, and then these facts, seen later."""
    feedback = ProgressReported(R0, T0 + 5, Progress(goal))
    return reduced(fleet(), link_up(T0), queue(T0, (7, 1, 2, "W"), current=7), feedback, *facts, tick(LATER))


def found_in(state: FleetState) -> Fact | None:
    return silent_navigation(state, state.robots[R0])


def ceased(state: FleetState) -> float | None:
    fact = found_in(state)
    return fact.since if fact is not None else None


def test_a_robot_that_reports_without_feedback_has_silent_navigation_since_the_last() -> None:
    state = driving(pose(LATER))
    assert ceased(state) == T0 + 5
    assert ceased(replace(state, now=LATER - 0.1, began={})) is None
    assert {alarm.key for alarm in state.alarms} == {(R0, "navigation")}, "and this explains why it stands"


def test_silence_with_another_cause_is_none_of_its_navigation() -> None:
    assert ceased(driving()) is None, "the robot is offline"
    assert ceased(driving(pose(LATER), link_lost(LATER))) is None
    assert ceased(driving(link_lost(LATER - 2), link_up(LATER - 1), pose(LATER))) is None
    assert ceased(driving(pose(LATER), goal="6")) is None, "never any on this order"
    assert ceased(driving(pose(LATER), queue(LATER))) is None, "no order"


def test_a_server_that_crashes_with_each_order_is_one_alarm_until_the_robot_moves() -> None:
    silent = driving(pose(LATER))
    # A new order, a moment of feedback on it: it stands as before.
    answers = ProgressReported(R0, LATER + 6, Progress("8"))
    again = reduced(
        silent, queue(LATER + 5, (8, 1, 2, "W"), current=8), answers, pose(LATER + 6), tick(LATER + 6)
    )
    (alarm,) = again.alarms
    assert alarm.holds and alarm.count == 1
    assert alarm.text.startswith("navigation repeatedly silent, no movement for ")
    assert "answers each order for a moment" in reasons(again, again.robots[R0])[0].evidence
    drives = reduced(again, pose(LATER + 7, x=3.0), tick(LATER + 7), pose(LATER + 8, x=6.0), tick(LATER + 8))
    assert (found_in(drives) is None and not drives.alarms[0].holds) or not drives.alarms
    gone = reduced(
        again, queue(LATER + 7), pose(LATER + 7), tick(LATER + 20), pose(LATER + 20), tick(LATER + 30)
    )
    assert all(one.condition.kind != "navigation" or not one.holds for one in gone.alarms)


def test_a_move_base_that_lists_no_goals_any_more_is_told_everywhere_within_ten_seconds() -> None:
    """It lists them five times a second; its wheels and its localisation go on."""
    state = lived(sent(site(), T0 + 1, "goal---1"), T0 + 1.2, goal_of("goal---1"))
    state = reduced(state, goals(T0 + 2, goal_of("goal---1")), tick(T0 + 2))
    for tenth in range(1, 100):
        at = T0 + 2 + tenth / 10
        turned = OdometryReported(R0, at, Pose(0.0, 0.0), at)
        state = reduced(state, turned, TimePassed(at, WALL + at))
        if tenth == 40:
            assert found_in(state) is None
    fact = found_in(state)
    assert fact is not None and fact.kind is NAVIGATION_SILENT and "move_base" in fact.action
    assert next(text for text, _ in news(state, state.robots[R0])) == "navigation silent"
    (alarm,) = [one.condition for one in state.alarms if one.holds]
    assert (alarm.text, alarm.remedy) == (fact.text, fact.action)
    why = reasons(state, state.robots[R0])[0]
    assert (why.name, why.remedy) == ("navigation silent", fact.action)
    assert f"{R0}: {fact.text}" in attention(state)
