"""The console's measurements of itself, and its own log."""

from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.view.tables.diagnostics.console import OwnFacts, console_table
from tests.support.diagnostics import text


def test_the_console_on_itself() -> None:
    facts = OwnFacts(0.1, (0.002, 0.2, 0.3), None, 8.0, 1200.0, 3, 90_000_000, 95_000_000, 7, "2 h")
    lines = text(console_table(facts, ["12:00 WARNING a: x", "12:01 ERROR b: y"]))
    assert "2.00 ms, 95 % within 200 ms, max 300 ms  budget 100 ms exceeded" in lines[1]
    assert "not measured yet" in lines[2]
    assert "8.0 frames/s, 1.2 kB/s, 3 held back" in lines[3]
    assert "90.0 MB, peak 95.0 MB" in lines[4] and "7 threads, uptime 2 h" in lines[5]
    assert lines[7:] == ["12:01 ERROR b: y", "12:00 WARNING a: x"]
    arrangement = RowArrangement()
    arrangement.typed = "TW"
    assert text(console_table(facts, ["one", "two"], arrangement=arrangement))[7:] == ["two"]
    arrangement.typed = "three"
    assert text(console_table(facts, ["one", "two"], arrangement=arrangement))[7:] == [
        "nothing matches the filter: Esc clears it"
    ]
