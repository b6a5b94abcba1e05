"""Commands to robots that others have claimed."""

from fleet_tui.commands.checks import problems
from fleet_tui.model.commands import ClearOrders, PauseRobot, ResumeRobot
from fleet_tui.model.desk.desk import Colleague
from fleet_tui.model.desk.events import ColleaguesSeen, DeskJoined, RobotClaimed
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from tests.support.fleets import R0, fleet, reduced


def test_others_are_asked_before_they_command_a_claimed_robot_but_for_a_pause() -> None:
    state = reduced(fleet(), ColleaguesSeen((Colleague("x", "ben", "here", claims=(R0,)),)))

    def said(command: ClearOrders | PauseRobot | ResumeRobot) -> list[tuple[str, bool]]:
        found = problems(state, Request((command,)), Permissions())
        return [(one.text, one.blocks) for one in found if one.check == "claimed"]

    assert said(ResumeRobot(R0)) == said(ClearOrders(R0)) == [("robot_0 is claimed by ben", False)]
    assert said(PauseRobot(R0)) == []


def test_ones_own_claim_asks_nothing() -> None:
    state = reduced(fleet(), DeskJoined("ana"), RobotClaimed(R0))
    found = problems(state, Request((ResumeRobot(R0),)), Permissions())
    assert "claimed" not in [one.check for one in found]
