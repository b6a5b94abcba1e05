"""Recording from the console: by the palette, said on the status line exactly while it is true."""

import json
from pathlib import Path

from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.records import Keyframe, Mark, ReceivedFrame, SentFrame
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import Console, console
from tests.support.planted_console import planted
from tests.support.watched_store import config_of


async def record(running: Console) -> None:
    await running.press("colon")
    await running.type("record: start")
    await running.press("enter")


async def test_a_recording_from_the_palette(server: RosbridgeServer, tmp_path: Path) -> None:
    async with console(config_of(server.url, 2, 2), state_folder=tmp_path) as running:
        assert "rec 0 s" not in running.text
        await record(running)
        await running.shows("rec 1 s", "status")
        await running.shows("recording to", "message")
        await running.press("p")
        await running.until(lambda state: state.robots["robot_0"].paused)
        await running.shows("rec 2 s")
        await record(running)
        await running.shows("recorded ", "message")
        assert "rec " not in running.pane("status")
    (path,) = (tmp_path / "recordings").iterdir()
    recording = open_recording(path)
    begin, *others = recording.records()
    assert isinstance(begin, Keyframe) and recording.state(begin).robots["robot_1"].pose is not None
    sent = [json.loads(record.text) for record in others if isinstance(record, SentFrame)]
    assert any(frame.get("service", "").endswith("/Pause") for frame in sent)
    assert [record.record.change for record in others if isinstance(record, Mark)][:2] == ["checked", "sent"]
    assert any(isinstance(record, ReceivedFrame) for record in others)


async def test_the_last_minutes_are_kept_without_asking(server: RosbridgeServer, tmp_path: Path) -> None:
    async with console(config_of(server.url, 2, 2), state_folder=tmp_path) as running:
        recordings = running.app.main.files.recordings
        assert recordings is not None
        await running.until(lambda state: recordings.recent())
        (path,) = recordings.recent()
        assert open_recording(path).keyframes
        assert "rec " not in running.pane("status")
    assert open_recording(path).note == ""


async def test_where_no_disk_takes_it(server: RosbridgeServer, tmp_path: Path) -> None:
    (tmp_path / "recordings").touch()
    (tmp_path / "recent").touch()
    async with console(config_of(server.url, 2, 2), state_folder=tmp_path) as running:
        await running.shows("last minutes not kept")
        await record(running)
        await running.shows("recording failed: ", "message")
        await running.press("p")
        await running.until(lambda state: state.robots["robot_0"].paused)


async def test_without_a_link_there_is_nothing_to_record() -> None:
    async with planted() as running:
        await record(running)
        await running.shows("nothing to record: not a live console")
