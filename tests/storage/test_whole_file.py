"""Files are written whole or not at all."""

import os
import stat
from pathlib import Path

import pytest

from fleet_tui.storage.whole_file import replace_shared, replacing, write_whole


def test_a_new_file_is_for_its_owner_and_a_shared_one_has_the_mode_of_the_one_before(tmp_path: Path) -> None:
    own, shared = tmp_path / "own", tmp_path / "shared"
    assert write_whole(own, b"1") is None
    assert own.stat().st_mode & 0o777 == 0o600
    shared.write_bytes(b"0")
    shared.chmod(0o664)
    assert write_whole(shared, b"1", keep=True, is_shared=True) == tmp_path / "shared.bak"
    assert shared.stat().st_mode & 0o777 == 0o664
    assert (shared.read_bytes(), (tmp_path / "shared.bak").read_bytes()) == (b"1", b"0")


def test_what_fails_leaves_the_file_before_and_nothing_else(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.mkdir()
    (path / "inside").write_bytes(b"0")
    with pytest.raises(OSError, match="directory"):
        write_whole(path, b"1")
    assert [one.name for one in tmp_path.iterdir()] == ["file"]


def test_a_link_with_the_name_of_the_old_version_is_replaced_not_followed(tmp_path: Path) -> None:
    path, victim = tmp_path / "graph", tmp_path / "victim"
    path.write_bytes(b"old")
    victim.write_bytes(b"mine")
    kept = tmp_path / "graph.bak"
    kept.symlink_to(victim)
    assert write_whole(path, b"new", keep=True) == kept
    assert (victim.read_bytes(), kept.read_bytes(), kept.is_symlink()) == (b"mine", b"old", False)
    assert sorted(one.name for one in tmp_path.iterdir()) == ["graph", "graph.bak", "victim"]


def test_a_shared_file_is_for_the_group_whatever_the_umask_and_what_has_its_name_is_replaced(
    tmp_path: Path,
) -> None:
    (tmp_path / "secret").write_bytes(b"x")
    (tmp_path / "a").symlink_to(tmp_path / "secret")
    before = os.umask(0o077)
    try:
        replace_shared(tmp_path / "a", b"1")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "a").lstat().st_mode) == 0o660
    assert (tmp_path / "a").read_bytes() == b"1" and (tmp_path / "secret").read_bytes() == b"x"


def test_nothing_is_left_of_a_block_that_failed(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"old")
    with pytest.raises(ValueError), replacing(tmp_path / "a") as file:
        file.write(b"new")
        raise ValueError
    assert [path.name for path in tmp_path.iterdir()] == ["a"] and (tmp_path / "a").read_bytes() == b"old"
