"""A console on a recording: nothing leaves it."""

import socket
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest

from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.text.language import EMPTY
from tests.support.replay_console import replayed
from tests.support.tapes import shift


@pytest.fixture
def night(tmp_path: Path) -> Path:
    return shift(tmp_path / "night.jsonl.gz").path


async def test_nothing_can_be_sent_or_acknowledged(night: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[object] = []  # the hosts that anything in this process looks up; other tests' links, too
    look_up = socket.getaddrinfo

    def looked_up(host: Any, *args: Any, **options: Any) -> Any:
        asked.append(host)
        return look_up(host, *args, **options)

    monkeypatch.setattr(socket, "getaddrinfo", looked_up)
    recorded = open_recording(night).config.rosbridge.url
    async with replayed(night, "+110s") as it:
        before = it.store.state
        for key in ("p", "r", "P", "X", "f12"):
            it.app.main.notices.say(EMPTY)
            await it.press(key)
            await it.shows("not sent: this is a recording")
        for line in (":pause robot_0", ":robot_0 > Base"):
            it.app.main.notices.say(EMPTY)
            await it.type(line)
            await it.press("enter")
            await it.shows("not sent: this is a recording")
        await it.press("a")
        await it.shows("not possible in a recording")
        await it.press("b")
        await it.shows("nothing to pack")
        await it.press("L")
        await it.shows("no audit log on this console")
        assert it.store.state is before
        assert it.store.events == []
    assert urlsplit(recorded).hostname not in asked
