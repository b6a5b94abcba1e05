"""The list of outcomes, by itself."""

import time

import pytest

from fleet_tui.model.commands import Command, PauseRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.screens.tables.tools import SHOWN, STAYS, Outcomes
from tests.support.fleets import R0, commanded, fleet, reduced, tick
from tests.support.widget_app import WidgetApp

PAUSE = PauseRobot(R0)
TO_THE_END = Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED


def shown(outcomes: Outcomes) -> str:
    return str(outcomes.content)


async def test_each_command_has_a_line_that_follows_it() -> None:
    now = time.monotonic()
    states = [reduced(fleet(2), tick(now))]
    outcomes = Outcomes(lambda: states[-1])
    async with WidgetApp(outcomes).run_test():
        assert not outcomes.display
        told: list[tuple[Command, Message]] = [
            (PAUSE, EMPTY),
            (PauseRobot("robot_1"), Message("not sent: robot_1 is offline")),
        ]
        outcomes.show(told, now)
        assert shown(outcomes).splitlines()[1] == "robot_1 pause: not sent: robot_1 is offline"
        states.append(reduced(states[0], *commanded(1, PAUSE, Stage.SENT, at=now)))
        outcomes.look()
        assert "robot_0 pause: sent" in shown(outcomes)
        states.append(reduced(states[-1], *commanded(2, PAUSE, *TO_THE_END, at=now)))
        outcomes.look()
        assert "robot_0 pause: confirmed" in shown(outcomes)
        assert outcomes.close() and not outcomes.close()


async def test_it_stays_while_one_is_open_and_leaves_a_while_after_the_last(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    clock = [time.monotonic()]
    monkeypatch.setattr("fleet_tui.ui.screens.tables.tools.monotonic", lambda: clock[0])
    states: list[FleetState] = [reduced(fleet(), *commanded(1, PAUSE, Stage.SENT, at=clock[0]))]
    outcomes = Outcomes(lambda: states[-1])
    async with WidgetApp(outcomes).run_test():
        outcomes.show([(PAUSE, EMPTY)], clock[0])
        clock[0] += 60
        outcomes.look()
        assert outcomes.display
        states.append(reduced(fleet(), *commanded(1, PAUSE, *TO_THE_END, at=clock[0])))
        outcomes.look()
        clock[0] += STAYS - 0.1
        outcomes.look()
        assert outcomes.display
        clock[0] += 0.2
        outcomes.look()
        assert not outcomes.display


async def test_of_many_the_others_are_counted() -> None:
    state = fleet(40)
    outcomes = Outcomes(lambda: state)
    async with WidgetApp(outcomes).run_test():
        outcomes.show([(PauseRobot(name), Message("not sent: no link")) for name in state.robots], 0.0)
        lines = shown(outcomes).splitlines()
        assert len(lines) == SHOWN + 1 and lines[-1].startswith(f"and {40 - SHOWN} more")


async def test_what_was_sent_before_is_not_taken_for_an_outcome() -> None:
    now = time.monotonic()
    state = reduced(fleet(), *commanded(1, PAUSE, *TO_THE_END, at=now - 0.01))
    outcomes = Outcomes(lambda: state)
    async with WidgetApp(outcomes).run_test():
        outcomes.show([(PAUSE, EMPTY)], now)
        assert shown(outcomes) == "robot_0 pause: sending"
