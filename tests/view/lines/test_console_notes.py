"""What the console says of itself."""

from fleet_tui.view.lines.status import console_notes
from tests.support.fleets import fleet


def test_a_calm_console_says_nothing() -> None:
    assert console_notes(fleet(), read_only=False, armed=True, standstill=0.1) == []


def test_what_holds_is_said() -> None:
    assert console_notes(fleet(), read_only=True, armed=False, standstill=0.0) == ["read-only", "not armed"]


def test_a_console_gone_blind_says_so() -> None:
    (note,) = console_notes(fleet(), read_only=False, armed=True, standstill=7.2)
    assert note == "no updates for 7 s: restart this console"
