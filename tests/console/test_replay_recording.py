"""`fleet-tui replay`: what is no recording is refused in one line, with what to do."""

import os
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.model.events import TimePassed
from fleet_tui.records.recording.play.times import moment_of
from fleet_tui.records.recording.records import VERSION
from fleet_tui.text.errors import FleetError
from tests.support.command_line import run
from tests.support.fleets import T0
from tests.support.recordings import header, keyframe, written
from tests.support.tapes import MadeUp, shift
from tests.support.watched_store import config_of


def refused(folder: Path, *args: str) -> str:
    done = run("replay", *args, cwd=folder)
    assert done.returncode == 2, done.stderr
    assert done.stdout == "" and "Traceback" not in done.stderr
    (line,) = done.stderr.splitlines()
    return line


def test_what_is_no_recording(tmp_path: Path) -> None:
    (tmp_path / "empty").touch()
    (tmp_path / "text").write_text("hello\n" * 100)
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")
    assert "no such file" in refused(tmp_path, "night") and "fleet-tui record" in refused(tmp_path, "night")
    for name in ("empty", "text", "pipe"):
        assert refused(tmp_path, name).startswith(f"{name}: ")
    assert refused(tmp_path, "folder").startswith("folder: ")


def test_a_newer_format(tmp_path: Path) -> None:
    newer = header()
    path = written(
        tmp_path / "newer.gz",
        [
            type(newer)(VERSION + 1, *(getattr(newer, name) for name in newer.__struct_fields__[1:])),
            keyframe(),
        ],
    )
    assert "newer fleet-tui" in refused(tmp_path, str(path)) and "update" in refused(tmp_path, str(path))


def test_a_time_that_is_not_in_it(tmp_path: Path) -> None:
    path = str(shift(tmp_path / "night.jsonl.gz").path)
    assert "is not a time: use 12:04:31" in refused(tmp_path, path, "--at", "noon")
    assert "is not in the recording, which covers" in refused(tmp_path, path, "--at", "+2h")
    half = Path(path).read_bytes()[:-1]
    Path(path).write_bytes(half)
    assert "(night.jsonl.gz: incomplete" in refused(tmp_path, path, "--at", "+2h")
    done = run("replay", path, "--speed", "1000", cwd=tmp_path)
    assert done.returncode == 2 and "0.25<=x<=64" in done.stderr


def test_a_recording_needs_a_terminal(tmp_path: Path) -> None:
    done = run("replay", str(shift(tmp_path / "night.jsonl.gz").path), "--at", "+10s", cwd=tmp_path)
    assert (done.returncode, done.stderr) == (
        1,
        "fleet-tui: the console needs a terminal for input, output and errors: over SSH use ssh -t\n",
    )


@pytest.fixture
def utc(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    with monkeypatch.context() as patch:
        patch.setenv("TZ", "UTC")
        time.tzset()
        yield
    time.tzset()


@pytest.mark.usefixtures("utc")
def test_times(tmp_path: Path) -> None:
    recording = shift(tmp_path / "night.jsonl.gz")
    seconds = {"+90s": 90, "+90": 90, "+1m30s": 90, "+1 m 30.5 s": 90.5, "+0h2m": 120}
    seconds |= {"22:14:20": 60, "22:14": 40, "2023-11-14T22:13:50": 30, "2023-11-14 23:13:50+01:00": 30}
    for text, second in seconds.items():
        assert moment_of(text, recording) == pytest.approx(T0 + second), text
    for text in ("2023-11-14T21:14:20", "22:13", "22:20", "+1h"):
        with pytest.raises(FleetError, match="is not in the recording"):
            moment_of(text, recording)
    for text in ("", "+", "12", "noon", "25:00", "2023-14-11T10:00", "22:14+05:00", "22:14Z"):
        with pytest.raises(FleetError, match="is not a time"):
            moment_of(text, recording)


@pytest.mark.usefixtures("utc")
def test_times_of_a_clock_that_was_set(tmp_path: Path) -> None:
    """22:13:20 to 22:23:20, then an hour is missing; at 23:33:20 it is set back to 23:18:20."""
    made = MadeUp(config_of("ws://site:9090"))
    for second in range(0, 1801, 10):
        made.tell(second, TimePassed(T0 + second, 1.0))
    made.records = [
        replace(one, wall=one.wall + 3600 * (one.at >= T0 + 600) - 900 * (one.at >= T0 + 1200))
        for one in made.records
    ]
    recording = made.written(tmp_path / "set.jsonl.gz")
    seconds = {"22:20:00": 400, "23:00:00": 600, "23:24:00": 1540, "23:32:50": 1170, "23:20:00": 1300}
    for text, second in seconds.items():
        assert moment_of(text, recording) == pytest.approx(T0 + second), text
