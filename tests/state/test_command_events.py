"""Commands in the state: they end once, the newest are kept, pauses of our own are known."""

import pytest

from fleet_tui.model import events
from fleet_tui.model.commands import Command, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.situation.batches import summary
from fleet_tui.state.command_events import COMMANDS_KEPT
from fleet_tui.text.language import Message
from tests.support.fleets import R0, T0, WALL, commanded, fleet, place_order, reduced


def test_a_command_ends_exactly_once_whatever_comes() -> None:
    state = reduced(fleet(), *commanded(7, PauseRobot(R0)), events.CommandAdvanced(8, Stage.SENT, T0))
    assert state.commands[0].stage is Stage.CHECKED
    assert reduced(state, *commanded(7, ResumeRobot(R0))).commands == state.commands
    state = reduced(state, events.CommandAdvanced(7, Stage.NOT_SENT, T0, Message("no link")))
    assert reduced(state, events.CommandAdvanced(7, Stage.ACCEPTED, T0, Message("paused"))) is state
    assert (state.commands[0].stage, state.commands[0].detail) == (Stage.NOT_SENT, "no link")
    assert not state.robots[R0].paused_by_us


def test_an_order_has_an_id_once_it_waits_here_and_another_once_it_is_sent() -> None:
    order = place_order(R0, 1, 2)
    state = reduced(fleet(), *commanded(7, order, Stage.WAITING))
    assert state.commands[0].order_id is not None
    again = reduced(state, events.CommandAdvanced(7, Stage.WAITING, T0 + 1))
    assert again.commands[0].order_id == state.commands[0].order_id
    sent = reduced(state, events.CommandAdvanced(7, Stage.SENT, T0 + 2))
    assert sent.commands[0].order_id is None


def test_the_newest_commands_are_kept() -> None:
    commands: list[Command] = [place_order(R0, n, n) for n in range(COMMANDS_KEPT + 5)]
    state = fleet()
    for n, command in enumerate(commands):
        state = reduced(state, *commanded(n, command, Stage.SENT, Stage.REFUSED))
    assert [record.command for record in state.commands] == commands[-COMMANDS_KEPT:]


def test_a_command_under_way_is_kept_until_its_end_has_come() -> None:
    many = range(2 * COMMANDS_KEPT)
    state = reduced(fleet(), *(events.CommandIssued(n, PauseRobot(R0), T0, WALL) for n in many))
    assert len(state.commands) == len(many)
    state = reduced(state, events.CommandAdvanced(0, Stage.NOT_SENT, T0))
    assert state.commands[0].stage is Stage.NOT_SENT


def test_a_request_to_many_robots_is_whole_until_its_last_one_is_decided() -> None:
    count = 2 * COMMANDS_KEPT
    state = fleet(count)
    for n in range(count):
        end = [Stage.NOT_SENT] if n else []
        state = reduced(state, *commanded(n, PauseRobot(f"robot_{n}"), *end))
    assert len(state.commands) == count
    state = reduced(state, *commanded(count, ResumeRobot(R0), at=T0 + 1))
    assert len(state.commands) == count + 1, "one is open"
    state = reduced(state, *commanded(0, PauseRobot(R0)), events.CommandAdvanced(0, Stage.NOT_SENT, T0 + 1))
    assert summary(state, state.commands[:count])[1].startswith(f"{count} not sent")
    state = reduced(state, *commanded(count + 1, ResumeRobot(R0), at=T0 + 2))
    assert len(state.commands) == COMMANDS_KEPT


def robot(state: FleetState) -> Robot:
    return state.robots[R0]


def accepted(command: Command, id_: int = 1) -> tuple[Event, ...]:
    return commanded(id_, command, Stage.SENT, Stage.ACCEPTED)


def test_paused_by_us_until_we_resume() -> None:
    state = reduced(fleet(), *accepted(PauseRobot(R0)), *accepted(ResumeRobot(R0), id_=2))
    assert not state.is_paused(robot(state))


@pytest.mark.parametrize("stage", [stage for stage in Stage if stage is not Stage.ACCEPTED])
def test_a_pause_that_was_not_accepted_pauses_nothing(stage: Stage) -> None:
    state = reduced(fleet(), *commanded(1, PauseRobot(R0), Stage.SENT, stage))
    assert not state.is_paused(robot(state))


def test_a_lock_is_ours_from_its_sending_until_we_resume() -> None:
    state = reduced(fleet(), *accepted(PauseRobot(R0)))
    since = robot(state).paused_since
    assert not robot(state).locked_by_us
    again = events.CommandIssued(2, PauseRobot(R0), T0 + 5, WALL)
    state = reduced(state, again, events.CommandAdvanced(2, Stage.SENT, T0 + 5, Message(""), "/tb2/lock"))
    assert robot(state).locked_by_us
    state = reduced(state, *commanded(3, PauseRobot(R0), Stage.SENT, Stage.ACCEPTED, at=T0 + 9))
    assert robot(state).locked_by_us and robot(state).paused_since == since
    assert not robot(reduced(state, *accepted(ResumeRobot(R0), id_=4))).locked_by_us
