"""A read-only console writes nothing at a person's word: each action says why."""

from pathlib import Path

from fleet_tui.config.saving import Saving
from fleet_tui.controllers.files import IN_A_TAB, READ_ONLY, ConsoleFiles
from fleet_tui.controllers.history.note import NoteCommand
from fleet_tui.controllers.incident import IncidentPacking
from fleet_tui.controllers.recording import RecordingSwitch
from fleet_tui.controllers.save import SaveCommand
from fleet_tui.recording.recordings import Recordings
from fleet_tui.state.store import Store
from tests.support.desk import Desk, ready
from tests.support.past import kept_history
from tests.support.watched_store import config_of

WHY = "not here: this console is read-only"


def test_nothing_is_written(tmp_path: Path) -> None:
    said, config = list[str](), config_of("ws://a")
    files = ConsoleFiles(pack=lambda _shot, _is_over: tmp_path / "pack", saving=Saving(config))
    files.refusal = files.naming_refusal = READ_ONLY
    files.recordings = Recordings(config, Store(ready()), tmp_path)
    with kept_history(tmp_path / "history") as files.history:
        note = NoteCommand(files, said.append).typed("note lift B is slow")
        assert note is not None and (note.problem, list(note.entries)) == (WHY, [])
        RecordingSwitch(files, said.append, said.append, lambda do: do()).turn()
        IncidentPacking(files, said.append, said.append, str, lambda _do: said.append("packs")).pack()
        desk = Desk(ready())
        save = SaveCommand(files, desk.ask, said.append, said.append).typed(f"save {tmp_path / 'copy.toml'}")
        assert save is not None
        ((_, do),) = save.entries
        do()
        assert said == [WHY] * 3 and files.recordings.recorder is None
        assert {path.name for path in tmp_path.iterdir()} <= {"history"}


def test_a_browser_names_no_file(tmp_path: Path) -> None:
    said = list[str]()
    files = ConsoleFiles(saving=Saving(config_of("ws://a")))
    files.naming_refusal = IN_A_TAB
    command = SaveCommand(files, Desk(ready()).ask, said.append, said.append)
    save = command.typed(f"save {tmp_path / 'copy.toml'}")
    assert save is not None
    ((text, do),) = save.entries
    do()
    assert text == said[0] == IN_A_TAB and list(tmp_path.iterdir()) == []
