"""A console on the fleet itself: its headline says what holds for it."""

from fleet_tui.controllers.session import ConsoleSession, LiveSession
from fleet_tui.keys import KEYS, Pane
from fleet_tui.model.problem import Permissions
from tests.support.desk import Desk, ready
from tests.support.fleets import R0, text_of


def test_no_key_and_no_line_of_a_recording_means_anything() -> None:
    session: ConsoleSession = LiveSession(Desk(ready()).parts)
    assert {key.pane for key in KEYS if not session.offers(key)} == {Pane.RECORDING}
    assert session.time_line() is None and session.typed("12:00") is None


def test_the_headline_says_what_keeps_commands_here() -> None:
    desk = Desk(ready(), Permissions(read_only=True, armed=False))
    session = LiveSession(desk.parts)
    left, right = session.headline(desk.store.state, R0)
    assert "read-only" in text_of(left) and "not armed" in text_of(left)
    assert "12:00:00" in text_of(right)
