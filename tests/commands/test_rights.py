"""The right that each command needs."""

import typing

import pytest

from fleet_tui.commands.checks import problems
from fleet_tui.commands.language.set_up import USAGE
from fleet_tui.commands.rights import SETTING_UP, needed_for, right_for, right_of
from fleet_tui.model.commands import Command, PauseRobot, PlaceOrder
from fleet_tui.model.geometry import Pose
from fleet_tui.model.order import at_vertices
from fleet_tui.model.problem import Permissions, Right
from fleet_tui.model.request import Request
from fleet_tui.model.set_up.commands import (
    CancelGoal,
    SendGoal,
    SendGraph,
    SetMapping,
    SetPose,
    SetUp,
    StartCharging,
    StoreMap,
)
from tests.support.fleets import F0, R0, fleet

POSE = Pose(0.0, 0.0)
SETS_UP: list[Command] = [
    SetPose(R0, F0, POSE),
    SetMapping(R0, True),
    StoreMap(R0, "hall"),
    SendGraph(R0, F0),
]
DISPATCHES: list[Command] = [
    PlaceOrder(R0, at_vertices("1", "2")),
    PauseRobot(R0),
    SendGoal(R0, F0, POSE),
    CancelGoal(R0),
    StartCharging(R0),
]


def test_goals_are_given_like_orders_and_the_rest_sets_up() -> None:
    assert {right_for(command) for command in DISPATCHES} == {Right.DISPATCH}
    assert {right_for(command) for command in SETS_UP} == {Right.SETUP}
    assert len(typing.get_args(SetUp)) == 10, "a new command: which right does it need?"
    assert set(USAGE) - SETTING_UP == {"goto"}
    assert right_of("goto") is right_of("pause") is Right.DISPATCH and right_of("settle") is Right.SETUP


@pytest.mark.parametrize("command", [*DISPATCHES, *SETS_UP])
def test_the_checks_refuse_it_first_a_pause_too(command: Command) -> None:
    state, request = fleet(), Request((command,))
    (found,) = problems(state, request, Permissions(right=Right.VIEW))
    word = right_for(command).word
    assert (found.text, found.blocks) == (f"not allowed: {word}", True)
    for right in Right:
        refused = Permissions(right=right).objection(needed_for(request.commands)) is not None
        assert refused is (right < right_for(command))


def test_the_reason_of_a_refused_file_is_told() -> None:
    (found,) = problems(
        fleet(), Request((PauseRobot(R0),)), Permissions(right=Right.VIEW, why="no rights: x")
    )
    assert found.text == "not allowed: dispatch (no rights: x)"
