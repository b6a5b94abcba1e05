"""The console with a watch on what happens when; benchmarks start it in a pty.

Arguments: the file for what was noted (JSON, written at the end), what to watch for, `--`, and the
arguments of fleet-tui. Times are monotonic: the same clock in every process.
"""

import asyncio
import json
import sys
import time
from collections.abc import Callable
from functools import wraps
from pathlib import Path
from typing import Any

from textual.drivers.linux_driver import LinuxDriver

from fleet_tui.__main__ import main as fleet_tui
from fleet_tui.console.app import FleetApp
from fleet_tui.console.main_screen import MainScreen
from fleet_tui.model.events import Event, PoseReported
from fleet_tui.state.store import Store
from fleet_tui.ui.controllers.map import MapControls
from fleet_tui.ui.screens.tables.tools import FilterLine
from fleet_tui.ui.terminal.lean_app import LeanApp

BEAT = 0.002
noted: dict[str, list[Any]] = {
    "handler": [],
    "write": [],
    "tick": [],
    "pose": [],
    "beat": [],
    "map": [],
    "task": [],
    "count": [],
    "filter": [],
    "truth": [],
    "started": [],
}


def after(owner: type[Any], name: str, note: Callable[..., None]) -> None:
    """Have something noted whenever a method has run."""
    method = getattr(owner, name)

    @wraps(method)
    def watched(*args: Any, **options: Any) -> Any:
        result = method(*args, **options)
        note(*args, **options)
        return result

    setattr(owner, name, watched)


def before(owner: type[Any], name: str, kind: str) -> None:
    """Have the time noted whenever a method begins."""
    method = getattr(owner, name)

    @wraps(method)
    def watched(*args: Any, **options: Any) -> Any:
        noted[kind].append(time.monotonic())
        return method(*args, **options)

    setattr(owner, name, watched)


def stock() -> None:
    """Textual's own way to the terminal."""
    LeanApp.LEAN = False


def keys() -> None:
    before(MapControls, "zoom_in", "handler")  # to zoom out is to zoom in by less than one
    writes()


def filters() -> None:
    """Every filter, and when its rows were made."""

    def applied(line: FilterLine, typed: str) -> None:
        noted["filter"].append((time.monotonic(), typed))

    after(FilterLine, "_apply", applied)


def writes() -> None:
    before(LinuxDriver, "write", "write")


def poses() -> None:
    """Every pose that came, and at every tick the newest one shown of each robot, by their stamps."""

    def came(_store: Store, event: Event) -> None:
        if isinstance(event, PoseReported):
            noted["pose"].append((event.robot, event.stamp))

    def ticked(screen: MainScreen) -> None:
        shown = {robot.name: robot.clock.stamp for robot in screen.store.state.robots.values() if robot.clock}
        noted["tick"].append((time.monotonic(), time.time(), shown))

    after(Store, "apply", came)
    after(MainScreen, "tick", ticked)
    writes()


def beats() -> None:
    """The lateness of the screen's loop, and the width of the map that it shows."""

    def started(app: FleetApp) -> None:
        app.run_worker(beat())

    async def beat() -> None:
        due = time.monotonic()
        while True:
            due += BEAT
            await asyncio.sleep(due - time.monotonic())
            now = time.monotonic()
            noted["beat"].append((now, now - due))
            due = now

    def ticked(screen: MainScreen) -> None:
        # The first ticks come before the map.
        scene = screen.features.map.picture.scene if screen.is_complete else None
        width = scene.grid.frame.width if scene and scene.grid else 0
        if not noted["map"] or noted["map"][-1][1] != width:
            noted["map"].append((time.monotonic(), width))

    after(FleetApp, "on_ready", started)
    after(MainScreen, "tick", ticked)


def tasks() -> None:
    """The number of tasks of the screen's loop, once a second."""

    async def count() -> None:
        while True:
            noted["task"].append(len(asyncio.all_tasks()))
            await asyncio.sleep(1.0)

    after(FleetApp, "on_ready", lambda app: app.run_worker(count()))


def counts() -> None:
    """The numbers of topic messages that were applied, dropped and rejected."""
    from fleet_tui.links.fleet_link import FleetLink

    def closed(link: FleetLink) -> None:
        links = link.counters.values()
        topics = [topic for one in links for topic in one.topics.values()]
        lost = sum(one.dropped + one.unreadable for one in links)
        noted["count"].append((sum(topic.count - topic.errors for topic in topics), lost))

    after(FleetLink, "close", closed)


def truth() -> None:
    """Once a second: the robots online, the messages, those that were dropped or overtaken, and the alarms
    raised so far."""
    raised = set[tuple[object, float]]()

    def ticked(screen: MainScreen) -> None:
        now, state = time.monotonic(), screen.store.state
        raised.update((alarm.key, alarm.first_wall) for alarm in state.alarms)
        if noted["truth"] and now - noted["truth"][-1]["at"] < 1.0:
            return
        links = screen.backend.counters.values()
        look = {
            "at": now,
            "online": sum(map(state.is_online, state.robots.values())),
            "messages": sum(link.all.count for link in links),
            "dropped": sum(link.dropped + link.unreadable for link in links),
            "overtaken": sum(link.overtaken for link in links),
            "raised": len(raised),
        }
        noted["truth"].append(look)

    after(MainScreen, "tick", ticked)


def starts() -> None:
    """The times of the first ticks with the links, with the labels of the shown floor, with the poses of all
    robots, too, and with everything that is subscribed."""

    def ticked(screen: MainScreen) -> None:
        state, shown = screen.store.state, screen.navigation.selection
        known = state.robots[shown.robot].maps.get(shown.floor)
        steps = (
            all(link.was_up for link in state.links.values()),
            known is not None and bool(known.labels),
            all(robot.pose for robot in state.robots.values()),
            all(link.topics and not link.waiting_topics for link in state.links.values()),
        )
        if len(noted["started"]) < len(steps) and all(steps[: len(noted["started"]) + 1]):
            noted["started"].append(time.monotonic())

    after(MainScreen, "tick", ticked)


KINDS = {
    "starts": starts,
    "truth": truth,
    "stock": stock,
    "filters": filters,
    "keys": keys,
    "poses": poses,
    "beats": beats,
    "tasks": tasks,
    "counts": counts,
}


def main() -> None:
    path, *wanted = sys.argv[1 : sys.argv.index("--")]
    sys.argv = ["fleet-tui", *sys.argv[sys.argv.index("--") + 1 :]]
    for name in wanted:
        KINDS[name]()
    try:
        fleet_tui()
    finally:
        Path(path).write_text(json.dumps(noted))


if __name__ == "__main__":
    main()
