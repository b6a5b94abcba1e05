"""A recording whose files go while it is looked at, and the ends of its marks."""

from pathlib import Path
from typing import BinaryIO

import pytest

from fleet_tui.model.events import TimePassed
from fleet_tui.records.recording import indexing
from fleet_tui.records.recording.gzip_members import open_plain
from fleet_tui.records.recording.part_files import part_path
from fleet_tui.records.recording.records import Keyframe, RecordingError
from tests.support.fleets import LINK, T0, WALL, link_up
from tests.support.recordings import header, written
from tests.support.replay_console import replayed
from tests.support.replay_times import at
from tests.support.tapes import MadeUp
from tests.support.watched_store import config_of


@pytest.fixture
def parts(tmp_path: Path) -> list[Path]:
    """80 s in four files of 20 s each."""
    made = MadeUp(config_of("ws://site:9090"), keyframe_every=20.0)
    for second in range(80):
        made.tell(second, link_up(T0 + second), TimePassed(T0 + second, WALL + second))
    begins = [n for n, record in enumerate(made.records) if isinstance(record, Keyframe)]
    first = tmp_path / "night.jsonl.gz"
    return [
        written(part_path(first, n), [header(made.config, part=n, at=T0 + 20 * n), *made.records[a:b]])
        for n, (a, b) in enumerate(zip(begins, [*begins[1:], None], strict=True))
    ]


@pytest.mark.parametrize("gone", range(1, 4))
def test_a_part_that_goes_while_the_recording_is_opened(
    parts: list[Path], monkeypatch: pytest.MonkeyPatch, gone: int
) -> None:
    def opened(path: Path) -> BinaryIO:
        file = open_plain(path)
        if path == parts[gone]:
            path.unlink()
        return file

    monkeypatch.setattr(indexing, "open_plain", opened)
    recording = indexing.open_recording(parts[0])
    assert len(recording.keyframes) == 3
    assert f"{parts[gone].name}: no such file" in recording.note


@pytest.mark.parametrize(
    ("gone", "note"),
    [
        ([0, 1], ""),
        ([3], ""),
        ([1], "night.0002.jsonl.gz: 1 part is missing before it"),
        ([1, 2], "night.0003.jsonl.gz: 2 parts are missing before it"),
    ],
)
def test_a_part_that_is_missing_between_others_is_said(parts: list[Path], gone: list[int], note: str) -> None:
    for n in gone:
        parts[n].unlink()
    left = next(part for n, part in enumerate(parts) if n not in gone)
    assert indexing.open_recording(left).note == note


def test_a_file_that_becomes_a_recording_while_it_is_opened(
    parts: list[Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    empty, looks = parts[0].with_name("empty"), []
    empty.touch()

    def opened(path: Path) -> BinaryIO:
        looks.append(path)
        return open_plain(empty if len(looks) == 1 else path)

    monkeypatch.setattr(indexing, "open_plain", opened)
    for part in parts[1:]:
        part.unlink()
    with pytest.raises(RecordingError, match="is not a fleet-tui recording"):
        indexing.open_recording(parts[0])


async def test_what_is_gone_is_said_and_what_is_shown_stays_true(parts: list[Path]) -> None:
    async with replayed(parts[0], "+45s") as it:
        parts[0].unlink()
        await it.press("home")
        await it.shows("night.jsonl.gz has changed since it was opened: reopen it")
        # Where it stands, it can still be played on.
        await it.press(".")
        await it.shows(at(46))
        assert "end of recording" not in it.text
        await it.press("<", "<")
        await it.shows(at(26))
        await it.hides("has changed since")
        assert LINK in it.store.state.links


async def test_a_part_that_is_gone_is_not_called_silence(parts: list[Path]) -> None:
    async with replayed(parts[0], "+37s") as it:
        parts[2].unlink()
        await it.press("space")
        await it.shows("no records for the 0:21 before this")
        await it.shows("night.0002.jsonl.gz: no such file")


async def test_where_no_mark_follows_that_is_said(parts: list[Path]) -> None:
    async with replayed(parts[0], "+19s") as it:
        await it.press(")")
        await it.shows("no alarm, command or gap after this")
        await it.press("(")
        await it.shows("▲ robot_0 never seen", "time-line")
        await it.press("(")
        await it.shows("no alarm, command or gap before this")
