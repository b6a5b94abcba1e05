"""Requests that wait for the link, one at a time: never longer than said, never held up by another link."""

import msgspec

from fleet_tui.model.commands import Command, PauseRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.model.request import Request
from fleet_tui.ui.controllers.dispatch import LINK_WITHIN, PAUSE_WITHIN, StartupRequests
from tests.support.fleets import fleet, place_order

UP = LinkState("far", "ws://far:9090", Phase.UP, commands_connected=True)
STARTING = LinkState("far", "ws://far:9090")


def starting(far: LinkState = STARTING) -> FleetState:
    """Two robots on a link each, of which neither was tried yet, or only the second."""
    state = fleet(2)
    robots = {**state.robots, "robot_1": msgspec.structs.replace(state.robots["robot_1"], link="far")}
    return msgspec.structs.replace(state, robots=robots, links={**state.links, "far": far})


class Given:
    """The destination of held requests."""

    def __init__(self) -> None:
        self.commands: list[Command] = []
        self.said: list[str] = []
        self.held = StartupRequests(lambda request: self.commands.extend(request.commands), self.said.append)


def test_a_pause_of_all_does_not_wait_for_the_slowest_link() -> None:
    given, pauses = Given(), (PauseRobot("robot_0"), PauseRobot("robot_1"))
    assert given.held.hold(starting(), Request(pauses), 0.0) is None
    given.held.release(starting(UP), 0.3)
    assert given.commands == [pauses[1]]
    given.held.release(starting(UP), PAUSE_WITHIN)
    assert given.commands == [pauses[1], pauses[0]]


def test_an_order_that_waited_longer_than_a_second_is_not_sent_after_all() -> None:
    """The console may have been busy itself, while the link came up."""
    given, order = Given(), place_order("robot_1", 0, 1)
    given.held.hold(starting(), Request((order,)), 0.0)
    given.held.release(starting(UP), LINK_WITHIN + 1.0)
    assert not given.commands and given.said == ["not sent: no link for 2.0 s, repeat the command"]
    given.held.hold(starting(), Request((order,)), 0.0)
    given.held.release(starting(UP), LINK_WITHIN)
    assert given.commands == [order]


def test_a_pause_is_sent_however_long_it_waited() -> None:
    given = Given()
    given.held.hold(starting(), Request((PauseRobot("robot_1"),)), 0.0)
    given.held.release(starting(UP), PAUSE_WITHIN + 9.0)
    assert given.commands == [PauseRobot("robot_1")]
