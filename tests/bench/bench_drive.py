"""P25: from a key to the first twist on the wire, with 1 and with 100 robots."""

import asyncio
import time
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from msgspec.structs import replace
from textual import events

from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.console.app import FleetApp
from fleet_tui.console.demo import demo_config, simulated
from fleet_tui.model.set_up.driving import STILL, DrivePhase, Speeds, Steering
from fleet_tui.robots.profile import DriveConfig
from fleet_tui.ui.themes import load_themes
from fleet_tui.ui.view.map.drawing import Drawing
from tests.bench.rows import Row, p95, row
from tests.bench.wiretap import wiretap
from tests.support.console_pilot import Console
from tests.support.watched_store import WatchedStore

PRESSES = 40
TARGETS = {1: 10.0, 100: 10.0}
SILENCE = 0.65
"""Seconds after a press until nothing is sent any more."""


def moves(frame: dict[str, Any]) -> bool:
    """Tell whether a frame is a twist that moves the robot."""
    message = frame.get("msg", {})
    return any(message.get("linear", {}).values()) or any(message.get("angular", {}).values())


async def keys(it: Console) -> list[float]:
    """Milliseconds from a key to its first twist, at any moment of the tick."""
    sent: list[float] = []
    taken = []
    with wiretap(moves, sent):
        for n in range(PRESSES):
            await asyncio.sleep(SILENCE + n % 10 * 0.011)
            sent.clear()
            started = time.perf_counter()
            it.app.post_message(events.Key("a", "a"))
            await it.until(lambda _: sent or it.app.main.features.driving.controls.mode is None)
            assert sent, it.app.main.notices.text
            taken.append((sent[0] - started) * 1000)
    return taken


async def direct(it: Console) -> list[float]:
    """The same way without the screen: the hand's speeds to the wire."""
    sent: list[float] = []
    taken = []
    drive = it.app.main.features.driving.controls.drive
    assert drive is not None and drive.state.phase is DrivePhase.READY
    with wiretap(moves, sent):
        for _ in range(PRESSES):
            drive.steer(Steering(STILL, 0.0))
            await asyncio.sleep(SILENCE)
            sent.clear()
            started = time.perf_counter()
            drive.steer(Steering(Speeds(turning=0.1), time.monotonic() + 0.2))
            await it.until(lambda _: sent or drive.state.phase is DrivePhase.ENDED)
            assert sent, drive.state.reason
            taken.append((sent[0] - started) * 1000)
    return taken


async def measure(robots: int) -> Row:
    with TemporaryDirectory() as folder, simulated(robots, 1, kind="nav2") as (url,):
        made = Path(folder)
        config = demo_config(Config(path=made / "bench"), url, robots, 1, kind="nav2", folder=made)
        config = replace(config, drive=DriveConfig(robot_timeout=0.5))
        store = WatchedStore(initial_state(config, time.monotonic()))
        app = FleetApp(config, store, load_themes(None)[0], Drawing.BRAILLE)
        async with app.run_test(size=(200, 60)) as pilot:
            it = Console(app, store, pilot)
            await it.until(lambda state: all(robot.pose for robot in state.robots.values()))
            await it.shows("Base", "map")
            await it.press("T")
            await it.shows("m/s", "map")
            screen, bare = await keys(it), await direct(it)
    what = f"key -> first twist on the wire, {robots} robot{'s' * (robots > 1)}, p95"
    print(f"{what}: p50 {sorted(screen)[len(screen) // 2]:.1f} ms, p95 {p95(screen):.1f} ms")
    return row("P25", what, p95(screen), "ms", TARGETS[robots], p95(bare), "speeds -> wire, no screen")


def main() -> list[Row]:
    return [asyncio.run(measure(robots)) for robots in TARGETS]


if __name__ == "__main__":
    main()
