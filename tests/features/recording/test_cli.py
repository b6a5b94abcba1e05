"""`fleet-tui record`: what it leaves however it ends, its exit codes, and that it only listens."""

import asyncio
import signal
from pathlib import Path

import pytest

from fleet_tui.model import events
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.recording import Recording
from fleet_tui.records.recording.records import (
    EventRecord,
    Keyframe,
    ReceivedFrame,
    RecordingError,
    SentFrame,
)
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import config_file, run, started
from tests.support.polling import HANGS


async def grown(path: Path, records: int, within: float = HANGS) -> Recording:
    """The recording as soon as so many records are in it."""
    async with asyncio.timeout(within):
        while True:
            try:
                recording = open_recording(path)
                if sum(1 for _ in recording.records()) >= records:
                    return recording
            except RecordingError:
                pass
            await asyncio.sleep(0.1)  # another process writes it: nobody tells


async def test_for_a_while(server: RosbridgeServer, folder: Path) -> None:
    done = await run(folder, "record", "x.jsonl.gz", "--for", "3s")
    assert (done.code, done.err) == (0, "")
    first, up, last = done.out.splitlines()
    assert first == "recording to x.jsonl.gz; replay with: fleet-tui replay x.jsonl.gz"
    assert up == f"{server.url}: up" and last.endswith("MB in 1 file")
    recording = open_recording(folder / "x.jsonl.gz")
    assert recording.note == "" and 2.0 < recording.end.at - recording.begin.at < 10.0
    records = list(recording.records())
    assert {type(record) for record in records} >= {Keyframe, ReceivedFrame, SentFrame, EventRecord}
    assert server.bridge.services.calls == []
    assert recording.config.operator.read_only


async def test_maps_are_in_it(server: RosbridgeServer, folder: Path) -> None:
    """Of files, and live ones of floors that have none."""
    (folder / "map.pgm").write_bytes(b"P5\n2 2\n255\n\0\0\0\0")
    text = (folder / "config.toml").read_text()
    (folder / "config.toml").write_text(text.replace('name = "floor_0"', 'name = "floor_0"\nmap = "map.pgm"'))
    done = await run(folder, "record", "x.jsonl.gz", "--for", "4s")
    assert done.code == 0
    recording = open_recording(folder / "x.jsonl.gz")
    records = list(recording.records())
    told = [record.event for record in records if isinstance(record, EventRecord)]
    (loaded,) = [event for event in told if isinstance(event, events.FloorMapLoaded)]
    assert loaded.grid is not None and loaded.grid.frame.width == 2
    sent = [record.text for record in records if isinstance(record, SentFrame)]
    assert any("/robot_0/floor_1/map" in text and '"subscribe"' in text for text in sent)
    assert any("/robot_0/floor_1/map" in text and '"unsubscribe"' in text for text in sent)
    assert not any(
        "/robot_0/floor_0/map" in text and '"map_metadata"' not in text for text in sent if '/map"' in text
    )


@pytest.mark.parametrize(
    ("number", "code"),
    [
        (signal.SIGTERM, 0),
        pytest.param(signal.SIGHUP, 0, marks=pytest.mark.nightly),
        pytest.param(signal.SIGINT, 130, marks=pytest.mark.nightly),
    ],
)
async def test_asked_to_end_it_ends_the_file(
    server: RosbridgeServer, folder: Path, number: signal.Signals, code: int
) -> None:
    process = await started(folder, "record", "x.jsonl.gz")
    await grown(folder / "x.jsonl.gz", 50)
    process.send_signal(number)
    out, err = await asyncio.wait_for(process.communicate(), HANGS)
    assert process.returncode == code
    assert b"records, " in out and err.strip() == b""
    assert open_recording(folder / "x.jsonl.gz").note == ""


async def test_killed_it_loses_a_second(server: RosbridgeServer, folder: Path) -> None:
    process = await started(folder, "record", "x.jsonl.gz")
    before = await grown(folder / "x.jsonl.gz", 100)
    process.kill()
    await process.communicate()
    recording = open_recording(folder / "x.jsonl.gz")
    assert "truncated" in recording.note
    assert recording.end.at >= before.end.at
    records = list(recording.records())
    assert len(records) >= 100 and records[-1].at == recording.end.at
    assert (folder / "x.jsonl.gz").stat().st_mode & 0o777 == 0o600


async def test_parts_and_how_many_are_kept(server: RosbridgeServer, folder: Path) -> None:
    done = await run(folder, "record", "x.gz", "--for", "6s", "--rotate-every", "1s", "--keep", "2")
    assert done.code == 0 and done.out.endswith("in 2 files\n")
    names = [path.name for path in open_recording(folder / "x.gz").parts]
    assert len(names) == 2 and "x.gz" not in names


async def test_what_is_there_is_never_written_over(server: RosbridgeServer, folder: Path) -> None:
    (folder / "x.gz").write_text("precious")
    done = await run(folder, "record", "x.gz", "--for", "1s")
    assert done.code == 1
    assert done.err == "fleet-tui: x.gz: exists: choose another name, or remove it\n"
    assert (folder / "x.gz").read_text() == "precious"


async def test_no_link_is_3(tmp_path: Path) -> None:
    config_file(tmp_path, "ws://127.0.0.1:9")
    done = await run(tmp_path, "record", "x.gz", "--timeout", "2")
    assert done.code == 3
    assert "ws://127.0.0.1:9: no link: connection refused" in done.out
    recording = open_recording(tmp_path / "x.gz")
    assert any(isinstance(record, EventRecord) for record in recording.records())


async def test_it_goes_on_when_the_link_is_lost(server: RosbridgeServer, folder: Path) -> None:
    process = await started(folder, "record", "x.gz", "--timeout", "5")
    await grown(folder / "x.gz", 50)
    await server.drop_clients()
    assert process.stdout is not None
    lines = [await asyncio.wait_for(process.stdout.readline(), HANGS) for _ in range(4)]
    assert [b"no link" in line for line in lines] == [False, False, True, False]
    assert lines[3].endswith(b": up\n")
    process.terminate()
    await process.communicate()
    assert process.returncode == 0


@pytest.mark.parametrize(
    ("args", "words"),
    [
        (("--for", "soon"), "'soon' is not a duration: use 45s, 30m, 8h or 1d"),
        (("--for", "0"), "is not a duration"),
        (("--rotate-mb", "0"), "0.0 is not in the range"),
        (("--read-only",), "No such option"),
    ],
)
async def test_what_makes_no_sense_is_2(tmp_path: Path, args: tuple[str, ...], words: str) -> None:
    config_file(tmp_path, "ws://127.0.0.1:9")
    done = await run(tmp_path, "record", "x.gz", *args)
    assert done.code == 2 and words in done.err
    assert not (tmp_path / "x.gz").exists()
