"""One holder at a time, and the next one as soon as it ends."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from fleet_tui.storage.handles import open_private, open_shared
from fleet_tui.storage.lock import LockFile, is_locked, lock, owner_of

HOLDER = """
import sys, time
from pathlib import Path
from fleet_tui.storage.lock import LockFile
print(LockFile(Path(sys.argv[1])).take("ana@host"), flush=True)
time.sleep(60)
"""


def test_one_holds_it_until_it_lets_go(tmp_path: Path) -> None:
    path = tmp_path / "state" / "lock"
    first, second = LockFile(path), LockFile(path)
    assert owner_of(path) is None
    assert first.take("ana") and first.take("ana") and first.is_held
    assert not second.take("eva") and not second.is_held and owner_of(path) == "ana"
    first.release()
    assert not first.is_held and owner_of(path) is None
    assert second.take("eva") and owner_of(path) == "eva"


def test_a_killed_process_lets_go(tmp_path: Path) -> None:
    path = tmp_path / "lock"
    with subprocess.Popen([sys.executable, "-c", HOLDER, str(path)], stdout=subprocess.PIPE) as holder:
        assert holder.stdout is not None and holder.stdout.readline() == b"True\n"
        assert owner_of(path) == "ana@host" and not LockFile(path).take()
        holder.send_signal(signal.SIGKILL)
    assert owner_of(path) is None and LockFile(path).take()


def test_a_lock_whose_file_was_removed_holds_nobody_off(tmp_path: Path) -> None:
    first, second = LockFile(tmp_path / "lock"), LockFile(tmp_path / "lock")
    assert first.take()
    (tmp_path / "lock").unlink()
    assert not first.is_held
    assert second.take() and not first.take()


def test_without_a_folder_there_is_none(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError):
        LockFile(tmp_path / "file" / "lock").take()


def test_it_is_waited_for_as_long_as_was_said(tmp_path: Path) -> None:
    first, second = (open_private(tmp_path / "lock", os.O_RDWR | os.O_CREAT) for _ in range(2))
    assert lock(first) and not lock(second, within=0.01) and is_locked(second)
    os.close(first)
    assert lock(second, within=0.01)
    os.close(second)


def test_where_files_can_not_be_locked_nobody_gets_a_lock_and_each_is_taken_for_held(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(_handle: int, _kind: int) -> None:
        raise OSError(37, "No locks available")

    assert LockFile(tmp_path / "lock").take("ana")
    monkeypatch.setattr("fleet_tui.storage.lock.fcntl.flock", refuse)
    with pytest.raises(OSError, match="No locks"):
        LockFile(tmp_path / "lock").take("eva")
    assert owner_of(tmp_path / "lock") == "ana"


@pytest.mark.parametrize("opening", [open_private, open_shared])
def test_no_name_blocks_and_the_shared_one_leads_nowhere_else(tmp_path: Path, opening: object) -> None:
    os.mkfifo(tmp_path / "lock")
    held = LockFile(tmp_path / "lock", open_shared if opening is open_shared else open_private)
    with pytest.raises(OSError, match="not a regular file"):
        held.take()
    (tmp_path / "secret").write_bytes(b"x")
    (tmp_path / "link").symlink_to(tmp_path / "secret")
    with pytest.raises(OSError):
        LockFile(tmp_path / "link", open_shared).take("eva")
    assert (tmp_path / "secret").read_bytes() == b"x"
