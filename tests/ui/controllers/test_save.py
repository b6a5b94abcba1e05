"""`:save FILE`: written at once where there is nothing, after a yes where something is."""

from pathlib import Path

import pytest

from fleet_tui.config.saving import Saving
from fleet_tui.ui.controllers.files import ConsoleFiles
from fleet_tui.ui.controllers.save import SaveCommand
from tests.support.desk import Desk, ready
from tests.support.watched_store import config_of


class Discovered:
    """A configuration that is in no file."""

    text = "# found\n"


def command(saving: Saving | None) -> tuple[Desk, list[str], SaveCommand]:
    desk = Desk(ready())
    return desk, desk.begun, SaveCommand(desk.console(ConsoleFiles(saving=saving)))


def enter(save: SaveCommand, line: str) -> None:
    typed = save.typed(line)
    assert typed is not None
    ((_, do),) = typed.entries
    do()


def test_other_lines_are_not_for_it() -> None:
    _, _, save = command(None)
    assert save.typed("pause all") is None and save.typed("saved") is None


def test_it_is_written_at_once_where_nothing_is(tmp_path: Path) -> None:
    desk, begun, save = command(Saving(config_of("ws://a"), Discovered()))
    save.start()
    assert begun == ["save config.toml"]
    enter(save, f"save {tmp_path / 'new.toml'}")
    assert (tmp_path / "new.toml").read_text() == "# found\n"
    assert desk.notices.text.startswith("saved to ") and desk.answers == []


def test_what_is_there_is_written_over_only_after_a_yes(tmp_path: Path) -> None:
    (tmp_path / "old.toml").write_text("mine")
    desk, _, save = command(Saving(config_of("ws://a"), Discovered()))
    enter(save, f"save {tmp_path / 'old.toml'}")
    assert (tmp_path / "old.toml").read_text() == "mine"
    desk.say_yes()
    assert (tmp_path / "old.toml").read_text() == "# found\n"


def test_where_it_can_not_be_written_it_says_so(tmp_path: Path) -> None:
    desk, _, save = command(Saving(config_of("ws://a"), Discovered()))
    enter(save, f"save {tmp_path / 'gone' / 'new.toml'}")
    assert desk.notices.text.startswith("not saved: ")


@pytest.mark.parametrize(
    ("saving", "words"), [(None, "nothing to save"), (Saving(config_of("ws://a")), "already saved in")]
)
def test_where_there_is_nothing_to_write_it_says_why(saving: Saving | None, words: str) -> None:
    desk, begun, save = command(saving)
    save.start()
    assert begun == ["save"]
    enter(save, "save")
    assert desk.notices.text.startswith(words)
