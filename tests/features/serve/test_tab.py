"""A tab of the browser: its console, its messages and its end."""

import asyncio
import signal
import sys
from typing import cast

import pytest
from aiohttp import web
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.features.serve.run import HIGHEST, WIDEST, Tab, within
from tests.support.polling import HANGS


@given(st.integers(), st.integers())
def test_any_size_becomes_one_that_can_be_painted(width: int, height: int) -> None:
    wide, high = within(width, height)
    assert 1 <= wide <= WIDEST and 1 <= high <= HIGHEST


class FakePage:
    """The socket of a page: keeps what it is sent."""

    def __init__(self) -> None:
        self.sent: list[object] = []
        self.reason = b""

    async def send_bytes(self, data: bytes) -> None:
        self.sent.append(data)

    async def send_str(self, text: str) -> None:
        self.sent.append(text)

    async def send_json(self, message: object) -> None:
        self.sent.append(message)

    async def close(self, message: bytes = b"") -> None:
        self.reason = message


ECHO = """
import os, sys
print(os.environ["COLUMNS"], os.environ["ROWS"], os.environ["TERM"], os.environ.get("TMUX"), flush=True)
sys.stdout.buffer.write(sys.stdin.buffer.read(6 + 5))
sys.stdout.flush()
sys.stdin.buffer.read()
"""


def tab(program: str = ECHO) -> tuple[Tab, FakePage]:
    page = FakePage()
    return Tab([sys.executable, "-c", program], cast("web.WebSocketResponse", page)), page


async def test_a_console_gets_the_keys_and_a_terminal_of_the_pages_size(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("TMUX", "ours")
    it, _ = tab()
    process = await it._open_app_process(WIDEST + 1, 0)
    assert process.stdout is not None
    assert await process.stdout.readline() == f"{WIDEST} 1 xterm-256color None\n".encode()
    await it.on_message(["stdin", "héllo"])
    assert await process.stdout.readexactly(11) == b"D" + (6).to_bytes(4, "big") + "héllo".encode()
    process.kill()
    await process.wait()


async def test_a_console_that_does_not_end_is_killed_with_its_children(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("fleet_tui.features.serve.run.PATIENCE", 0.1)
    it, _ = tab(
        "import subprocess; child = subprocess.Popen(['sleep', '60']); print(flush=True); child.wait()"
    )
    process = await it._open_app_process()
    assert process.stdout is not None and await process.stdout.readline() == b"\n"
    await it.stop()
    assert process.returncode == -signal.SIGKILL
    async with asyncio.timeout(HANGS):
        assert await process.stdout.read() == b"", "whoever lives would hold it open"


async def test_a_ping_is_answered_and_nonsense_ignored() -> None:
    it, page = tab()
    messages: list[object] = [
        ["ping", "17"],
        ["ping", 17],
        ["resize", {"width": "a"}],
        "x",
        None,
        ["stdin"],
        {},
    ]
    for message in messages:
        await it.on_message(message)
    assert page.sent == [["pong", "17"]]
    await it._close()
    assert page.reason == b"The console has ended."
