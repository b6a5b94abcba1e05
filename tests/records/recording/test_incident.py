"""The content of an incident's archive, and its notes on missing parts."""

import asyncio
import os
import stat
import time
import zipfile
from pathlib import Path

import pytest

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.schema import Config, Link
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.audit.file import FILE_NAME, audit_file
from fleet_tui.records.audit.log import Audit, encode
from fleet_tui.records.recording.incident import Incident, collect, examined
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.watched_store import config_of


def opened(path: Path) -> dict[str, str]:
    with zipfile.ZipFile(path) as archive:
        return {name: archive.read(name).decode() for name in archive.namelist()}


def test_everything_of_the_last_minutes_is_in_it(tmp_path: Path) -> None:
    audit = Audit(audit_file(tmp_path / FILE_NAME), Origin("ana", "host:1", "run"))
    old = audit.origin.record(1000.0, kind="console", what="console", change="opened", words="long ago")
    audit.file.append(b'{"torn')
    audit.file.append(encode(old))
    audit.log_console("opened", "now")
    (tmp_path / "fleet-tui.log").write_text("a line\n")
    incident = Incident()
    collect(incident, Config(robots=[RobotEntry("robot_0")]), tmp_path, since=2000.0)
    path = incident.write(tmp_path / "incidents")
    found = opened(path)
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert found["fleet-tui.log"] == "a line\n"
    assert '"words":"now"' in found[FILE_NAME]
    assert "long ago" not in found[FILE_NAME]
    assert 'name = "robot_0"' in found["config.toml"].replace('"name"', "name")
    assert "textual" in found["versions.txt"]
    assert all(name in found["README.txt"] for name in found if name != "README.txt")
    assert "missing" not in found["README.txt"]
    assert list((tmp_path / "incidents").iterdir()) == [path]


def test_what_is_missing_is_named_with_the_reason(tmp_path: Path) -> None:
    incident = Incident()
    incident.add_recording("recording.jsonl.gz", [])
    collect(incident, Config(), tmp_path, since=0.0)
    found = opened(incident.write(tmp_path / "incidents"))
    assert "recording.jsonl.gz" not in found
    assert "missing: last minutes" in found["README.txt"]
    (line,) = [line for line in found["README.txt"].splitlines() if line.startswith("fleet-tui.log")]
    assert "missing: end of the log" in line
    assert "No such file" in line


def test_a_clock_that_nobody_has_set_is_no_obstacle(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    then = time.localtime(1000.0)
    monkeypatch.setattr(time, "localtime", lambda *_: then)
    assert opened(Incident().write(tmp_path)).keys() == {"README.txt"}


def test_no_secret_is_in_it(tmp_path: Path) -> None:
    link = Link("ws://ana:SECRET@host:1/?token=SECRET", rosauth_env="SECRET")
    incident = Incident()
    collect(incident, Config(rosbridge=link, robots=[RobotEntry("robot_0")]), tmp_path, since=0.0)
    assert "SECRET" not in "".join(opened(incident.write(tmp_path)).values())


def test_an_archive_is_never_written_over(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(time, "strftime", lambda *_: "20240531-120431")
    packed = [Incident().write(tmp_path).name for _ in range(3)]
    assert packed == [f"incident-20240531-120431{nth}.zip" for nth in ("", "-2", "-3")]
    assert all(opened(tmp_path / name).keys() == {"README.txt"} for name in packed)
    assert len(list(tmp_path.iterdir())) == 3


async def test_the_doctor_looks_in_a_process_of_its_own(server: RosbridgeServer, tmp_path: Path) -> None:
    config = config_of(server.url, 1)
    found = await asyncio.to_thread(examined, config, 60.0, lambda: False)
    assert b"robot_0" in found
    assert b"rosbridge" in found


def test_a_doctor_does_not_outlive_us() -> None:
    with pytest.raises(OSError, match="did not finish"):
        examined(Config(robots=[RobotEntry("robot_0")]), 20.0, lambda: True)


def test_files_of_a_config_are_found_from_elsewhere(tmp_path: Path) -> None:
    config = Config(
        rosbridge=Link(ca_file="ca.pem"),
        floors=[FloorEntry("a", "maps/a.yaml"), FloorEntry("b")],
        robots=[RobotEntry("robot_0")],
        path=tmp_path / "config.toml",
    )
    whole = config.whole()
    assert whole.rosbridge.ca_file == str(tmp_path / "ca.pem")
    assert [floor.map for floor in whole.floors] == [str(tmp_path / "maps/a.yaml"), ""]


def test_the_files_of_a_recording_become_one(tmp_path: Path) -> None:
    gone, first, second = tmp_path / "0", tmp_path / "1", tmp_path / "2"
    first.write_text("older ")
    second.write_text("newer")
    incident = Incident()
    incident.add_recording("recording.jsonl.gz", [gone, first, second])
    assert opened(incident.write(tmp_path))["recording.jsonl.gz"] == "older newer"


def test_the_contents_stand_in_columns(tmp_path: Path) -> None:
    kept = tmp_path / "kept"
    kept.write_text("")
    os.utime(kept, (1e9, 1e9))
    incident = Incident()
    incident.add_recording("robot_server-12345-20260101-000000.jsonl.gz", [kept])
    incident.add("log", "its end", lambda: b"")
    first, second = opened(incident.write(tmp_path))["README.txt"].splitlines()[2:4]
    assert first.index(" last minutes") == second.index(" its end")
    assert " (up to 2001-09-" in first
