"""The real console in a pty, on a fleet that tries to speak to the terminal: nothing of it gets through."""

import re
import sys
import time
import unicodedata
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from fleet_tui.text.sanitize import sanitize
from tests.support.hostile_fleet import CLIPBOARD, EVIL, ROBOTS
from tests.support.in_pty import Terminal, serving

pytestmark = pytest.mark.nightly

EVIL_NAME = r"evil\u001b]52;c;aGFja2Vk\u0007\u202e[red]"
"""As TOML writes it."""
SHOWN = "evil␛]52;c;aGFja2Vk␇\ufffd[red]"
MODES = "1000|1003|1004|1006|1015|1049|2004|2026|2048|25|7"
KNOWN = re.compile(
    rf"""
    \x1b\[[\d;]*m                               # how a cell looks
    | \x1b\[\d+;\d+H | \x1b\[\d*C               # where the cursor is
    | \x1b\[\?({MODES})[hl] | \x1b\[\?(2026|2048)\$p
    | \x1b\[>\d+u | \x1b\[<u | \x1b\[=0;1u      # how keys are to be told
    | \x1b\]9;fleet-tui:\ [^\x00-\x1f\x7f-\x9f]*\x1b\\ | \x07  # [alarms] notify and bell
    | \x1b\]22;[a-z]*\x07                       # the shape of the pointer
    | \r\n                                      # between the rows of the first picture
    """,
    re.VERBOSE,
)
"""All that this console ever sends beside characters."""


@contextmanager
def hostile_console(home: Path) -> Iterator[Terminal]:
    """A console whose config, themes and fleet are all hostile."""
    themes = home / "fleet-tui" / "themes"
    themes.mkdir(parents=True)
    (themes / "evil\x1b]52;c;eA==\x07\u202e[red].toml").write_text("")
    robots = "".join(f'[[robots]]\nname = "robot_{n}"\n' for n in range(ROBOTS))
    with serving("tests.support.hostile_fleet") as (url, _):
        (home / "config.toml").write_text(
            f'[rosbridge]\nurl = "{url}"\n[operator]\nname = "{EVIL_NAME}"\n'
            f'[links."{EVIL_NAME}"]\nurl = "ws://127.0.0.1:1"\n'
            f'[[floors]]\nname = "floor_0"\n[[floors]]\nname = "floor_1"\nmap = "{EVIL_NAME}.yaml"\n'
            f'{robots}[[robots]]\nname = "lost"\nlink = "{EVIL_NAME}"\n'
            '[alarms]\nbell = ["high", "medium", "low"]\nnotify = ["high", "medium", "low"]\n'
        )
        command = [sys.executable, "-m", "fleet_tui", "--config", str(home / "config.toml")]
        terminal = Terminal(command, home)
        try:
            yield terminal
        finally:
            terminal.close()


def harmless(text: str) -> bool:
    return not {unicodedata.category(letter) for letter in text} & {"Cc", "Cf", "Cs", "Co", "Cn"}


def rows(terminal: Terminal) -> list[str]:
    """A character per cell; the second half of a wide one is a `~`."""
    terminal.text()
    screen = terminal._screen
    return [
        "".join((screen.buffer[y][x].data or "~")[0] for x in range(screen.columns))
        for y in range(screen.lines)
    ]


def look(terminal: Terminal, *texts: str) -> None:
    """Wait for texts, and see that nothing on the screen is out of its place."""
    for text in texts:
        terminal.wait_for(text)
    shown = rows(terminal)
    assert all(harmless(row) for row in shown), shown
    for aligned in (("─ Fleet", "─ Alarms", "─ Queue"), ("[Cancel]",)):
        places = {row.find(text) for row in shown for text in aligned} - {-1}
        assert len(places) <= 1, "\n".join(shown)
    assert shown[-1].rstrip().endswith(("command", "messages", "pause all", "quit"))


def leave(terminal: Terminal, text: str, key: str = "\x1b") -> None:
    """Close what is open, and wait until its text has gone: an Esc and what follows it would be one key."""
    terminal.press(key)
    end = time.monotonic() + 10
    while text in terminal.text():
        assert time.monotonic() < end, f"still there: {text}"
        time.sleep(0.05)


def through_the_panes(terminal: Terminal) -> None:
    look(terminal, "6 of 7 online", f"{SHOWN[:14]}…", "12 orders", "[red]markup[/red]", "no link", "▲ new")
    terminal.press("m")
    terminal.press("}")
    look(terminal, f"map {SHOWN}.yaml: no such file")
    terminal.press("{")
    terminal.press("]")
    look(terminal, "robot_1 is on unknown floor")
    terminal.press("[")
    terminal.press("\t\r")
    look(terminal, "Explain why it")
    leave(terminal, "Explain why it")
    terminal.press("\t\r")
    look(terminal, "Shelve for")
    leave(terminal, "Shelve for")


def through_the_commands(terminal: Terminal) -> None:
    terminal.press("o52;c")
    look(terminal, "52;c", "␛]52;c;aGFja2Vk␇Dispatch")
    terminal.press("\r")
    terminal.press("0;title")
    look(terminal, "␛]0;title␛\\ ␛P+q544e␛\\Receiving")
    terminal.press("\r")
    look(terminal, "refused (REJECTED: ")
    terminal.press_later("p")
    look(terminal, f"responded with an error: {sanitize(CLIPBOARD)}")
    terminal.press("x")
    look(terminal, "Cancel order")
    leave(terminal, "Cancel order")
    terminal.press("X")
    look(terminal, "Clear all 12 orders of robot_0?", "-> ␛]0;title")
    leave(terminal, "Clear all 12")


OPENS = (
    (":theme: evil", "Theme: evil␛]52;c;eA==␇\ufffd[red]", "\x1b"),
    ("?", "Send an order", "\x1b"),
    ("w", "Why: robot_", "\x1b"),
    ("L", "evil␛]52;… robot_0 pause: outcome unknown", "\x1b"),
    ("d1", "too large, or queue full", "\x1b"),
    ("d2", "▲ bad data", "\x1b"),
    ("d4\x1b", "INFO  ␛]52;c;aGFja2Vk␇", "\x1b"),
    ("d5", f"▲ WARN    {sanitize(EVIL[0])}", "\x1b"),
    ("d6", "log, newest first: ", "\x1b"),
    ("s", "Robot: robot_", "s"),
)


def through_what_opens(terminal: Terminal) -> None:
    pasted = "".join(EVIL[:11]).replace("\n", "").replace("\r", "") + "PASTED"
    for keys, sees, closes in OPENS:
        terminal.press(keys)
        look(terminal, sees)
        if keys[0] in ":?L":
            terminal.press(f"\x1b[200~{pasted}\x1b[201~")
            look(terminal, sees := "PASTED")
        leave(terminal, sees, closes)
    terminal.press("s")
    look(terminal, "From: choose")
    terminal.press("\r")
    look(terminal, "From where?", sanitize(EVIL[0]))
    terminal.press("\r")
    look(terminal, "From:")


def test_nothing_that_robots_or_files_say_speaks_to_the_terminal(tmp_path: Path) -> None:
    with hostile_console(tmp_path) as terminal:
        through_the_panes(terminal)
        through_the_commands(terminal)
        through_what_opens(terminal)
        terminal.press("s")
    sent = b"".join(data for _, data in terminal.chunks).decode()
    assert "\x1b]9;fleet-tui: " in sent
    left = KNOWN.sub("", sent)
    assert harmless(left), sorted(set(re.findall(r"[\x00-\x1f\x7f-\x9f].{0,20}", left)))
    log = (tmp_path / "fleet-tui" / "fleet-tui.log").read_text()
    assert "bridge: " in log and harmless(log.replace("\n", ""))
