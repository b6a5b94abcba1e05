"""One action begins a recording and ends it, and says what a disk makes of it."""

from fleet_tui.features.recording.switch import RecordingSwitch
from tests.support.desk import Desk, ready


def test_without_recordings_it_says_why() -> None:
    desk = Desk(ready())
    RecordingSwitch(desk.console(), lambda do: do()).turn()
    assert desk.notices.text == "nothing to record: not a live console"
