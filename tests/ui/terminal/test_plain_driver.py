"""On a terminal with only ASCII, the console's own signs are sent as ASCII, cell for cell."""

import sys
from pathlib import Path

import pytest

from fleet_tui.text.ascii_fallback import PLAIN
from fleet_tui.text.sanitize import cell_width
from tests.support.in_pty import Terminal


def test_every_sign_takes_the_same_cells() -> None:
    for sign, plain in PLAIN.items():
        assert cell_width(chr(sign)) == cell_width(str(plain)) == 1
        assert str(plain).isascii()


@pytest.mark.nightly
def test_a_linux_console_is_sent_ascii_alone(tmp_path: Path) -> None:
    text = (
        '[rosbridge]\nurl = "ws://127.0.0.1:9"\n[[floors]]\nname = "floor_0"\n[[robots]]\nname = "robot_0"\n'
    )
    (tmp_path / "config.toml").write_text(text)
    run = f"import os, sys; os.environ['TERM'] = 'linux'; os.execv(sys.executable, {_command(tmp_path)!r})"
    terminal = Terminal([sys.executable, "-c", run], tmp_path)
    try:
        terminal.wait_for("floor_0")
        terminal.wait_for("no link")
        terminal.press("o")
        terminal.wait_for("Robot")
        sent = b"".join(data for _, data in terminal.chunks).decode()
    finally:
        terminal.press("\x1b")
        terminal.close()
    assert [letter for letter in sent if not letter.isascii()] == []


def _command(folder: Path) -> list[str]:
    return [sys.executable, "-m", "fleet_tui", "--config", str(folder / "config.toml")]
