"""Abilities of a terminal: colours unless something rules them out."""

import os

import pytest

from fleet_tui.ui.terminal.detect import has_colour


@pytest.mark.parametrize(
    ("term", "no_color", "colour"),
    [
        ("xterm-256color", None, True),
        ("xterm-256color", "", True),
        ("xterm-256color", "1", False),
        ("dumb", None, False),
        ("vt100", "", False),
    ],
)
def test_when_there_is_colour(
    monkeypatch: pytest.MonkeyPatch, term: str, no_color: str | None, colour: bool
) -> None:
    monkeypatch.setenv("TERM", term)
    monkeypatch.setenv("NO_COLOR", no_color or "")
    if no_color is None:
        monkeypatch.delenv("NO_COLOR")
    assert has_colour() is colour
    assert ("NO_COLOR" in os.environ) is not colour
