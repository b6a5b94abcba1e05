"""The console's own faults: what they cost, and a search for some."""

from pathlib import Path

from tests.support.fault_report import report
from tests.support.monkey import DEMO, play
from tests.support.terminal_session import exists, in_terminal

BREAKS = """
import os
import fleet_tui.ui.view.tables.fleet as rows
real = rows.fleet_table

def fleet_table(*args):
    if os.path.exists(os.environ["BREAKS"]):
        raise RuntimeError("broken \\x1b]52;c;QQ==\\x07 here")
    return real(*args)

rows.fleet_table = fleet_table
"""


def test_the_console_itself_is_broken(tmp_path: Path) -> None:
    """The picture would soon be old: it ends, with its traceback where it tears no screen."""
    (tmp_path / "sitecustomize.py").write_text(BREAKS)
    breaks, log = tmp_path / "breaks", tmp_path / "state" / "fleet-tui" / "fleet-tui.log"
    with in_terminal(tmp_path, "demo", PYTHONPATH=str(tmp_path), BREAKS=str(breaks)) as running:
        running.shows("robot_1")
        simulator = running.children()
        breaks.touch()
        took = running.ends()
        assert running.child.returncode == 1
        running.until(lambda: not any(map(exists, simulator)), what="the simulator's end")
        after = running.sent.rpartition(b"\x1b[?1049l")[2].decode()
        words = "fleet-tui: internal error: broken ␛]52;c;QQ==␇ here"
        # Folded between words to the terminal's width.
        assert f"{words} (details in {log}, or with --debug)" in " ".join(after.split())
        lines = log.read_text()
        assert "Traceback" in lines and "in fleet_table" in lines and "\x1b" not in lines
    report(
        "internal error",
        "drawing raises an exception for a second",
        f"the shell, `{words[:26]} ...`",
        took,
        None,
    )


def test_keys_at_random(tmp_path: Path) -> None:
    """A short form of `python -m tests.support.monkey`."""
    with in_terminal(tmp_path, *DEMO) as running:
        running.shows("robot_5")
        moves = play(running, 8.0, 0)
    assert moves > 50
    report("keys at random", "keys, mouse, pastes, resizing; robots with faults", "keeps working", None, None)


def test_what_others_wrote_over_an_open_dialog_is_painted_over(tmp_path: Path) -> None:
    with in_terminal(tmp_path, "demo") as running:
        running.shows("robot_1")
        running.press("?")
        running.shows("type to search")
        running.forget()
        running.press("\x0c")
        running.until(
            lambda: "alarm" in running.text().splitlines()[0], 5.0, "the line that is always in view"
        )
        running.shows("type to search")
