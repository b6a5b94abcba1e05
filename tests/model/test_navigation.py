"""Reports of navigating robots as text."""

import pytest

from fleet_tui.model.navigation import Blocked, blocked_text


@pytest.mark.parametrize(
    ("action", "words", "stopped"),
    [
        ("stop", "blocked 4.0 s (seen)", True),
        ("slowdown", "slowed by its collision monitor (slowdown)", False),
    ],
)
def test_who_is_held_back_says_how(action: str, words: str, stopped: bool) -> None:
    blocked = Blocked(action, "front", 6.0)
    assert blocked_text(blocked, 10.0) == words and blocked.is_stopped is stopped
