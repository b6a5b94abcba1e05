"""Copies to the terminal's clipboard."""

import pytest

from fleet_tui.ui.terminal.clipboard import clipboard, copied_text


def test_the_text_is_encoded_whatever_it_holds() -> None:
    assert clipboard("robot_0 \x1b]52;c;aGFja2Vk\x07") == ("\x1b]52;c;cm9ib3RfMCAbXTUyO2M7YUdGamEyVmsH\x07")
    assert clipboard("\udcff").startswith("\x1b]52;c;")


def test_tmux_needs_a_setting(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("TMUX", raising=False)
    assert copied_text("a row") == "copied to the clipboard: a row"
    monkeypatch.setenv("TMUX", "1")
    assert "set-clipboard on" in copied_text("a row")
