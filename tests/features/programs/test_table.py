"""Rows of programs and of logs: every state in words, everything from outside made harmless."""

import pytest
from hypothesis import given

from fleet_tui.features.programs.table import NONE_CONFIGURED, log_table, note, program_table
from fleet_tui.model.programs.program import OLD, ProgramRow, ProgramState, ProgramStatus
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.view.tables.arrangement import NO_MATCH, RowArrangement
from tests.support.diagnostics import text
from tests.support.hostile_text import TEXTS, harmless

RUNNING = ProgramStatus(ProgramState.RUNNING, 100.0, 5.0, 2)


def line(row: ProgramRow, now: float = 100.0) -> str:
    return text(program_table([row], lambda wall: f"at {wall:.0f}", now))[1]


def test_a_row_has_state_time_and_restarts() -> None:
    assert line(ProgramRow("bridge", status=RUNNING)).split() == [
        "bridge",
        "here",
        "●",
        "running",
        "at",
        "5",
        "2",
    ]
    failed = ProgramStatus(ProgramState.FAILED, 100.0, detail=Message("exit status 3"))
    assert line(ProgramRow("nav", "server", status=failed)).endswith(" - exit status 3")


@pytest.mark.parametrize("state", list(ProgramState))
def test_every_state_is_told_in_words(state: ProgramState) -> None:
    assert state.value in line(ProgramRow("p", status=ProgramStatus(state, 100.0)))


def test_a_state_that_is_old_is_unknown_with_its_age() -> None:
    row = ProgramRow("p", status=RUNNING, last_known=RUNNING)
    shown = line(row, 100.0 + OLD + 20)
    assert "? unknown" in shown and "at 5" not in shown
    assert note(row, 100.0 + OLD + 20) == "running 40 s ago; no answer for 40 s"
    lost = ProgramStatus(ProgramState.UNKNOWN, 110.0, detail=Message("server can't be reached"))
    assert (
        note(ProgramRow("p", status=lost, last_known=RUNNING), 112.0)
        == "running 12 s ago; server can't be reached"
    )
    assert note(ProgramRow("p"), 0.0) == "looking ..."
    assert note(ProgramRow("p", status=RUNNING, pending=Message("stop")), 0.0) == "stop is under way ..."


def test_without_programs_it_says_how_to_configure_one() -> None:
    assert "\n".join(text(program_table([], str, 0.0))[1:]) == "\n".join(NONE_CONFIGURED)


@given(TEXTS, TEXTS)
def test_nothing_from_outside_reaches_the_terminal(detail: Message, logged: Message) -> None:
    status = ProgramStatus(ProgramState.FAILED, 0.0, detail=detail)
    assert harmless(line(ProgramRow("p", detail, status=status), 0.0))
    shown = log_table("p", [(1, logged)], logged)
    assert all(map(harmless, text(shown)))


def test_a_log_counts_its_lines_and_says_why_it_is_empty() -> None:
    arrangement = RowArrangement()
    arrangement.typed = "A"
    lines = [(7, "a"), (8, "b")]
    assert text(log_table("nav", lines, EMPTY, arrangement)) == ["Log of nav 2 lines /A: 1", "a"]
    assert log_table("nav", lines, EMPTY).keys == [7, 8]
    assert log_table("nav", lines[1:], EMPTY, arrangement).empty == NO_MATCH
    assert log_table("nav", [], Message("tail: not found")).empty == "tail: not found"
