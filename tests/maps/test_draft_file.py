"""Drafts on disk: nothing that was drawn is lost by a crash."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.features.graphs.rules.edits import added
from fleet_tui.maps.draft_file import Done, DraftFile, Redone, Undone
from fleet_tui.model.graphs.document import DocumentFloor, DocumentVertex
from fleet_tui.model.graphs.draft import GraphDraft


def begun(folder: Path) -> tuple[DraftFile, GraphDraft]:
    file, draft = DraftFile(folder, "site", "floor/0"), GraphDraft(DocumentFloor("floor/0"))
    file.begin(draft)
    return file, draft


def add(file: DraftFile, draft: GraphDraft) -> None:
    draft.do(added(DocumentVertex(next(draft.free_ids()), 1.25, -3.5, "Störe ␛", "dock")))
    file.write(Done(draft.done[-1]))


@given(steps=st.lists(st.sampled_from(["add", "undo", "redo"]), max_size=20))
def test_a_draft_is_read_as_it_was_left(steps: list[str], tmp_path_factory: pytest.TempPathFactory) -> None:
    folder = tmp_path_factory.mktemp("drafts")
    file, draft = begun(folder)
    for step in steps:
        if step == "add":
            add(file, draft)
        elif step == "undo" and draft.undo():
            file.write(Undone())
        elif step == "redo" and draft.redo():
            file.write(Redone())
    # Nothing closes it: the process may have died.
    read = DraftFile(folder, "site", "floor/0").load()
    assert read is not None
    assert (read.floor, read.done, read.undone) == (draft.floor, draft.done, draft.undone)
    assert (next(read.free_ids()), read.base) == (next(draft.free_ids()), draft.base)


@pytest.mark.parametrize("lost", [1, 9])
def test_a_line_that_was_cut_off_is_left_out_and_later_steps_follow_the_others(
    lost: int, tmp_path: Path
) -> None:
    file, draft = begun(tmp_path)
    for _ in range(3):
        add(file, draft)
    file.close()  # the lock of a process that died is gone
    file.path.write_bytes(file.path.read_bytes()[:-lost])
    again = DraftFile(tmp_path, "site", "floor/0")
    read = again.load()
    assert read is not None and list(read.floor.vertices) == ["1", "2"]
    add(again, read)
    read = DraftFile(tmp_path, "site", "floor/0").load()
    assert read is not None and list(read.floor.vertices) == ["1", "2", "3"]


def test_a_new_draft_keeps_the_old_one_beside_it(tmp_path: Path) -> None:
    file, draft = begun(tmp_path)
    add(file, draft)
    before = file.path.read_bytes()
    file.close()
    begun(tmp_path)
    (kept,) = tmp_path.glob("*.bak")
    assert kept.read_bytes() == before
    assert oct(file.path.stat().st_mode)[-3:] == "600"


def test_there_is_none_at_first_and_none_in_another_file(tmp_path: Path) -> None:
    file = DraftFile(tmp_path, "site", "floor_1")
    assert file.load() is None
    file.path.parent.mkdir(exist_ok=True)
    file.path.write_bytes(b'{"type":"done"}\n\xff\xfe')
    assert file.load() is None


def test_a_second_console_on_the_floor_erases_nothing(tmp_path: Path) -> None:
    file, draft = begun(tmp_path)
    add(file, draft)
    other = DraftFile(tmp_path, "site", "floor/0")
    read = other.load()
    assert read is not None
    add(file, draft)
    with pytest.raises(OSError, match="another console"):
        add(other, read)
    with pytest.raises(OSError, match="another console"):
        other.begin(read)
    assert not list(tmp_path.glob("*.bak"))
    again = DraftFile(tmp_path, "site", "floor/0").load()
    assert again is not None and list(again.floor.vertices) == ["1", "2"]


def test_a_draft_that_can_not_be_begun_says_why_each_time(tmp_path: Path) -> None:
    held, draft = begun(tmp_path)
    assert held.path.exists()
    (tmp_path / "plain").touch()
    for folder, reason in (
        (tmp_path, "another console edits this floor"),
        (tmp_path / "plain", f"{tmp_path / 'plain'}: File exists"),
    ):
        file = DraftFile(folder, "site", "floor/0")
        with pytest.raises(OSError, match=reason):
            file.begin(draft)
        with pytest.raises(OSError, match=reason):
            file.write(Undone())


def test_a_draft_without_steps_takes_no_place_of_an_earlier_one(tmp_path: Path) -> None:
    file, draft = begun(tmp_path)
    add(file, draft)
    file.close()
    for _ in range(3):
        begun(tmp_path)[0].close()
    (kept,) = tmp_path.glob("*.bak")
    assert b"St" in kept.read_bytes()
