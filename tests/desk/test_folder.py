"""Files in a folder that others may write."""

import os
import stat
from pathlib import Path

import pytest

from fleet_tui.desk import folder
from fleet_tui.desk.folder import is_held, locked, read_small, replace_shared


def test_a_new_file_is_for_the_group_whatever_the_umask(tmp_path: Path) -> None:
    before = os.umask(0o077)
    try:
        replace_shared(tmp_path / "a", b"1")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "a").stat().st_mode) == 0o660


def test_names_lead_nowhere_else(tmp_path: Path) -> None:
    (tmp_path / "secret").write_bytes(b"x")
    (tmp_path / "link").symlink_to(tmp_path / "secret")
    os.mkfifo(tmp_path / "pipe")
    for name in ("link", "pipe"):
        with pytest.raises(OSError):
            read_small(tmp_path / name, 10)
    (tmp_path / ".b.new").symlink_to(tmp_path / "secret")
    replace_shared(tmp_path / "b", b"2")
    assert (tmp_path / "secret").read_bytes() == b"x" and (tmp_path / "b").read_bytes() == b"2"


def test_a_large_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "large").write_bytes(b"12345")
    with pytest.raises(OSError, match="over 4 bytes"):
        read_small(tmp_path / "large", 4)


def test_a_lock_that_another_holds_is_given_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(folder, "LOCK_WITHIN", 0.02)
    with locked(tmp_path / "lock"):
        assert is_held(tmp_path / "lock")
        with pytest.raises(OSError, match="locked by another console"), locked(tmp_path / "lock"):
            pass
    assert not is_held(tmp_path / "lock") and not is_held(tmp_path / "none")
    with locked(tmp_path / "lock"):
        pass


def test_nothing_is_left_of_a_write_that_failed(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"old")
    with pytest.raises(FileNotFoundError):
        replace_shared(tmp_path / "gone" / "a", b"new")
    assert [path.name for path in tmp_path.iterdir()] == ["a"]
