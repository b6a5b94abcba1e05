"""A real console in a real terminal that ends while it drives: the last word on the wire is zero."""

import asyncio
import signal
from collections.abc import Callable
from pathlib import Path

import pytest

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import config_file
from tests.support.terminal_session import InTerminal, in_terminal

TOPIC = "/robot_0/cmd_vel"


def speeds(server: RosbridgeServer) -> list[float]:
    """The speeds ahead of the twists that arrived."""
    found = [one for one in list(server.bridge.received) if one.get("topic") == TOPIC]
    return [one["msg"]["linear"]["x"] for one in found if one["op"] == "publish"]


def driven(server: RosbridgeServer, folder: Path, end: Callable[[InTerminal], object]) -> None:
    """Drive with a key that repeats, and end it in the middle."""
    path = config_file(folder, server.url, 2, 2)
    path.write_text(path.read_text() + 'drive = "/{robot}/cmd_vel"\n[drive]\nrobot_timeout = 0.5\n')
    with in_terminal(folder, "--config", str(path)) as running:
        running.shows("robot_1")
        running.shows("Base")

        def enters() -> bool:
            running.press("T")
            return "DRIVE robot_0 0.00 m/s" in running.text()

        running.until(enters, what="a drive")

        def moves() -> bool:
            running.press("w")
            return max(speeds(server), default=0.0) > 0.0

        running.until(moves, what="a robot that moves")
        running.press("w")
        end(running)
        running.until(lambda: speeds(server)[-1] == 0.0, what="a zero")
        if running.child.poll() is None:
            running.child.terminate()
        running.ends()
    assert speeds(server)[-3:] == [0.0] * 3


@pytest.mark.parametrize(
    "name",
    [
        pytest.param("SIGTERM", marks=pytest.mark.nightly),
        "SIGHUP",
        pytest.param("SIGINT", marks=pytest.mark.nightly),
    ],
)
async def test_a_signal_stops_the_robot(server: RosbridgeServer, tmp_path: Path, name: str) -> None:
    def end(running: InTerminal) -> None:
        running.child.send_signal(signal.Signals[name])
        running.ends()

    await asyncio.to_thread(driven, server, tmp_path, end)


@pytest.mark.parametrize("key", ["\x1b[O", "\x1b"])
async def test_a_key_or_a_lost_focus_stops_the_robot(
    server: RosbridgeServer, tmp_path: Path, key: str
) -> None:
    await asyncio.to_thread(driven, server, tmp_path, lambda running: running.press(key))


@pytest.mark.nightly
async def test_the_robot_stands_before_a_console_is_suspended(
    server: RosbridgeServer, tmp_path: Path
) -> None:
    def end(running: InTerminal) -> None:
        running.press("\x1a")
        state = Path(f"/proc/{running.child.pid}/stat")
        running.until(lambda: state.read_text().rpartition(")")[2].split()[0] == "T", what="suspended")
        running.until(lambda: speeds(server)[-3:] == [0.0] * 3, what="zeros")
        running.forget()
        running.child.send_signal(signal.SIGCONT)
        running.shows("Fleet")

    await asyncio.to_thread(driven, server, tmp_path, end)


@pytest.mark.nightly
async def test_a_hung_up_terminal_stops_the_robot(server: RosbridgeServer, tmp_path: Path) -> None:
    def end(running: InTerminal) -> None:
        running.hang_up()
        running.ends()

    await asyncio.to_thread(driven, server, tmp_path, end)


@pytest.mark.nightly
async def test_key_releases_of_the_terminal_are_taken(server: RosbridgeServer, tmp_path: Path) -> None:
    """As kitty sends them: Textual's own parser would end the thread that reads."""

    def end(running: InTerminal) -> None:
        running.until(lambda: b"\x1b[=27;1u" in running.sent, what="the wish for releases")
        running.press("\x1b[119;1:2;119u\x1b[119;1:3u")
        running.until(lambda: speeds(server)[-1] == 0.0, what="a zero")
        running.press("\x1b[27u")
        running.until(lambda: "left by key" in running.text(), what="the end of the drive")
        running.until(lambda: b"\x1b[=25;1u" in running.sent, what="the end of the wish")

    await asyncio.to_thread(driven, server, tmp_path, end)
