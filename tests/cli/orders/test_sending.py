"""From a request to outcomes: what holds it back, what goes first, and what a failure leaves unsent."""

from collections.abc import Iterator, Sequence
from typing import cast

import pytest

from fleet_tui.cli.orders.outcome import DONE, NO_LINK, NOT_DONE, USAGE
from fleet_tui.cli.orders.sending import How, Sending, divide, reaches, unreported
from fleet_tui.cli.session import WaitingStore
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.model.commands import ClearOrders, Command, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.events import CommandAdvanced, CommandIssued, CommandPathChanged
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import ORDER_TO, PAUSE, Kind
from fleet_tui.model.link import CommandPath
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request, chain
from tests.support.desk import ready
from tests.support.fleets import (
    LINK,
    R0,
    T0,
    WALL,
    fleet,
    graph,
    link_lost,
    of_kinds,
    place_order,
    pose,
    reduced,
)


class InstantLink:
    """A link whose commands end at once, each as its stages say."""

    def __init__(self, store: WaitingStore, *ends: tuple[Stage, ...]) -> None:
        self.store, self.submitted = store, list[Command]()
        self._ends: Iterator[tuple[Stage, ...]] = iter(ends)

    def submit(self, command: Command) -> int:
        self.submitted.append(command)
        id_ = len(self.submitted)
        self.store.apply(CommandIssued(id_, command, T0, WALL))
        for stage in next(self._ends):
            self.store.apply(CommandAdvanced(id_, stage, T0 + 1))
        return id_

    def submit_all(self, commands: Sequence[Command]) -> list[int]:
        return [self.submit(command) for command in commands]


def sending(
    state: FleetState, *ends: tuple[Stage, ...], yes: bool = False, permissions: Permissions | None = None
) -> tuple[Sending, InstantLink]:
    store = WaitingStore(state)
    link = InstantLink(store, *ends)
    return Sending(cast("FleetLink", link), store, How(permissions or Permissions(), 0.1, yes)), link


GOOD, BAD = (Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED), (Stage.SENT, Stage.REFUSED)
A_B_A = Request(chain(R0, ["1", "2", "1"]))


def test_a_chain_ends_with_its_first_failure() -> None:
    it, link = sending(ready(), BAD)
    found = list(it.give(A_B_A))
    assert [(one.outcome, one.code) for one in found] == [("refused", NOT_DONE), ("not sent", NOT_DONE)]
    assert found[1].words == "the previous command failed" and len(link.submitted) == 1
    it, link = sending(ready(), GOOD, GOOD)
    assert [one.code for one in it.give(A_B_A)] == [DONE, DONE] and not it.under_way


def test_a_warning_holds_it_back_unless_it_is_overridden() -> None:
    clear = Request((ClearOrders(R0),))
    it, link = sending(ready(), GOOD)
    (held,) = it.give(clear)
    assert held.words == "robot_0 would lose 1 order: use --yes to send anyway" and link.submitted == []
    assert [one.check for one in it.warnings(clear)] == ["losses"] and it.check(clear) == [held]
    it.override()
    assert it.check(clear) == [] and [one.code for one in it.give(clear)] == [DONE]


@pytest.mark.parametrize(
    ("state", "request_", "code"),
    [
        (ready(), Request((place_order(R0, 1, 77),)), USAGE),
        (reduced(ready(), link_lost(T0)), Request((ResumeRobot(R0),)), NO_LINK),
        (reduced(fleet(), graph(1, 2)), A_B_A, NO_LINK),
    ],
)
def test_an_error_is_never_sent_and_has_its_exit_code(
    state: FleetState, request_: Request, code: int
) -> None:
    it, link = sending(state, yes=True)
    assert {one.code for one in it.give(request_)} == {code}
    assert link.submitted == [] and it.warnings(request_) == []


def test_a_command_that_never_ends_is_unknown_and_under_way() -> None:
    it, _ = sending(ready(), (Stage.SENT,))
    (found,) = it.give(Request((ResumeRobot(R0),)))
    assert found.outcome == "outcome unknown" and "no further report" in found.words
    assert [record.command for record in it.under_way] == [ResumeRobot(R0)]


def test_a_pause_goes_where_there_is_a_connection_and_to_the_others_after_the_limit() -> None:
    it, link = sending(ready(), GOOD)
    assert [one.code for one in it.pause([R0])] == [DONE]
    it, link = sending(reduced(ready(), CommandPathChanged(LINK, CommandPath.DEAD)), (Stage.NOT_SENT,))
    (found,) = it.pause([R0])
    assert found.code == NO_LINK and link.submitted == [PauseRobot(R0)]


def test_what_a_kind_does_not_accept_is_answered_here() -> None:
    state = of_kinds(fleet(2), Kind("one", accepts=(PAUSE,)), Kind("two", accepts=(ORDER_TO,)))
    able, unable = divide(state, Request((PauseRobot(R0), PauseRobot("robot_1"))))
    assert able.commands == (PauseRobot(R0),)
    assert [(one.robot, one.code) for one in unable] == [("robot_1", NOT_DONE)]
    it, _ = sending(state, GOOD)
    assert [(one.robot, one.code) for one in it.pause([R0, "robot_1"])] == [("robot_1", NOT_DONE), (R0, DONE)]


def test_reports_that_have_not_come_are_named() -> None:
    assert unreported(ready().robots[R0]) == []
    assert unreported(fleet(1, 2).robots[R0]) == ["queue", "cargo", "graph of floor_0", "graph of floor_1"]
    goals = of_kinds(
        fleet(), Kind("goals", ("queue", "pose"), silence={"queue": float("inf")}, keeps_goals=True)
    )
    assert unreported(goals.robots[R0]) == ["pose"] and unreported(reduced(goals, pose(T0)).robots[R0]) == []


def test_a_robot_is_reached_while_its_link_and_the_path_of_commands_are_up() -> None:
    state = ready()
    assert reaches(state, state.robots[R0])
    for path, reached in ((CommandPath.UNREGISTERED, True), (CommandPath.DEAD, False)):
        assert reaches(reduced(state, CommandPathChanged(LINK, path)), state.robots[R0]) is reached
    assert not reaches(reduced(state, link_lost(T0)), state.robots[R0])
