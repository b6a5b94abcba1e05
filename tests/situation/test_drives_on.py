"""A robot that drives on after its order failed."""

import pytest
from msgspec.structs import replace

from fleet_tui.cli.status.report import attention
from fleet_tui.model.events import TimePassed
from fleet_tui.model.fleet import FleetState
from fleet_tui.situation.facts import DRIVES_ON
from fleet_tui.situation.robots import drives_on
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.tables.news import failed_command
from tests.support.fleets import R0, T0, WALL, reduced
from tests.support.nav2_goals import FAILED, ON, goal, goals, localised, nav2, odometry


def after_abort(seconds: float, metres_per_s: float, another: bool = False) -> FleetState:
    """A robot so many seconds after its goal was aborted, which drives on."""
    state = reduced(nav2(), localised(T0, 0.0), goals(T0, goal("77", ON)))
    x = 0.0
    for tenth in range(round(seconds * 10) + 50):
        at = T0 + tenth / 10
        x += (1.0 if tenth < 50 else metres_per_s) / 10
        state = reduced(state, odometry(at, x), localised(at, x), TimePassed(at, WALL + at))
        if tenth == 50:
            state = reduced(state, goals(at, goal("77", FAILED), *([goal("78", ON)] if another else [])))
    return state


def test_it_is_told_in_row_alarm_and_reason_with_the_pause_that_ends_it() -> None:
    state = after_abort(6.0, 0.5)
    robot = state.robots[R0]
    fact = drives_on(state, robot)
    assert fact is not None and fact.kind is DRIVES_ON
    assert [text for text, _ in failed_command(state, robot, short=True)] == [fact.text]
    (alarm,) = [one for one in state.alarms if one.holds]
    assert alarm.condition.remedy == fact.action == "Pause it: that stops whatever still drives it"
    (why,) = [one for one in reasons(state, robot) if one.name == fact.text]
    assert (why.remedy, why.keys[0]) == (fact.action, "pause")
    assert any("failed" in line for line in attention(state))


@pytest.mark.parametrize(
    ("seconds", "metres_per_s", "another"),
    [(6.0, 0.0, False), (2.0, 0.5, False), (6.0, 0.5, True), (80.0, 0.5, False)],
)
def test_one_that_stands_brakes_has_another_order_or_moves_long_after_does_not(
    seconds: float, metres_per_s: float, another: bool
) -> None:
    state = after_abort(seconds, metres_per_s, another)
    assert drives_on(state, state.robots[R0]) is None


def test_a_kind_whose_orders_are_no_goals_of_its_navigation_has_no_such_fact() -> None:
    state = after_abort(6.0, 0.5)
    robot = state.robots[R0]
    other = replace(robot, kind=replace(robot.kind, keeps_goals=False))
    assert drives_on(state, other) is None
