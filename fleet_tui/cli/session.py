"""A link for one command line: opened, waited on, closed."""

import signal
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from types import FrameType

from fleet_tui.config.access import access_problems
from fleet_tui.config.fleet import watching
from fleet_tui.config.log_file import state_folder
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.links.tap import Tap
from fleet_tui.maps.floor_files import load_graphs
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.model.robot import Robot
from fleet_tui.records.audit.elsewhere import watched_commands
from fleet_tui.situation.robots import may_be_back
from fleet_tui.state.store import Store
from fleet_tui.text.errors import ConfigError

ENDING = (signal.SIGTERM, signal.SIGHUP)
"""Signals of services and of a closed terminal."""


class WaitingStore(Store):
    """A store on which another thread can wait."""

    def __init__(self, state: FleetState) -> None:
        super().__init__(state)
        self._changed = threading.Condition()

    def apply(self, event: Event) -> None:
        """Apply one event, and wake the waiting thread."""
        super().apply(event)
        with self._changed:
            self._changed.notify_all()

    def wait(self, holds: Callable[[FleetState], object], seconds: float) -> bool:
        """Wait at most `seconds` until the state meets a condition; tell whether it does."""
        with self._changed:
            return bool(self._changed.wait_for(lambda: holds(self.state), seconds))


@contextmanager
def session(
    config: Config, tap: Tap | None = None, store: WaitingStore | None = None
) -> Iterator[tuple[FleetLink, WaitingStore]]:
    """Connect to every bridge of a config, load the floors' graphs, and close again."""
    store = store or WaitingStore(initial_state(config, time.monotonic()))
    link = FleetLink(config, store, tap)
    with opened(link, config), watched_commands(state_folder(), store, link.post):
        yield link, store


@contextmanager
def opened(link: FleetLink, config: Config) -> Iterator[FleetLink]:
    """Connect, load the floors' graphs, and close again."""
    link.open()
    try:
        for loaded in load_graphs(config):
            link.post(loaded)
        yield link
    finally:
        link.close()


def missing(robot: Robot) -> list[str]:
    """Return the missing values of a robot, of those its kind always reports."""
    expected = filter(robot.kind.expects, ("pose", "battery", "cargo", "obstacle", "queue"))
    values = {name: getattr(robot, name) for name in expected}
    for floor, robot_map in robot.maps.items():
        if robot.kind.expects("graph"):
            values[f"graph of {floor}"] = robot_map.graph
        if robot.kind.expects("labels"):
            values[f"labels of {floor}"] = robot_map.labels or None
    if robot.kind.optional and not robot.is_gone:  # its state has all of them, as far as it has them
        values["state"] = robot.vehicle
    return [name for name, value in values.items() if value is None and name not in robot.unmeasured]


def is_known(state: FleetState) -> bool:
    """Tell whether all requested values have arrived."""
    links = all(
        link.phase is Phase.UP and link.command_path is not CommandPath.UNTRIED
        for link in state.links.values()
    )
    awaited = (
        missing(robot)
        or may_be_back(state, robot)
        or (robot.kind.expects("servers") and robot.servers is None)
        for robot in state.robots.values()
    )
    return links and not any(awaited)


def has_link(state: FleetState) -> bool:
    """Tell whether any bridge is connected."""
    return any(link.phase is Phase.UP for link in state.links.values())


def only_watching(config: Config) -> Config:
    """Return the configuration of a console that only watches. Before a file is created: raises ConfigError
    for an unsafe secret."""
    config = watching(config)
    if problems := access_problems(config):
        raise ConfigError([f"{config.path}: {line}" for line in problems])
    return config


class Ended(Exception):  # noqa: N818  # asked for from outside, no error
    """Ended by a signal, or by the closing of its terminal."""


@contextmanager
def ended_by_signals() -> Iterator[None]:
    """Raise Ended at a signal that asks a process to end."""
    # Under nohup it continues after its terminal is closed.
    numbers = [one for one in ENDING if signal.getsignal(one) is not signal.SIG_IGN]

    def end(_number: int, _frame: FrameType | None) -> None:
        # A further signal must not interrupt the end.
        for number in numbers:
            signal.signal(number, signal.SIG_IGN)
        raise Ended

    for number in numbers:
        signal.signal(number, end)
    with suppress(Ended):
        yield
