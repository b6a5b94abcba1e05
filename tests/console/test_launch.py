"""`fleet-tui URL` and `fleet-tui` alone in a real terminal: one command to the fleet, no trace left."""

import re
import socket
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.cli import run
from tests.support.in_pty import simulator
from tests.support.terminal_session import InTerminal

ON, OFF = b"\x1b[?1049h", b"\x1b[?1049l"
COLOUR = re.compile(rb"\x1b\[(?:\d+;)*(?:3[0-8]|4[0-8]|9[0-7]|10[0-7])(?:;\d+)*m")


class Terminals:
    """Programs in terminals, all ended at the end."""

    def __init__(self, home: Path) -> None:
        self.home = home
        self.running: list[InTerminal] = []

    def open(self, *arguments: str, **more: str) -> InTerminal:
        terminal = InTerminal(list(arguments), self.home, 0, **more)
        self.running.append(terminal)
        return terminal


@pytest.fixture
def terminals(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Terminals]:
    monkeypatch.chdir(tmp_path)  # where no configuration is
    monkeypatch.delenv("FLEET_TUI_CONFIG", raising=False)
    found = Terminals(tmp_path)
    yield found
    for terminal in found.running:
        terminal.close()


@pytest.mark.parametrize("kind", ["oh_ressources", pytest.param("nav2", marks=pytest.mark.nightly)])
def test_an_address_is_enough(terminals: Terminals, kind: str) -> None:
    with simulator(3, kind=kind) as url:
        console = terminals.open(url)
        console.shows(f"{url}: 3 robots ({kind}), 1 floor. :save keeps it")
        console.shows("3 of 3 online")
        assert not console.sent.partition(ON)[0].strip()
        console.press(":save\r")
        console.shows("config.toml: fleet-tui opens it here")
        console.press_later("q")
        console.ends()
        console.until(console.is_restored, what="the terminal restored")
        assert console.child.returncode == 0 and b"robot" not in console.sent.rpartition(OFF)[2]
        again = terminals.open()
        again.shows("3 of 3 online")
        again.press_later("q")
        again.ends()


def test_what_keeps_it_from_opening_is_one_sentence(terminals: Terminals) -> None:
    console = terminals.open("ws://127.0.0.1:9")
    console.ends()
    assert console.child.returncode == 3
    told = "Each step of the way: fleet-tui doctor --url ws://127.0.0.1:9"
    console.until(lambda: told in " ".join(console.sent.decode().split()), what=told)
    assert "connection refused: start rosbridge on it" in " ".join(console.sent.decode().split())
    assert ON not in console.sent
    assert max(map(len, console.sent.decode().splitlines())) <= 120, "folded between words"


@pytest.mark.parametrize(
    ("address", "words"),
    [
        ("robot:9090", "did you mean ws://robot:9090?"),
        ("127.0.0.1", "did you mean ws://127.0.0.1:9090?"),
        ("mqtt://robot:1883/x", "has a path: a broker has none, remove it"),
    ],
)
async def test_an_address_that_is_none_is_told_before_a_terminal_is_needed(
    tmp_path: Path, address: str, words: str
) -> None:
    ended = await run(tmp_path, address)
    assert ended.code == 2 and words in " ".join(ended.err.split())
    assert ended.out == "" and max(map(len, ended.err.splitlines())) <= 100, "folded between words"


@pytest.mark.parametrize("more", [{}, pytest.param({"NO_COLOR": "1"}, marks=pytest.mark.nightly)])
def test_without_a_configuration_it_asks_where_to_go(terminals: Terminals, more: dict[str, str]) -> None:
    with simulator(2) as url:
        first = terminals.open(**more)
        first.shows("no configuration found")
        first.shows("./config.toml")
        first.shows("ws://127.0.0.1:9090")
        first.press("a")
        first.press(f"{url}\r")
        first.shows("2 robots (oh_ressources), 1 floor")
        first.press("\r")
        first.shows("2 of 2 online")
        assert bool(COLOUR.search(first.sent)) is not bool(more)
        first.press_later("q")
        first.ends()
        first.until(first.is_restored, what="the terminal restored")
        assert first.child.returncode == 0


@pytest.mark.nightly
def test_leaving_it_opens_nothing_and_keeps_the_commands_in_sight(terminals: Terminals) -> None:
    first = terminals.open()
    first.shows("no configuration found")
    first.press_later("q")
    first.ends()
    first.until(first.is_restored, what="the terminal restored")
    assert first.child.returncode == 0
    first.until(lambda: b"find what is wrong" in first.sent.rpartition(OFF)[2], what="the commands")
    assert b"fleet-tui demo" in first.sent.rpartition(OFF)[2]


@pytest.mark.nightly
def test_one_key_opens_a_simulated_fleet(terminals: Terminals) -> None:
    first = terminals.open()
    first.shows("d demo")
    first.press_later("d")
    first.shows("3 of 3 online")
    first.shows("simulated fleet. Try an order: o, type Base, Enter, type Cons, Enter")
    first.press_later("q")
    first.ends()
    first.until(first.is_restored, what="the terminal restored")
    assert first.child.returncode == 0


def test_a_signal_ends_it(terminals: Terminals) -> None:
    first = terminals.open()
    first.shows("no configuration found")
    first.child.terminate()
    first.ends()
    first.until(first.is_restored, what="the terminal restored")


def test_progress_is_shown_while_it_takes_long_and_is_gone_after(terminals: Terminals) -> None:
    """A bridge that takes connections and never answers."""
    with socket.create_server(("127.0.0.1", 0)) as mute:
        threading.Thread(target=_accept, args=(mute,), daemon=True).start()
        console = terminals.open(f"ws://127.0.0.1:{mute.getsockname()[1]}")
        console.until(lambda: b"connecting" in console.sent, 10.0, "progress")
        console.ends(15.0)
    assert console.child.returncode == 3
    shown = console.text().split("\n")
    assert shown[0].startswith("fleet-tui: ws://127.0.0.1:") and "connecting" not in console.text()


def _accept(mute: socket.socket) -> None:
    held = []
    while True:
        try:
            held.append(mute.accept())
        except OSError:
            return


@pytest.mark.nightly
def test_a_demo_needs_no_configuration(terminals: Terminals) -> None:
    demo = terminals.open("demo", "--robots", "2")
    demo.shows("2 of 2 online")
    demo.press(":save\r")
    demo.shows("nothing to save")
    demo.press_later("q")
    demo.ends()
