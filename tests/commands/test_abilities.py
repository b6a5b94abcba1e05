"""The ability that each command needs."""

import pytest

from fleet_tui.commands.abilities import ability_for, unaccepted
from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, ResumeRobot
from fleet_tui.model.kind import CANCEL, CLEAR, ORDER, PAUSE, RESUME, Kind
from tests.support.fleets import R0, place_order
from tests.support.kinds import moved


@pytest.mark.parametrize(
    ("command", "ability"),
    [
        (place_order(R0, 1, 2), ORDER),
        (CancelOrder(R0, "1"), CANCEL),
        (ClearOrders(R0), CLEAR),
        (PauseRobot(R0), PAUSE),
        (ResumeRobot(R0), RESUME),
    ],
)
def test_a_command_needs_its_ability(command: Command, ability: str) -> None:
    assert ability_for(command) == ability
    assert unaccepted(moved(Kind(accepts=(ability,))), command) == ""
    assert unaccepted(moved(Kind()), command) != ""
