"""An incident packed by one key in one place, and looked at in another."""

import zipfile
from pathlib import Path

import pytest

from fleet_tui.config.load import read
from fleet_tui.records.recording.indexing import open_recording
from tests.support.terminal_session import exists, in_terminal

pytestmark = pytest.mark.nightly


def test_what_one_console_packs_another_replays(tmp_path: Path) -> None:
    here, elsewhere = tmp_path / "here", tmp_path / "elsewhere"
    here.mkdir()
    elsewhere.mkdir()
    with in_terminal(here, "demo", "--robots", "2") as running:
        running.shows("robot_1")
        running.shows("●")
        running.press("p")
        running.shows("paused")
        running.press("b")
        running.shows("packing an incident")
        running.shows("packed ")
        running.press("q")
        running.ends()
    (packed,) = (here / "state" / "fleet-tui" / "incidents").iterdir()
    with zipfile.ZipFile(packed) as archive:
        archive.extractall(elsewhere)
    assert "missing" not in (elsewhere / "README.txt").read_text()
    assert "robot_1 pose: " in (elsewhere / "doctor.txt").read_text()
    assert "robot_1" in (elsewhere / "screen.svg").read_text()
    assert '"what":"pause"' in (elsewhere / "audit.jsonl").read_text()
    config, problems = read(elsewhere / "config.toml")
    assert [robot.name for robot in config.robots] == ["robot_0", "robot_1"] and not problems
    assert open_recording(elsewhere / "recording.jsonl.gz").note == ""
    with in_terminal(elsewhere, "replay", str(elsewhere / "recording.jsonl.gz")) as replay:
        replay.shows("REPLAY")
        replay.press("\x1b[F")
        replay.shows("paused")
        replay.press("q")
        replay.ends()


def test_who_leaves_while_it_packs_leaves_nobody_behind(tmp_path: Path) -> None:
    with in_terminal(tmp_path, "demo", "--robots", "2") as running:
        running.shows("robot_1")
        running.shows("●")
        simulator = running.children()
        running.press("b")
        running.shows("packing an incident")
        running.until(lambda: set(running.children()) > set(simulator), 10.0, "the doctor")
        doctor = set(running.children()) - set(simulator)
        running.press("q")
        running.ends()
        running.until(lambda: not any(map(exists, doctor)), what="the doctor's end")
