"""An order that this console drives goal by goal is one order, however often its robot stops on the way."""

from collections.abc import Callable, Iterator

import pytest

from fleet_tui.model.commands import CancelOrder, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.events import CommandAdvanced, CommandIssued
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import OrderChange
from fleet_tui.model.order import OrderState
from fleet_tui.records.history.observing import Observer
from fleet_tui.text.language import Message
from fleet_tui.ui.view.tables.recent import recent_table
from fleet_tui.ui.view.tables.selected_robot import ended_rows
from tests.support.fleets import R0, T0, reduced
from tests.support.legs import DONE, FAILED, OFF, goal, lived, record, sent, site

FIRST, SECOND, THIRD = "goal---1", "goal---2", "goal---3"


def to_its_first_stop() -> Iterator[FleetState]:
    yield site()
    state = sent(site(), T0 + 1, FIRST)
    yield lived(state, T0 + 1.2, goal(FIRST))
    yield lived(lived(state, T0 + 1.2, goal(FIRST)), T0 + 4, goal(FIRST, DONE))


def paused_on_the_way() -> Iterator[FleetState]:
    yield site()
    state = lived(sent(site(), T0 + 1, FIRST), T0 + 1.2, goal(FIRST))
    yield state
    pause = [CommandAdvanced(8, stage, T0 + 2) for stage in (Stage.SENT, Stage.ACCEPTED)]
    state = reduced(state, CommandIssued(8, PauseRobot(R0), T0 + 2, T0), *pause)
    state = lived(lived(state, T0 + 2.2, goal(FIRST, OFF)), T0 + 4, goal(FIRST, OFF))
    yield state
    resume = [CommandAdvanced(9, stage, T0 + 4.5) for stage in (Stage.SENT, Stage.ACCEPTED)]
    yield reduced(state, CommandIssued(9, ResumeRobot(R0), T0 + 4.5, T0), *resume)


def on(state: FleetState, end: OrderState, name: str = SECOND, at: float = T0 + 5) -> Iterator[FleetState]:
    """A further goal, which leaves a moment before it is listed, and its end."""
    state = sent(state, at, name)
    yield state
    state = lived(state, at + 0.2, goal(name))
    yield state
    yield lived(lived(state, at + 4, goal(name, end)), at + 6, goal(name, end))


def changes(states: list[FleetState]) -> list[tuple[str, str, str]]:
    observer = Observer()
    facts = [fact for state in states for fact in observer.observe(state)]
    return [(fact.order, fact.way, fact.stage) for fact in facts if isinstance(fact, OrderChange)]


def recent(state: FleetState) -> list[str]:
    rows = recent_table(state, lambda _: "", 20).rows
    return ["".join(text for text, _ in row.runs).strip() for row in rows]


def ended(state: FleetState) -> list[str]:
    return [runs[1][0] for runs in ended_rows(state, state.robots[R0])]


def whole(end: str) -> list[tuple[str, str, str]]:
    return [(FIRST, "1 -> 2", stage) for stage in ("queued", "begun", end)]


@pytest.mark.parametrize(("end", "stage"), [(DONE, "done"), (FAILED, "failed")])
@pytest.mark.parametrize("begin", [to_its_first_stop, paused_on_the_way])
def test_history_tells_one_order_and_its_end(
    begin: Callable[[], Iterator[FleetState]], end: OrderState, stage: str
) -> None:
    states = list(begin())
    states += on(states[-1], end)
    if record(states[-1]).stage is Stage.WAITING:  # it was paused before its first stop
        states += on(states[-1], end, THIRD, T0 + 12)
    assert changes(states) == whole(stage)


def test_history_tells_the_end_of_one_that_was_cancelled_while_it_waited_here() -> None:
    states = list(paused_on_the_way())[:-1]
    waiting = record(states[-1])
    assert waiting.stage is Stage.WAITING and waiting.order_id is not None
    cancel = CommandIssued(8, CancelOrder(R0, waiting.order_id), T0 + 5, T0)
    state = reduced(
        states[-1], cancel, CommandAdvanced(7, Stage.CANCELLED, T0 + 5, Message("by this console"))
    )
    states += [state, lived(state, T0 + 6)]
    assert changes(states) == whole("cancelled")


def test_a_stop_on_the_way_is_no_end_of_an_order_on_the_screen() -> None:
    states = list(to_its_first_stop())
    assert ended(states[-1]) == [] and not any("done" in line for line in recent(states[-1]))
    *_, state = on(states[-1], DONE)
    assert ended(state) == ["1 -> 2: done"]
    assert len([line for line in recent(state) if "done" in line]) == 1
    assert not any("started" in line for line in recent(list(on(states[-1], DONE))[1]))
