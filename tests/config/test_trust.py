"""Whose files count: real owners, modes, groups, links and folders on the way."""

import os
from functools import partial
from pathlib import Path

import pytest

from fleet_tui.config import trust
from fleet_tui.config.trust import accept, doubt, doubt_of_content, memory, saying_yes, written_file
from tests.support.users import EVE, as_eve, give, two_users


@pytest.fixture
def file(tmp_path: Path) -> Path:
    """A file of one's own; the folder of the test can be entered by everybody."""
    path = tmp_path / "in" / "config.toml"
    path.parent.mkdir(mode=0o755)
    path.write_text("")
    path.chmod(0o644)
    for folder in (tmp_path, *tmp_path.parents):
        if folder.stat().st_uid == os.getuid() and folder.name.startswith(("pytest", "test", "popen")):
            folder.chmod(0o755)
    return path


def test_ones_own_file_is_safe(file: Path) -> None:
    assert doubt(file) == ""


@two_users
def test_a_file_of_root_is_safe_for_everybody_and_that_of_eve_for_her(file: Path) -> None:
    assert as_eve(partial(doubt, file)) == ""
    give(file)
    assert as_eve(partial(doubt, file)) == ""
    assert doubt(file) == f"{file} is not owned by root: chown root {file}"


@two_users
def test_a_folder_on_the_way_that_is_another_users(file: Path) -> None:
    give(file.parent)
    assert doubt(file) == f"{file.parent} is not owned by root: chown root {file.parent}"


def test_modes_of_file_and_folder(file: Path) -> None:
    file.chmod(0o646)
    assert doubt(file) == f"{file} is writable by everyone: chmod o-w {file}"
    file.chmod(0o644)
    file.parent.chmod(0o757)
    assert doubt(file) == f"{file.parent} is writable by everyone: chmod o-w {file.parent}"


def test_a_group_of_ones_own_is_safe_and_one_with_others_is_not(
    file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file.chmod(0o664)
    own = trust.user_name(os.geteuid())
    monkeypatch.setattr(trust, "members", lambda _group: {own, "root"})
    assert doubt(file) == ""
    monkeypatch.setattr(trust, "members", lambda _group: {own, "eve"})
    assert doubt(file) == f"{file} is writable by others: chmod g-w {file}"


@two_users
def test_the_members_of_a_group_are_those_by_login_and_an_unknown_group_is_not_safe(file: Path) -> None:
    file.chmod(0o664)
    os.chown(file, 0, EVE)  # nobody's own group
    assert "writable by others" in doubt(file)
    os.chown(file, 0, 4_000_000)
    assert "writable by others" in doubt(file)


@two_users
def test_in_a_sticky_folder_ones_own_files_are_safe_alone(file: Path) -> None:
    file.parent.chmod(0o1777)
    assert doubt(file) == ""
    missing = file.with_name("missing")
    assert doubt(missing).startswith(f"{missing} does not exist, and others could make it: {file.parent} is")
    give(file)
    assert "is not owned by root" in doubt(file)


@two_users
def test_links_count_with_their_owner_and_their_whole_way(file: Path, tmp_path: Path) -> None:
    shared = tmp_path / "shared"
    shared.mkdir()
    shared.chmod(0o1777)
    link = shared / "link.toml"
    link.symlink_to("../in/config.toml")
    assert doubt(link) == ""
    give(link)
    assert doubt(link) == f"{link} is not owned by root: chown -h root {link}"
    os.chown(link, 0, 0, follow_symlinks=False)
    shared.chmod(0o777)
    assert doubt(link) == f"{shared} is writable by everyone: chmod o-w {shared}"
    shared.chmod(0o755)
    give(file)
    assert doubt(link) == f"{file} is not owned by root: chown root {file}"


def test_links_in_a_circle_end(tmp_path: Path) -> None:
    (tmp_path / "a").symlink_to("b")
    (tmp_path / "b").symlink_to("a")
    assert doubt(tmp_path / "a") == ""


@two_users
def test_the_folder_of_a_group_may_be_anybodys_of_it_and_not_everybodys(file: Path) -> None:
    folder = file.parent / "desk"
    folder.mkdir()
    give(folder)
    folder.chmod(0o2770)
    assert doubt(folder) and doubt(folder, is_for_group=True) == ""
    folder.chmod(0o2777)
    assert doubt(folder, is_for_group=True) == f"{folder} is writable by everyone: chmod o-w {folder}"
    os.chown(folder, EVE, 0)
    folder.chmod(0o2770)
    assert "is not owned by root" in doubt(folder, is_for_group=True)


def test_a_yes_holds_for_this_content_in_this_place(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(file.parent))
    file.chmod(0o646)
    accept(file, "a")
    assert doubt_of_content(file, "a") and not memory().exists()
    with saying_yes():
        accept(file, "a")
    assert doubt_of_content(file, "a") == "" and doubt_of_content(file, "b")
    other = file.with_name("other.toml")
    other.touch()
    other.chmod(0o646)
    assert doubt_of_content(other, "a")
    monkeypatch.setattr(trust, "_trusted", set())  # as in the next process
    assert doubt_of_content(file, "a") == "" and memory().stat().st_mode & 0o777 == 0o600
    memory().chmod(0o646)
    assert doubt_of_content(file, "a")


@pytest.mark.parametrize("exists", [True, False])
def test_a_link_that_others_could_have_made_is_not_written_through(file: Path, exists: bool) -> None:
    link, victim = file.parent / "graph.geojson", file.parent.parent / "victim"
    link.symlink_to(victim)
    if exists:
        victim.write_text("mine")
    assert written_file(link) == victim
    file.parent.chmod(0o757)
    with pytest.raises(OSError, match="a link that another user could have made"):
        written_file(link)
    assert written_file(file) == file, "what is no link is replaced in its place"
