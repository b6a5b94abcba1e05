"""`:note TEXT`."""

from pathlib import Path

from fleet_tui.features.history.note import NoteCommand
from fleet_tui.records.history.reading import History
from fleet_tui.ui.controllers.files import ConsoleFiles
from tests.support.desk import Desk, ready
from tests.support.past import kept_history, read_history


def test_a_note_is_in_the_history(tmp_path: Path) -> None:
    files = ConsoleFiles()
    with kept_history(tmp_path) as writer:
        files.history = writer
        desk = Desk(ready())
        typed = NoteCommand(desk.console(files)).typed("note  lift B is slow\x1b ")
        assert typed is not None
        ((title, write),) = typed.entries
        assert title == "Note for the next shift: lift B is slow␛"
        write()
    assert desk.said == ["noted for the next shift: lift B is slow␛"]
    with read_history(writer.path) as database:
        assert [(one.text, one.operator) for one in History(database).notes(0.0, 1e12)] == [
            ("lift B is slow\x1b", "ana")
        ]


def test_what_is_no_note_and_what_can_not_be_noted(tmp_path: Path) -> None:
    command = NoteCommand(Desk(ready()).console())
    assert command.typed("notes robot_0") is None and command.typed("pause robot_0") is None
    none = command.typed("note x")
    assert none is not None and none.problem == "no note: this console keeps no history" and not none.entries
    with kept_history(tmp_path) as writer:
        files = ConsoleFiles()
        files.history = writer
        empty = NoteCommand(Desk(ready()).console(files)).typed("note")
        assert empty is not None and empty.problem.startswith("note TEXT: ")
