"""The file to go back to: the last one that a robot has loaded."""

from pathlib import Path

from fleet_tui.features.graphs.old_files import OldFiles


def test_what_no_robot_has_loaded_does_not_replace_the_file_as_it_was_found(tmp_path: Path) -> None:
    path, old, files = tmp_path / "g", tmp_path / "g.bak", OldFiles()
    path.write_text("found")
    for text in ("first", "second", "second", "third"):
        assert files.is_kept(path, text)
        assert files.save(path, text, is_sent=True) == old
        assert (path.read_text(), old.read_text()) == (text, "found")
    files.save(path, "by hand")  # also by the other key
    assert old.read_text() == "found"


def test_once_a_robot_has_loaded_a_file_it_is_the_one_to_go_back_to(tmp_path: Path) -> None:
    path, old, files = tmp_path / "g", tmp_path / "g.bak", OldFiles()
    path.write_text("found")
    files.save(path, "first", is_sent=True)
    files.save(path, "second", is_sent=True)
    files.loaded(path, "first")  # late: another file is there by now
    files.save(path, "third", is_sent=True)
    assert old.read_text() == "found"
    files.loaded(path, "third")
    assert not files.is_kept(path, "third") and files.save(path, "third", is_sent=True) is None
    files.save(path, "fourth", is_sent=True)
    assert old.read_text() == "third"


def test_an_old_file_that_was_put_back_is_kept_again(tmp_path: Path) -> None:
    path, old, files = tmp_path / "g", tmp_path / "g.bak", OldFiles()
    path.write_text("found")
    files.save(path, "first", is_sent=True)
    old.rename(path)
    assert files.save(path, "second", is_sent=True) == old and old.read_text() == "found"


def test_without_a_file_before_there_is_none_to_go_back_to(tmp_path: Path) -> None:
    path, files = tmp_path / "g", OldFiles()
    for text in ("first", "second"):
        assert not files.is_kept(path, text)
        assert files.save(path, text, is_sent=True) is None
    assert not (tmp_path / "g.bak").exists()
