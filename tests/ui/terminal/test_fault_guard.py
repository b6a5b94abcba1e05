"""Faults of our own: logged once, told as text, and survived up to a limit."""

import pytest

from fleet_tui.ui.terminal.fault_guard import MOST_FAILED_TICKS, FaultGuard

pytestmark = pytest.mark.own_faults


def failing(words: str = "broken") -> None:
    raise RuntimeError(words)


def test_ticks_that_fail_in_a_row_end_it_and_one_that_works_begins_anew() -> None:
    guard = FaultGuard(lambda _note: None)
    for _ in range(2):
        for _ in range(MOST_FAILED_TICKS - 1):
            guard.steadily(failing)
        guard.steadily(lambda: None)
    for _ in range(MOST_FAILED_TICKS - 1):
        guard.steadily(failing)
    with pytest.raises(RuntimeError):
        guard.steadily(failing)


def test_the_same_fault_is_logged_once_and_told_each_time(caplog: pytest.LogCaptureFixture) -> None:
    notes: list[str] = []
    guard = FaultGuard(notes.append)
    for words in ("one", "one", "two"):
        guard.steadily(lambda words=words: failing(words))  # type: ignore[misc]  # mypy reads no default here
    assert [record.exc_text for record in caplog.records] == [record.exc_text for record in caplog.records]
    assert len(caplog.records) == 2
    assert notes == [f"internal error: {words} (see the log file)" for words in ("one", "one", "two")]


@pytest.mark.parametrize(
    ("problem", "told"),
    [(ValueError("\x1b[2J"), "\\x1b"), (ValueError(), "ValueError"), (ValueError("a" * 9999), "characters)")],
)
def test_the_text_of_a_fault_acts_on_no_terminal(problem: Exception, told: str) -> None:
    notes: list[str] = []
    FaultGuard(notes.append).worker_failed(problem)
    assert "\x1b" not in notes[0] and len(notes[0]) < 1000
    assert told in notes[0] or "[2J" in notes[0]


def test_an_action_is_named_by_its_key(caplog: pytest.LogCaptureFixture) -> None:
    notes: list[str] = []
    FaultGuard(notes.append).action_failed("screen.key('pause')", RuntimeError("no robot"))
    assert notes == ["internal error: no robot (see the log file)"]
    assert caplog.records[0].getMessage() == "action pause"
