"""States of programs, and how long they are known."""

from fleet_tui.model.programs.program import (
    CONFIRMED,
    OLD,
    REFUSED,
    ChangeOutcome,
    ProgramRow,
    ProgramState,
    ProgramStatus,
)
from fleet_tui.text.language import Message


def test_a_state_is_unknown_before_the_first_look_and_when_it_is_old() -> None:
    assert ProgramRow("p").state(0.0) is ProgramState.UNKNOWN
    row = ProgramRow("p", status=ProgramStatus(ProgramState.RUNNING, 10.0))
    assert row.state(10.0 + OLD) is ProgramState.RUNNING
    assert row.state(10.1 + OLD) is ProgramState.UNKNOWN


def test_only_a_confirmed_change_is_done() -> None:
    assert ChangeOutcome(CONFIRMED).is_confirmed and not ChangeOutcome(REFUSED).is_confirmed
    assert ChangeOutcome(REFUSED, Message("why")).text == "refused (why)"
    assert ChangeOutcome(CONFIRMED).text == "confirmed"
