"""The driver that paints: only where it knows the Textual that is there."""

import pytest

from fleet_tui.ui.terminal import display_driver
from fleet_tui.ui.terminal.display_driver import textual_fits


def test_textual_is_as_the_lean_painting_needs_it(monkeypatch: pytest.MonkeyPatch) -> None:
    assert textual_fits(), "Textual changed: go through display_driver.py, then raise MADE_FOR"
    monkeypatch.setattr(display_driver, "MADE_FOR", "8.2.9")
    assert not textual_fits()
