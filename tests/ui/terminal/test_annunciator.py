"""Which bytes call a person, and when."""

import pytest
from msgspec.structs import replace
from textual.app import ComposeResult
from textual.widgets import Static

from fleet_tui.config.schema import Alarms
from fleet_tui.model import events
from fleet_tui.model.desk import events as desk_events
from fleet_tui.model.fleet import FleetState
from fleet_tui.ui.terminal.annunciator import Annunciator, notification
from fleet_tui.ui.terminal.lean_app import LeanApp
from tests.support.fleets import R0, T0, battery, fleet, link_up, reduced, tick
from tests.support.terminal import PlayedDriver, paint, shown, terminal_of

ALL = ["high", "medium", "low"]


class Wire:
    """The output to the terminal, which can be set to refuse it."""

    def __init__(self, bell: list[str], notify: list[str]) -> None:
        self.sent: list[str] = []
        self.takes = True
        self._annunciator = Annunciator(Alarms(bell=bell, notify=notify), self._send)

    def _send(self, sequence: str) -> bool:
        if self.takes:
            self.sent.append(sequence)
        return self.takes

    def look(self, *states: FleetState) -> list[str]:
        for state in states:
            self._annunciator.look(state)
        return self.sent


@pytest.fixture(autouse=True)
def plain_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("TMUX", raising=False)
    monkeypatch.setenv("TERM", "xterm-256color")


def contact(at: float, seconds: float = 44.2) -> events.ObstacleReported:
    return events.ObstacleReported(R0, at, seconds)


def in_the_way() -> FleetState:
    """One alarm; the other robots' silence is none."""
    state = fleet(20)
    state = replace(state, limits=replace(state.limits, offline_after=1e6))
    return reduced(state, link_up(T0), contact(T0), tick(T0))


def test_by_default_it_is_calm() -> None:
    assert Wire([], []).look(in_the_way()) == []
    assert (Alarms().bell, Alarms().notify) == ([], [])


def test_the_bell_rings_once_for_each_alarm_raised() -> None:
    wire, state = Wire(["high"], []), in_the_way()
    assert wire.look(fleet(20), state, state, reduced(state, tick(T0 + 20))) == ["\x07"]
    state = reduced(
        state, desk_events.AlarmAcknowledged(), tick(T0 + 21), contact(T0 + 22, 0.0), tick(T0 + 30)
    )
    assert wire.look(state) == ["\x07"]
    state = reduced(state, contact(T0 + 31), tick(T0 + 31))
    assert wire.look(state, state) == ["\x07", "\x07"]


def test_other_priorities_are_quiet() -> None:
    low = reduced(fleet(), battery(T0, 15.0), tick(T0))
    assert Wire(["high", "medium"], ["high"]).look(low) == []
    assert Wire(["low"], []).look(low) == ["\x07"]


def test_the_notification_names_the_worst() -> None:
    state = reduced(in_the_way(), battery(T0, 15.0, "robot_1"), tick(T0 + 0.1))
    text = "\x1b]9;fleet-tui: robot_0 obstacle 44 s and 1 more\x1b\\"
    assert Wire(["low"], ALL).look(state) == ["\x07" + text]


def test_a_flood_is_one_call_and_what_follows_soon_another() -> None:
    state = in_the_way()
    wire = Wire(ALL, [])
    wire.look(state)
    for n in range(1, 19):
        state = reduced(state, battery(T0, 15.0, f"robot_{n}"), tick(T0 + n / 5))
        wire.look(state)
    assert wire.sent == ["\x07"]
    assert wire.look(reduced(state, tick(T0 + 5))) == ["\x07", "\x07"]


def test_what_was_acknowledged_meanwhile_calls_nobody() -> None:
    state = in_the_way()
    wire = Wire(ALL, [])
    wire.look(state, reduced(state, battery(T0, 15.0, "robot_1"), tick(T0 + 1)))
    wire.look(reduced(state, battery(T0, 15.0, "robot_1"), tick(T0 + 1), desk_events.AlarmAcknowledged()))
    assert wire.look(reduced(state, desk_events.AlarmAcknowledged(), tick(T0 + 9))) == ["\x07"]


def test_a_terminal_that_does_not_read_is_called_when_it_does() -> None:
    wire, state = Wire(ALL, []), in_the_way()
    wire.takes = False
    assert wire.look(state, reduced(state, tick(T0 + 0.1))) == []
    wire.takes = True
    assert wire.look(reduced(state, tick(T0 + 0.2)), reduced(state, tick(T0 + 0.3))) == ["\x07"]


@pytest.mark.parametrize("text", ["\x07\x1b]0;x\x07", "a\x1b\\b\x9cc\x9d9;d", "\x1bPtmux;\x1b", "x" * 9999])
@pytest.mark.parametrize("inside_tmux", [True, False])
def test_text_from_the_wire_ends_no_sequence(text: str, inside_tmux: bool) -> None:
    sequence = notification(text, inside_tmux)
    escape = "\x1b\x1b" if inside_tmux else "\x1b"
    head, tail = f"{escape}]9;fleet-tui: ", f"{escape}\\"
    if inside_tmux:
        head, tail = f"\x1bPtmux;{head}", f"{tail}\x1b\\"
    assert sequence.startswith(head) and sequence.endswith(tail)
    inside = sequence[len(head) : -len(tail)]
    assert all(letter.isprintable() for letter in inside) and len(inside) <= 200


def test_in_tmux_it_is_handed_on_and_the_linux_console_gets_none(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TMUX", "/tmp/tmux-1000/default,1,0")
    (sequence,) = Wire([], ALL).look(in_the_way())
    assert sequence == "\x1bPtmux;\x1b\x1b]9;fleet-tui: robot_0 obstacle 44 s\x1b\x1b\\\x1b\\"
    monkeypatch.setenv("TERM", "linux")
    assert Wire([], ALL).look(in_the_way()) == []


class Pane(LeanApp):
    def __init__(self) -> None:
        super().__init__(driver_class=PlayedDriver)

    def compose(self) -> ComposeResult:
        yield Static("calm")


async def test_a_call_goes_to_the_terminal_and_changes_nothing_there() -> None:
    app = Pane()
    async with app.run_test(headless=False, size=(40, 5)) as pilot:
        await pilot.pause()
        paint(app)
        terminal = terminal_of(app)
        before = shown(terminal)
        sequence = "\x07" + notification("robot_0 obstacle 44 s", inside_tmux=False)
        assert app.output.call(sequence)
        assert terminal.written[-1] == sequence
        assert shown(terminal) == before
        terminal.reads = False
        terminal.write("x")
        assert not app.output.call("\x07")
        terminal.read_again()
