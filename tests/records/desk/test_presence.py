"""Presence of consoles: who is there, and who has gone."""

import os
import time
from pathlib import Path

import msgspec
import pytest

from fleet_tui.records.desk import presence as module
from fleet_tui.records.desk.presence import Presence, PresenceFile, PresenceReader, boot_id


def there(folder: Path, boot: str | None = None) -> tuple[PresenceFile, Presence]:
    """Return a console that is at the desk."""
    file = PresenceFile(folder)
    presence = Presence(file.id, "ana", "here", boot_id() if boot is None else boot, "robot_1", ("robot_3",))
    file.keep(presence)
    return file, presence


def test_a_console_is_there_until_it_leaves(tmp_path: Path) -> None:
    file, presence = there(tmp_path)
    reader = PresenceReader(tmp_path)
    assert reader.look() == [presence] == reader.look()
    assert PresenceReader(tmp_path, file.id).look() == []
    file.close()
    assert reader.look() == [] and list(tmp_path.iterdir()) == []


def test_a_console_of_this_machine_has_gone_with_its_lock(tmp_path: Path) -> None:
    file, _ = there(tmp_path)
    file._lock.release()  # as the kernel does for a killed process
    assert PresenceReader(tmp_path).look() == [] and list(tmp_path.iterdir()) == []


def test_a_console_of_another_machine_has_gone_when_its_file_no_longer_changes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file, presence = there(tmp_path, boot="another")
    clock = [time.monotonic()]
    monkeypatch.setattr("fleet_tui.records.desk.presence.time.monotonic", lambda: clock[0])
    reader = PresenceReader(tmp_path)
    assert reader.look() == [presence]
    clock[0] += module.GONE_AFTER + 1
    assert reader.look() == []
    file.keep(presence)
    assert reader.look() == [presence]
    clock[0] += module.FORGOTTEN_AFTER + 1
    assert reader.look() == [] and list(tmp_path.iterdir()) == []


def test_a_console_that_hangs_has_gone_though_it_holds_its_lock(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    _, presence = there(tmp_path)
    clock = [time.monotonic()]
    monkeypatch.setattr("fleet_tui.records.desk.presence.time.monotonic", lambda: clock[0])
    reader = PresenceReader(tmp_path)
    assert reader.look() == [presence]
    clock[0] += module.GONE_AFTER + 1
    assert reader.look() == []


def test_what_a_dead_console_left_does_not_come_to_life(tmp_path: Path) -> None:
    file, _ = there(tmp_path, boot="another")
    os.utime(tmp_path / f"console-{file.id}.json", (1e9, 1e9))
    assert PresenceReader(tmp_path).look() == []


def test_a_file_is_written_when_it_changes_or_is_due(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file, presence = there(tmp_path)
    path = tmp_path / f"console-{file.id}.json"
    first = path.stat().st_ino
    file.keep(presence)
    assert path.stat().st_ino == first
    file.keep(msgspec.structs.replace(presence, robot="robot_2"))
    assert b"robot_2" in path.read_bytes()
    before = path.stat().st_mtime_ns
    monkeypatch.setattr(module, "BEAT", 0.0)
    file.keep(msgspec.structs.replace(presence, robot="robot_2"))
    assert path.stat().st_mtime_ns > before


def test_a_console_whose_files_somebody_removed_comes_back(tmp_path: Path) -> None:
    file, presence = there(tmp_path)
    for path in list(tmp_path.iterdir()):
        path.unlink()
    file.keep(presence)
    assert PresenceReader(tmp_path).look() == [presence]
    file.close()


def test_nobody_speaks_for_another_console(tmp_path: Path) -> None:
    _, presence = there(tmp_path)
    (tmp_path / "console-other.json").write_bytes(msgspec.json.encode(presence))
    reader = PresenceReader(tmp_path)
    assert reader.look() == [presence] and reader.ignored == 1
