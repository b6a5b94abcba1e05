"""A read-only console writes nothing at a person's word: each action says why."""

from pathlib import Path

from fleet_tui.config.saving import Saving
from fleet_tui.features.history.note import NoteCommand
from fleet_tui.features.recording.incident import IncidentPacking
from fleet_tui.features.recording.switch import RecordingSwitch
from fleet_tui.records.recording.recordings import Recordings
from fleet_tui.state.store import Store
from fleet_tui.ui.controllers.files import IN_A_TAB, READ_ONLY, ConsoleFiles
from fleet_tui.ui.controllers.save import SaveCommand
from tests.support.desk import Desk, ready
from tests.support.past import kept_history
from tests.support.watched_store import config_of

WHY = "not here: this console is read-only"


def test_nothing_is_written(tmp_path: Path) -> None:
    desk, config = Desk(ready()), config_of("ws://a")
    said = desk.said
    files = ConsoleFiles(pack=lambda _shot, _is_over: tmp_path / "pack", saving=Saving(config))
    files.refusal = files.naming_refusal = READ_ONLY
    files.recordings = Recordings(config, Store(ready()), tmp_path)
    with kept_history(tmp_path / "history") as files.history:
        console = desk.console(files)
        note = NoteCommand(console).typed("note lift B is slow")
        assert note is not None and (note.problem, list(note.entries)) == (WHY, [])
        RecordingSwitch(console, lambda do: do()).turn()
        IncidentPacking(console, str, lambda _do: said.append("packs")).pack()
        save = SaveCommand(console).typed(f"save {tmp_path / 'copy.toml'}")
        assert save is not None
        ((_, do),) = save.entries
        do()
        assert said == [WHY] * 3 and files.recordings.recorder is None
        assert {path.name for path in tmp_path.iterdir()} <= {"history"}


def test_a_browser_names_no_file(tmp_path: Path) -> None:
    desk = Desk(ready())
    files = ConsoleFiles(saving=Saving(config_of("ws://a")))
    files.naming_refusal = IN_A_TAB
    command = SaveCommand(desk.console(files))
    save = command.typed(f"save {tmp_path / 'copy.toml'}")
    assert save is not None
    ((text, do),) = save.entries
    do()
    assert text == desk.said[0] == IN_A_TAB and list(tmp_path.iterdir()) == []
