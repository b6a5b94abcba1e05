"""Every way to the wire: a console that may not, or shows a recording, lets no command of any kind leave."""

from collections.abc import Callable, Mapping

import pytest

from fleet_tui.controllers.dispatch import Dispatch
from fleet_tui.controllers.notices import Notices
from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, ResumeRobot
from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.events import CargoReported, CommandPathChanged, Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from fleet_tui.state.store import Store
from tests.support.fleets import (
    LINK,
    R0,
    T0,
    fleet,
    graph,
    labels,
    link_up,
    place_order,
    pose,
    queue,
    tick,
    told,
)

ORDER = place_order(R0, 1, 2)
COMMANDS = [PauseRobot(R0), ResumeRobot(R0), ORDER, CancelOrder(R0, "1"), ClearOrders(R0)]
NAMES = [type(command).__name__ for command in COMMANDS]
DISARMED = Permissions(armed=False)


class CollectingBackend:
    """Keeps what is submitted."""

    player = None

    def __init__(self, refusal: str = "") -> None:
        self.refusal, self.submitted, self.events = refusal, list[Command](), list[Event]()
        self.counters: Mapping[str, LinkCounter] = {}

    def open(self) -> None: ...

    def submit(self, command: Command) -> str:
        self.submitted.append(command)
        return ""

    def tell(self, event: Event) -> str:
        self.events.append(event)
        return ""

    def show_map(self, robot: str, floor: str) -> None: ...

    def subscribe_logs(self, on: bool) -> None: ...

    def close(self) -> None: ...


class Desk:
    """A Dispatch, and all that it said and asked."""

    def __init__(self, state: FleetState, permissions: Permissions | None = None, refusal: str = "") -> None:
        self.store, self.backend = Store(state), CollectingBackend(refusal)
        self.notices = Notices(self.store, lambda: None)
        self.answers: list[Callable[[], None]] = []
        allowed = permissions or Permissions()
        self.dispatch = Dispatch(self.store, self.backend, allowed, self.notices, self._ask)

    def _ask(self, question: Callable[[], str], then: Callable[[], None]) -> None:
        assert question()
        self.answers.append(then)

    def do(self, command: Command) -> None:
        """Ask for it, and say yes to whatever is asked."""
        self.dispatch.do(Request((command,)))
        for yes in self.answers:
            yes()


def ready() -> FleetState:
    """robot_0 online at vertex 1, with order 1."""
    known = (
        graph(1, 2),
        labels({1: "Base", 2: "Store"}),
        queue(T0, (1, 1, 2, "W")),
        CargoReported(R0, T0, False),
    )
    alive = CommandPathChanged(LINK, CommandPath.ALIVE, connected=True)
    return told(fleet(1), link_up(T0), alive, *known, pose(T0), tick(T0 + 0.5))


@pytest.mark.parametrize("command", COMMANDS, ids=NAMES)
def test_an_armed_console_sends_it(command: Command) -> None:
    desk = Desk(ready())
    desk.do(command)
    assert desk.backend.submitted == [command]


@pytest.mark.parametrize("command", COMMANDS, ids=NAMES)
def test_a_console_that_is_not_armed_sends_nothing_not_even_a_pause(command: Command) -> None:
    desk = Desk(ready(), DISARMED)
    desk.do(command)
    assert desk.backend.submitted == []
    assert desk.notices.text.startswith("not sent: this console is not armed")


@pytest.mark.parametrize("command", [ORDER, ResumeRobot(R0), CancelOrder(R0, "1"), ClearOrders(R0)])
def test_a_read_only_console_sends_nothing(command: Command) -> None:
    """Of a pause the link itself says why: its end is in the log."""
    desk = Desk(ready(), Permissions(read_only=True))
    desk.do(command)
    assert desk.backend.submitted == []
    assert desk.notices.text == "not sent: this console is read-only"


@pytest.mark.parametrize("command", COMMANDS, ids=NAMES)
def test_a_recording_takes_nothing(command: Command) -> None:
    desk = Desk(ready(), refusal="not sent: this is a recording")
    desk.do(command)
    assert desk.backend.submitted == []
    assert desk.notices.text == "not sent: this is a recording"


def test_disarmed_while_it_is_asked_nothing_leaves() -> None:
    desk = Desk(ready())
    desk.dispatch.do(Request((ClearOrders(R0),)))
    desk.dispatch.permissions = DISARMED
    for yes in desk.answers:
        yes()
    assert desk.answers and desk.backend.submitted == []


@pytest.mark.parametrize("command", COMMANDS[:3], ids=NAMES[:3])
def test_disarmed_while_it_waits_for_the_link_nothing_leaves(command: Command) -> None:
    desk = Desk(fleet(1))
    desk.do(command)
    assert desk.notices.text == "waiting for the link"
    desk.dispatch.permissions = DISARMED
    desk.store.put(ready())
    desk.dispatch.release_held()
    assert desk.backend.submitted == []
    assert "not armed" in desk.notices.text


def test_what_waited_leaves_when_the_link_is_there() -> None:
    desk = Desk(fleet(1))
    desk.do(PauseRobot(R0))
    desk.store.put(ready())
    desk.dispatch.release_held()
    assert desk.backend.submitted == [PauseRobot(R0)]
