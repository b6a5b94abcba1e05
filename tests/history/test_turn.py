"""The turn to observe: one holder, the next one as soon as it ends."""

from pathlib import Path

from fleet_tui.history.turn import Turn


def test_one_holds_it_until_it_ends(tmp_path: Path) -> None:
    first, second = Turn(tmp_path / "a.sqlite"), Turn(tmp_path / "a.sqlite")
    assert first.take()
    assert first.take()
    assert not second.take()
    first.close()
    assert second.take()
    second.close()


def test_without_a_folder_each_observes_and_nobody_holds_it(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    turn = Turn(tmp_path / "file" / "a.sqlite")
    assert turn.take()
    assert not turn.is_held
    turn.close()
