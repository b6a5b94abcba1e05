"""Orders for the nearest idle robot: asked with its name, checked again after the yes, never sent without."""

from collections.abc import Callable

import pytest
from msgspec.structs import replace

from fleet_tui.commands.language.lookup import Place
from fleet_tui.model.events import BatteryReported, CargoReported, CommandPathChanged
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath
from fleet_tui.model.problem import Permissions
from fleet_tui.ui.controllers.ordering.any_robot import AnyoneOrders
from tests.support.desk import Desk
from tests.support.fleets import (
    F0,
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
    reduced,
    tick,
)

R1 = "robot_1"
BASE, STORE = Place("1", "Base", F0), Place("3", "Store", F0)
BUSY = queue(T0, (1, 1, 3, "W"), current=1)


def idle_fleet() -> FleetState:
    """robot_0 stands at Base, robot_1 2 m away; both are idle."""
    facts = [
        fact
        for robot, x in ((R0, 0.0), (R1, 2.0))
        for fact in (
            graph(1, 2, 3, robot=robot),
            labels({1: "Base", 3: "Store"}, robot=robot),
            pose(T0, x, robot=robot),
            BatteryReported(robot, T0, 71.0),
            CargoReported(robot, T0, False),
            queue(T0, robot=robot),
        )
    ]
    alive = CommandPathChanged(LINK, CommandPath.ALIVE, connected=True)
    return reduced(fleet(2), link_up(T0), alive, *facts, tick(T0))


class Asking(Desk):
    """A desk that keeps its questions."""

    def __init__(self, state: FleetState, permissions: Permissions | None = None) -> None:
        super().__init__(state, permissions)
        self.questions: list[Callable[[], str]] = []
        self.anyone = AnyoneOrders(replace(self.console(), ask=self.put))

    def put(self, question: Callable[[], str], then: Callable[[], None]) -> None:
        self.questions.append(question)
        self.answers.append(then)

    def yes(self) -> None:
        self.answers.pop()()


def test_the_nearest_idle_robot_is_asked_about_and_gets_it_after_a_yes() -> None:
    desk, closed = Asking(idle_fleet()), list[bool]()
    assert desk.anyone.give([BASE, STORE], lambda: closed.append(True)) == ""
    assert desk.questions[0]() == f"{R0} order Base -> Store?\nNearest idle, 0 m away"
    assert desk.backend.submitted == [] and closed == []
    desk.yes()
    assert desk.backend.submitted == [place_order(R0, 1, 3)] and closed == [True]


def test_one_that_has_become_busy_meanwhile_gets_nothing_and_the_next_is_proposed() -> None:
    desk = Asking(idle_fleet())
    desk.anyone.give([BASE, STORE])
    desk.store.apply(BUSY)
    assert desk.questions[0]().endswith("\nIt is now busy: Yes proposes the next one")
    desk.yes()
    assert desk.backend.submitted == []
    asked = f"{R0} is now busy\n{R1} order Base -> Store?\nNearest idle, 2 m away"
    assert desk.questions[1]() == asked
    desk.yes()
    assert desk.backend.submitted == [place_order(R1, 1, 3)]


def test_without_an_idle_robot_the_reasons_are_said_and_nothing_is_asked() -> None:
    desk = Asking(reduced(idle_fleet(), BUSY, queue(T0, (1, 1, 3, "W"), robot=R1)))
    assert desk.anyone.give([BASE, STORE]) == "no idle robot can drive Base -> Store: 2 busy"
    assert desk.questions == []


def test_the_last_one_that_becomes_busy_is_said_too() -> None:
    desk = Asking(reduced(idle_fleet(), queue(T0, (1, 1, 3, "W"), robot=R1)))
    desk.anyone.give([BASE, STORE])
    desk.store.apply(BUSY)
    desk.yes()
    text = f"{R0} is now busy; no idle robot can drive Base -> Store: 2 busy"
    assert desk.notices.text == text and desk.backend.submitted == []


@pytest.mark.parametrize(
    ("permissions", "text"),
    [
        (Permissions(read_only=True), "not sent: this console is read-only"),
        (Permissions(armed=False), "not sent: this console is not armed: use Arm in the palette (:)"),
    ],
)
def test_a_console_that_may_not_send_asks_nothing(permissions: Permissions, text: str) -> None:
    desk = Asking(idle_fleet(), permissions)
    assert desk.anyone.give([BASE, STORE]) == text
    assert desk.questions == []


def test_an_order_from_a_place_to_itself_is_not_even_asked() -> None:
    desk = Asking(idle_fleet())
    assert desk.anyone.give([BASE, BASE]) == "not sent: From and To are the same place: Base"


@pytest.mark.parametrize("line", ["anyone Base Store", "anyone Base > Store", "order Anyone base to store"])
def test_it_can_be_typed_and_asks_the_same(line: str) -> None:
    desk = Asking(idle_fleet())
    typed = desk.anyone.typed(line)
    assert typed is not None
    ((text, do),) = typed.entries
    assert text == "nearest idle robot: Base -> Store"
    do()
    assert desk.questions[0]() == f"{R0} order Base -> Store?\nNearest idle, 0 m away"
    assert desk.backend.submitted == []


def test_a_typed_line_that_is_incomplete_says_how_and_one_for_a_robot_is_another_line() -> None:
    desk = Asking(idle_fleet())
    incomplete = desk.anyone.typed("anyone Ba")
    assert incomplete is not None
    assert incomplete.problem == "usage: anyone FROM TO, or anyone FROM > TO"
    assert incomplete.completed == ["anyone Base "]
    assert desk.anyone.typed(f"{R0} Base > Store") is None and desk.anyone.typed("") is None


def test_a_typed_order_that_nobody_can_drive_says_so() -> None:
    desk = Asking(reduced(idle_fleet(), BUSY, queue(T0, (1, 1, 3, "W"), robot=R1)))
    typed = desk.anyone.typed("anyone Base Store")
    assert typed is not None
    typed.entries[0][1]()
    assert desk.notices.text == "no idle robot can drive Base -> Store: 2 busy"
