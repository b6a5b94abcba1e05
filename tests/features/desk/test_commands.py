"""Typed lines of the desk."""

from collections.abc import Sequence

import pytest

from fleet_tui.features.desk.commands import DeskCommands
from fleet_tui.model.desk.desk import Colleague, ends_of
from fleet_tui.model.desk.events import (
    ColleaguesSeen,
    DeskJoined,
    EdgeClosed,
    EdgeOpened,
    RobotClaimed,
    RobotReleased,
)
from fleet_tui.model.events import Event
from fleet_tui.model.problem import Permissions, Right
from fleet_tui.ui.controllers.typed import Typed
from tests.support.desk import Desk
from tests.support.fleets import F0, R0, fleet, graph, labels, reduced

JOINED = DeskJoined("ana")
BEN = Colleague("x", "ben", "hall", "robot_1", ("robot_1",))


def made(*facts: Event, permissions: Permissions | None = None) -> tuple[Desk, DeskCommands]:
    state = reduced(fleet(3), graph(1, 2, 3), labels({1: "Base", 2: "Hall"}), *facts)
    desk = Desk(state, permissions)
    return desk, DeskCommands(desk.console(clock=lambda _wall: "12:00"))


def typed(commands: DeskCommands, line: str) -> Typed:
    found = commands.typed(line)
    assert found is not None
    return found


def run(commands: DeskCommands, line: str) -> str:
    """Run a line; return its text."""
    ((text, do),) = typed(commands, line).entries
    do()
    return text


def test_a_robot_is_claimed_and_released() -> None:
    desk, commands = made(JOINED)
    assert run(commands, "claim robot_2") == "Claim robot_2: others are asked before they command it"
    assert desk.backend.events == [RobotClaimed("robot_2")] and desk.notices.text == "claimed robot_2"
    desk, commands = made(JOINED, RobotClaimed("robot_2"))
    assert run(commands, "release ROBOT_2") == "Release robot_2"
    assert desk.backend.events == [RobotReleased("robot_2")]


@pytest.mark.parametrize(
    ("facts", "line", "problem"),
    [
        ([], "claim robot_0", "no desk: set [desk] folder in the configuration"),
        ([JOINED, ColleaguesSeen((BEN,))], "claim robot_1", "robot_1 is claimed by ben: ask for its release"),
        ([JOINED], "release robot_1", "robot_1 is not claimed by this console"),
        ([JOINED], "claim", "usage: claim ROBOT"),
        ([JOINED], "claim robot_9", "unknown robot 'robot_9'"),
        ([], "open Base Hall", "Base - Hall is not closed"),
        ([], "close Base", "usage: close A B: an edge of the floor shown"),
        ([], "close Base 3", "no edge Base - 3"),
    ],
)
def test_what_can_not_be_done_is_told(facts: Sequence[Event], line: str, problem: str) -> None:
    _, commands = made(*facts)
    found = typed(commands, line)
    assert found.problem.startswith(problem) and not found.entries


def test_edges_are_closed_and_opened_also_without_a_desk() -> None:
    desk, commands = made()
    assert run(commands, "close Hall Base") == "Close Base - Hall: cuts the way of no order"
    (event,) = desk.backend.events
    assert isinstance(event, EdgeClosed) and event.ends == ends_of(F0, "1", "2") and event.by == ""
    assert desk.notices.text == "closed Base - Hall: cuts the way of no order, not shared: no desk"
    desk, commands = made(event)
    assert typed(commands, "open ").completed == ["open Base Hall"]
    assert run(commands, "open Base Hall") == "Open Base - Hall"
    assert desk.backend.events == [EdgeOpened(ends_of(F0, "1", "2"))]


def test_lines_about_something_else_are_left_to_others() -> None:
    _, commands = made()
    assert commands.typed("clear robot_0") is None and commands.typed("") is None


def test_a_console_that_is_read_only_claims_and_closes_nothing() -> None:
    desk, commands = made(JOINED, permissions=Permissions(read_only=True))
    for line in ("claim robot_0", "close Base Hall"):
        assert typed(commands, line).problem == "this console is read-only"
    assert desk.backend.events == []


def test_the_menu_names_everybody_and_goes_to_what_they_look_at() -> None:
    closed = EdgeClosed(ends_of(F0, "1", "2"), 5.0, "ben")
    desk, commands = made(JOINED, RobotClaimed(R0), ColleaguesSeen((BEN,)), closed)
    commands.menu()
    (menu,) = desk.menus
    assert menu.title.splitlines() == [
        "Desk: ana (this console), claims robot_0",
        "closed 12:00 by ben: Base - Hall on floor_0",
    ]
    assert menu.texts == ["ben, console on hall looks at robot_1, claims robot_1"]
    menu.choose("ben")
    assert desk.selected == ["robot_1"]


def test_a_menu_without_others_or_without_a_desk() -> None:
    desk, commands = made(JOINED)
    commands.menu()
    assert desk.menus[0].title.endswith("no other console")
    desk, commands = made()
    commands.menu()
    assert desk.menus == [] and desk.notices.text == "no desk: set [desk] folder in the configuration"


def test_a_closed_edge_under_the_cursor_is_explained_and_can_be_opened() -> None:
    closed = EdgeClosed(ends_of(F0, "1", "2"), 5.0, "ben")
    desk, commands = made(closed)
    assert not commands.explain_edge((1.5, 5.0))
    assert commands.explain_edge((0.5, 0.5))
    (menu,) = desk.menus
    assert menu.title == "Base - Hall: cuts the way of no order"
    menu.choose("Open Base - Hall")
    assert desk.backend.events == [EdgeOpened(ends_of(F0, "1", "2"))]
    viewer, commands = made(closed, permissions=Permissions(right=Right.VIEW))
    assert commands.explain_edge((0.5, 0.0)) and viewer.menus[0].texts == ["Close this"]


def test_who_may_only_view_claims_and_closes_nothing() -> None:
    _, commands = made(JOINED, permissions=Permissions(right=Right.VIEW))
    for line in ("claim robot_0", "release robot_0", "close Base Hall", "open Base Hall"):
        assert typed(commands, line).problem == "not allowed: dispatch"
