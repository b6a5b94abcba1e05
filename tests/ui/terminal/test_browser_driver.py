"""The connection to a tab: packets in their order from a thread of their own, and an end with the server."""

import asyncio
import os
import sys
from collections.abc import Iterator

import pytest
from textual import messages
from textual.app import App

from fleet_tui.ui.terminal import browser_driver
from fleet_tui.ui.terminal.browser_driver import BrowserDriver
from fleet_tui.ui.terminal.ending import PATIENCE
from tests.support.polling import HANGS


class Pipes:
    """Standard input and output of a console behind a server."""

    def __init__(self) -> None:
        self.keys, self.send_keys = os.pipe()
        self.read_end, self.write_end = os.pipe()

    def packets(self) -> list[tuple[bytes, bytes]]:
        """The sent packets: kind and content of each, after the first line."""
        os.close(self.write_end)
        with os.fdopen(self.read_end, "rb") as file:
            assert file.readline() == b"__GANGLION__\n"
            found = list[tuple[bytes, bytes]]()
            while kind := file.read(1):
                found.append((kind, file.read(int.from_bytes(file.read(4), "big"))))
        return found


@pytest.fixture
def pipes(monkeypatch: pytest.MonkeyPatch) -> Iterator[Pipes]:
    pipes = Pipes()
    monkeypatch.setattr(sys, "__stdout__", os.fdopen(os.dup(pipes.write_end), "w"))
    monkeypatch.setattr(sys, "__stdin__", os.fdopen(os.dup(pipes.keys)))
    yield pipes
    os.close(pipes.keys)


class Told(App[None]):
    """An app that remembers whether it was told to exit."""

    def __init__(self) -> None:
        super().__init__()
        self.exits = asyncio.Event()
        self._its_loop = asyncio.get_running_loop()

    def post_message(self, message: object) -> bool:
        if isinstance(message, messages.ExitApp):
            self._its_loop.call_soon_threadsafe(self.exits.set)
        return True


async def test_text_is_sent_as_packets_in_order_and_the_end_comes_last(
    pipes: Pipes, monkeypatch: pytest.MonkeyPatch
) -> None:
    resorts: list[float] = []
    monkeypatch.setattr(browser_driver, "end_within", lambda seconds, _code: resorts.append(seconds))
    app = Told()
    driver = BrowserDriver(app)
    driver.start_application_mode()
    for n in range(50):
        driver.write(f"<{n}é>")
    os.close(pipes.send_keys)  # the server has gone
    async with asyncio.timeout(HANGS):
        await app.exits.wait()
    assert resorts == [PATIENCE]
    driver.stop_application_mode()
    sys.__stdout__.close()  # type: ignore[union-attr]  # it was set above
    found = pipes.packets()
    text = b"".join(content for kind, content in found if kind == b"D").decode()
    places = [text.index(f"<{n}é>") for n in range(50)]
    assert places == sorted(places)
    assert found[-1] == (b"M", b'{"type": "exit"}')
