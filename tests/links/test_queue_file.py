"""The file of orders that wait: one console at a time, and no order is lost in it."""

from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest

from fleet_tui.links.queue_file import FILE, LOCK, QueueFile, WaitingOrder
from fleet_tui.model.geometry import Pose
from fleet_tui.model.order import Stop

KEPT = [
    WaitingOrder("ws://a:9090", "robot_0", (Stop("1"), Stop(pose=Pose(1.0, 2.0, 0.5))), 1.7e9, "hall"),
    WaitingOrder("ws://b:9090", "robot_0", (Stop("é"),), 1.7e9),
]


@pytest.fixture
def ours(tmp_path: Path) -> Iterator[QueueFile]:
    file = QueueFile(tmp_path / "state", "ana")
    with closing(file):
        assert file.claim()
        yield file


def test_what_is_saved_is_loaded_by_the_next_console(ours: QueueFile, tmp_path: Path) -> None:
    assert ours.load() == []
    ours.save(KEPT)
    ours.close()
    with closing(QueueFile(tmp_path / "state", "ben")) as following:
        assert following.claim() and following.load() == KEPT and not following.problem
    assert {path.name for path in (tmp_path / "state").iterdir()} == {FILE, LOCK}


def test_a_second_console_names_the_owner_and_touches_nothing(ours: QueueFile, tmp_path: Path) -> None:
    ours.save(KEPT)
    second = QueueFile(tmp_path / "state", "ben")
    assert not second.claim() and second.owner == ours.owner and second.owner.startswith("ana@")
    second.save([])
    assert second.load() == [] and ours.load() == KEPT
    ours.close()
    assert second.claim() and second.owner.startswith("ben@") and second.load() == KEPT
    second.close()


def test_an_unreadable_file_is_kept_under_another_name_and_said(ours: QueueFile, tmp_path: Path) -> None:
    path = tmp_path / "state" / FILE
    path.write_text("rubbish")
    assert ours.load() == []
    assert "unreadable" in ours.problem and "queue.unreadable" in ours.problem
    assert path.with_suffix(".unreadable").read_text() == "rubbish" and not path.exists()


def test_where_nothing_can_be_written_orders_are_kept_for_this_console_alone(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    file = QueueFile(tmp_path / "file" / "state", "ana")
    assert file.claim() and "Not a directory" in file.problem
    file.save(KEPT)
    assert file.load() == []
    nowhere = QueueFile(None, "ana")
    assert nowhere.claim() and not nowhere.problem


def test_a_disk_that_is_full_is_said_until_it_takes_the_orders(
    ours: QueueFile, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ours.save(KEPT[:1])

    def full(**_: object) -> int:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patched:
        patched.setattr("fleet_tui.storage.whole_file.tempfile.mkstemp", full)
        ours.save(KEPT)
    assert "not writable: No space left" in ours.problem and ours.load() == KEPT[:1]
    ours.save(KEPT)
    assert ours.problem == "" and ours.load() == KEPT
