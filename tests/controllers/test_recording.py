"""One action begins a recording and ends it, and says what a disk makes of it."""

from fleet_tui.controllers.files import ConsoleFiles
from fleet_tui.controllers.recording import RecordingSwitch


def test_without_recordings_it_says_why() -> None:
    said = list[str]()
    RecordingSwitch(ConsoleFiles(), said.append, said.append, lambda do: do()).turn()
    assert said == ["nothing to record: not a live console"]
