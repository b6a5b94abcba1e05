"""The newest command of a kind, and the pause that a robot may be under."""

import pytest

from fleet_tui.model.commands import ClearOrders, PauseRobot, ResumeRobot, Stage
from fleet_tui.orders.newest import last_command, own_pause
from tests.support.fleets import R0, T0, commanded, fleet, reduced


def test_the_newest_of_its_kinds_and_of_this_robot() -> None:
    state = reduced(
        fleet(2),
        *commanded(1, PauseRobot(R0)),
        *commanded(2, PauseRobot("robot_1"), at=T0 + 1),
        *commanded(3, ClearOrders(R0), at=T0 + 2),
    )
    found = last_command(state, state.robots[R0], PauseRobot, ResumeRobot)
    assert found is not None and found.id == 1
    assert last_command(state, state.robots["robot_1"], ClearOrders) is None


@pytest.mark.parametrize(
    ("stage", "counts"),
    [(Stage.ACCEPTED, True), (Stage.UNKNOWN, True), (Stage.REFUSED, False), (Stage.NOT_SENT, False)],
)
def test_a_pause_that_did_nothing_is_none(stage: Stage, counts: bool) -> None:
    before = () if stage is Stage.NOT_SENT else (Stage.SENT,)
    state = reduced(fleet(), *commanded(1, PauseRobot(R0), *before, stage))
    assert (own_pause(state, state.robots[R0]) is not None) is counts


def test_a_resume_since_ends_it() -> None:
    state = reduced(
        fleet(), *commanded(1, PauseRobot(R0), Stage.SENT), *commanded(2, ResumeRobot(R0), at=T0 + 1)
    )
    assert own_pause(state, state.robots[R0]) is None
