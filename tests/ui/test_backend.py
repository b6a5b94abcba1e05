"""A live backend while its links are being opened: nothing is sent, nothing that is wanted gets lost."""

from collections.abc import Mapping, Sequence

import pytest

from fleet_tui.config.schema import Config
from fleet_tui.model.commands import Command, PauseRobot
from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.events import Event
from fleet_tui.state.store import Store
from fleet_tui.text.errors import CommandError
from fleet_tui.ui.backend import LiveBackend
from tests.support.desk import StubDrive
from tests.support.fleets import R0, fleet


class CalledLinks:
    """Notes what they are called for."""

    def __init__(self) -> None:
        self.calls: list[object] = []
        self.counters: Mapping[str, LinkCounter] = {}

    def extend(self, config: Config) -> None:
        self.calls.append(config)

    def submit_all(self, commands: Sequence[Command]) -> None:
        self.calls += commands

    def drive(self, robot: str) -> StubDrive:
        self.calls.append(robot)
        return StubDrive()

    def post(self, event: Event) -> None:
        self.calls.append(event)

    def show_map(self, robot: str, floor: str) -> None:
        self.calls.append((robot, floor))

    def subscribe_logs(self, on: bool) -> None:
        self.calls.append(on)

    def close(self) -> None:
        self.calls.append("close")


def backend_of(links: CalledLinks) -> LiveBackend:
    return LiveBackend(Config(), Store(fleet(1)), lambda _config, _store, enter: enter(links))


def test_before_the_links_are_open_a_command_is_refused_and_never_sent() -> None:
    links = CalledLinks()
    backend = backend_of(links)
    assert backend.submit(PauseRobot(R0)) == "not sent: console starting"
    backend.open()
    assert links.calls == []
    assert backend.submit(PauseRobot(R0)) == ""
    assert links.calls == [PauseRobot(R0)]


def test_before_the_links_are_open_no_drive_begins() -> None:
    links = CalledLinks()
    backend = backend_of(links)
    with pytest.raises(CommandError, match="console starting"):
        backend.drive(R0)
    backend.open()
    assert isinstance(backend.drive(R0), StubDrive)
    assert links.calls == [R0]


def test_what_is_to_be_watched_is_asked_for_once_they_are_open() -> None:
    links = CalledLinks()
    backend = backend_of(links)
    backend.show_map(R0, "floor_0")
    backend.show_map(R0, "floor_1")
    backend.subscribe_logs(True)
    backend.open()
    assert links.calls == [(R0, "floor_1"), True]


def test_links_that_come_after_the_end_are_closed_once() -> None:
    links = CalledLinks()
    backend = backend_of(links)
    backend.show_map(R0, "floor_0")
    backend.close()
    backend.open()
    assert links.calls == ["close"]
