"""After a key its picture comes first, then the tick, then the messages."""

from collections.abc import Callable
from typing import Any

import pytest
from textual.app import App

from fleet_tui.ui.terminal import lean_app
from fleet_tui.ui.terminal.lean_app import WITHIN, KeyAnswer


class Later(App[None]):
    """Keeps what is to be called later."""

    def __init__(self) -> None:
        super().__init__()
        self.later = list[tuple[float, Callable[[], object]]]()

    def set_timer(self, delay: float, callback: Any = None, **_options: Any) -> Any:
        """Keep it."""
        self.later.append((delay, callback))


@pytest.fixture
def turns(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What happens in which order; turns of the screen begin and end."""
    noted = list[str]()
    monkeypatch.setattr(lean_app, "give_turn", lambda: noted.append("begin"))
    monkeypatch.setattr(lean_app, "end_turn", lambda: noted.append("end"))
    return noted


def test_a_tick_runs_at_once_and_alone(turns: list[str]) -> None:
    app = Later()
    KeyAnswer().then(app, lambda: turns.append("tick"))
    assert turns == ["begin", "tick", "end"] and not app.later


def test_a_tick_waits_once_for_the_picture_that_answers_a_key(turns: list[str]) -> None:
    app, key = Later(), KeyAnswer()
    key.asked()
    key.then(app, lambda: turns.append("tick"))
    assert turns == ["begin"]
    ((delay, tick),) = app.later
    assert delay == WITHIN
    key.asked()  # a key that is held puts it off no further
    tick()
    assert turns == ["begin", "begin", "begin", "tick", "end"]


def test_the_picture_ends_the_wait(turns: list[str]) -> None:
    app, key = Later(), KeyAnswer()
    key.asked()
    key.shown()
    key.then(app, lambda: turns.append("tick"))
    assert "tick" in turns and not app.later


def test_a_key_without_a_picture_delays_ticks_for_a_moment_only(
    turns: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    now = 50.0
    monkeypatch.setattr("fleet_tui.ui.terminal.lean_app.time.monotonic", lambda: now)
    app, key = Later(), KeyAnswer()
    key.asked()
    now += WITHIN
    key.then(app, lambda: turns.append("tick"))
    assert "tick" in turns and not app.later
