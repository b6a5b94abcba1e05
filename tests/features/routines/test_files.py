"""Routine files: found by name, limited in size, every mistake with its remedy."""

from pathlib import Path

import msgspec
import pytest

from fleet_tui.config.load import from_text
from fleet_tui.features.routines.files import LARGEST, read_routine, routine_names
from fleet_tui.text.errors import RoutineError
from tests.support.routines import MORNING


def test_the_folder_is_beside_the_configuration(tmp_path: Path) -> None:
    text = '[[floors]]\nname = "f"\n[[robots]]\nname = "r"\n'
    config = msgspec.structs.replace(from_text(text), path=tmp_path / "config.toml")
    assert config.routine_folder == tmp_path / "routines"
    other = msgspec.structs.replace(
        from_text(text + '[routines]\nfolder = "../day"\n'), path=tmp_path / "config.toml"
    )
    assert other.routine_folder == tmp_path / "../day"
    assert other.whole().routines.folder == str(tmp_path / "../day")


def test_names_and_contents(tmp_path: Path) -> None:
    assert routine_names(tmp_path / "none") == []
    (tmp_path / "morning.routine").write_text(MORNING)
    (tmp_path / "notes.txt").write_text("")
    assert routine_names(tmp_path) == ["morning"]
    file = read_routine(tmp_path, "morning.routine")
    assert file.name == "morning" and file.parsed.problems == () and len(file.parsed.routine.lanes) == 2
    (tmp_path / "morning.routine").write_text(MORNING + "\n")
    assert read_routine(tmp_path, "morning").digest != file.digest


def test_a_broken_link_is_not_meant_by_its_own_name(tmp_path: Path) -> None:
    (tmp_path / "day.routine").symlink_to("gone")
    with pytest.raises(RoutineError, match=r"unknown routine 'day': create "):
        read_routine(tmp_path, "day")


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("mornin", None, "unknown routine 'mornin', did you mean morning?"),
        ("zzz", None, "unknown routine 'zzz': create "),
        ("../secret", None, "use up to 64 letters"),
        ("-rf", None, "use up to 64 letters"),
        ("bad", b"\xff\xfe", "not UTF-8 text: save it as UTF-8"),
        ("large", b"#" * (LARGEST + 1), "over 100,000 bytes: divide it"),
    ],
)
def test_files_that_cannot_be_read(tmp_path: Path, name: str, content: bytes | None, words: str) -> None:
    (tmp_path / "morning.routine").write_text(MORNING)
    if content is not None:
        (tmp_path / f"{name}.routine").write_bytes(content)
    with pytest.raises(RoutineError, match=words):
        read_routine(tmp_path, name)
