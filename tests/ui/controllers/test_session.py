"""A console on the fleet itself: its headline says what holds for it."""

from fleet_tui.keys import KEYS, Pane
from fleet_tui.model.events import PausedReported
from fleet_tui.model.problem import Permissions
from fleet_tui.ui.controllers.session import ConsoleSession, LiveSession
from tests.support.desk import Desk, ready
from tests.support.fleets import R0, T0, pose, reduced, text_of, tick


def session_of(desk: Desk) -> LiveSession:
    return LiveSession(desk.console(), lambda: False)


def test_no_key_and_no_line_of_a_recording_means_anything() -> None:
    session: ConsoleSession = session_of(Desk(ready()))
    assert {key.pane for key in KEYS if not session.offers(key)} == {Pane.RECORDING}
    assert session.time_line() is None and session.typed("12:00") is None


def test_the_headline_says_what_keeps_commands_here() -> None:
    desk = Desk(ready(), Permissions(read_only=True, armed=False))
    session = session_of(desk)
    left, right = session.headline(desk.store.state, R0, 120)
    assert "read-only" in text_of(left) and "not armed" in text_of(left)
    assert "12:00:00" in text_of(right)


def test_the_way_back_from_all_paused_is_shown_where_it_fits_and_may_be_gone() -> None:
    stands = pose(T0 + 1.4)
    paused = reduced(ready(), stands, PausedReported(R0, T0 + 1.4, True), tick(T0 + 1.5))

    def headline(width: int, permissions: Permissions | None = None) -> str:
        return text_of(session_of(Desk(paused, permissions)).headline(paused, R0, width)[0])

    fitting = headline(300)
    assert "ALL PAUSED, R resumes all  " in fitting
    assert headline(len(fitting)) == fitting
    assert "ALL PAUSED  " in headline(len(fitting) - 1)
    assert "resume" not in headline(300, Permissions(read_only=True)) + headline(
        300, Permissions(armed=False)
    )
