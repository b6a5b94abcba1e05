"""The error that a robot reports about itself is the cause of its end of an order, if it came just then."""

import pytest
from msgspec.structs import replace

from fleet_tui.model.commands import Baseline, CommandRecord, Stage
from fleet_tui.model.fleet import with_robot
from fleet_tui.model.navigation import Goal
from fleet_tui.model.order import Order, OrderState
from fleet_tui.model.order_life import UNSAID, GoneOrder
from fleet_tui.model.robot import Logged
from fleet_tui.situation.alarms.navigation import failed_order
from fleet_tui.situation.causes import cause_of_end, wants_causes
from fleet_tui.situation.why.why import reasons
from fleet_tui.text.language import Message
from tests.support.fleets import R0, T0, WALL, fleet, link_up, place_order, pose, queue, reduced, tick
from tests.support.nav2_goals import goal, goals, nav2

STATE = reduced(fleet(), link_up(T0), pose(T0), queue(T0), tick(T0 + 2))
FAILED = GoneOrder(Order("7f3a99c0", (), None, "", 1), T0, Stage.FAILED, UNSAID)


@pytest.mark.parametrize(
    ("logged_at", "cause"), [(T0 + 1, "no valid control"), (T0 - 1, "no valid control"), (T0 - 9, "")]
)
def test_an_end_without_a_reason_has_the_error_that_the_log_had_just_then(
    logged_at: float, cause: str
) -> None:
    robot = replace(
        STATE.robots[R0], gone=(FAILED,), logged=(Logged(Message("no valid control"), logged_at),)
    )
    assert cause_of_end(robot, FAILED) == cause
    condition = failed_order(STATE, robot, {})
    assert condition is not None and condition.text.endswith(f" failed: {cause or 'no reason reported'}")
    first = reasons(STATE, robot)[0]
    assert first.name == (f"last order failed: {cause}" if cause else "last order failed, no reason reported")


def test_the_reason_that_came_with_the_end_is_first() -> None:
    robot = replace(STATE.robots[R0], logged=(Logged(Message("no valid control"), T0),))
    assert cause_of_end(robot, replace(FAILED, reason="aborted: blocked")) == "aborted: blocked"


def test_logs_are_wanted_before_a_robot_counts_as_stuck_and_after_an_order_failed() -> None:
    order = (1, 1, 2, "W")
    state = reduced(fleet(), link_up(T0))
    wanted = []
    for second in range(45):
        at = T0 + second
        state = reduced(state, pose(at), queue(at, order, current=1), tick(at))
        wanted.append(wants_causes(state))
    assert wanted.index(True) in range(29, 35) and wanted[-1] and not any(wanted[:29])
    failed = with_robot(STATE, replace(STATE.robots[R0], gone=(FAILED,)))
    assert not wants_causes(STATE) and wants_causes(reduced(failed, tick(T0 + 2.1)))


def test_an_error_precedes_a_later_warning_and_lines_before_the_goal_tell_nothing_of_it() -> None:
    ended = Goal("7f3a99c0", "", "navigate_to_pose", OrderState.FAILED, begun_at=T0 - 20.0)
    lines = (
        Logged(Message("of the goal before"), T0 - 25.0),
        Logged(Message("wheel slips"), T0 - 15.0),
        Logged(Message("no valid control"), T0 - 0.2),
        Logged(Message("timed out"), T0 - 0.1, is_warning=True),
    )
    robot = replace(STATE.robots[R0], gone=(FAILED,), goals={ended.action: (ended,)})
    for kept, cause in ((4, "no valid control"), (2, "wheel slips"), (1, "")):
        assert cause_of_end(replace(robot, logged=lines[:kept]), FAILED) == cause
    assert cause_of_end(replace(robot, logged=lines[3:]), FAILED) == "timed out"


@pytest.mark.parametrize("is_ours", [True, False])
def test_logs_are_kept_while_the_selected_robot_drives_or_one_with_an_order_from_here(is_ours: bool) -> None:
    state = reduced(nav2(), goals(T0, goal("77")), tick(T0 + 1))
    order = state.robots[R0].orders.current
    assert order is not None
    assert wants_causes(state, R0) and not wants_causes(state, "another")
    record = CommandRecord(1, place_order(R0, 1), T0, WALL, (), Baseline(), order_id=order.id)
    assert wants_causes(replace(state, commands=(record,) if is_ours else ()), "another") is is_ours
