"""Keys pressed while the console starts: they wait for the link, not for long, and are never lost."""

import threading
from collections.abc import Callable, Iterator

import pytest

from fleet_tui.config.schema import Config
from fleet_tui.model.problem import Permissions
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.state.store import Store
from fleet_tui.ui.backend import OpenLinks, connect_live
from fleet_tui.ui.controllers import dispatch
from tests.support import console_pilot
from tests.support.console_pilot import console
from tests.support.watched_store import config_of


@pytest.fixture
def gate(monkeypatch: pytest.MonkeyPatch) -> Iterator[threading.Event]:
    """The console connects when this is set."""
    opened = threading.Event()

    def opening(config: Config, store: Store, on_ready: Callable[[OpenLinks], None]) -> None:
        opened.wait(20)
        connect_live(config, store, on_ready)

    monkeypatch.setattr(console_pilot, "connect_live", opening)
    yield opened
    opened.set()


@pytest.mark.parametrize(("key", "service"), [("r", "Resume"), ("p", "Pause"), ("P", "Pause")])
async def test_a_key_pressed_before_the_link_is_there_is_sent_when_it_is(
    server: RosbridgeServer, gate: threading.Event, monkeypatch: pytest.MonkeyPatch, key: str, service: str
) -> None:
    monkeypatch.setattr(dispatch, "LINK_WITHIN", 20.0)
    monkeypatch.setattr(dispatch, "PAUSE_WITHIN", 20.0)
    async with console(config_of(server.url, 1), wait=False) as it:
        await it.press(key)
        await it.shows("waiting for the link")
        assert not server.bridge.services.calls
        gate.set()
        await it.until(lambda _: server.bridge.services.calls)
        await it.shows(f"{service.lower()}: confirmed" if key != "P" else "confirmed")
    assert [name.rpartition("/")[2] for name, _ in server.bridge.services.calls] == [service]


@pytest.mark.parametrize("key", ["r", "p"])
async def test_it_does_not_wait_for_ever(
    server: RosbridgeServer, gate: threading.Event, monkeypatch: pytest.MonkeyPatch, key: str
) -> None:
    monkeypatch.setattr(dispatch, "LINK_WITHIN", 0.2)
    monkeypatch.setattr(dispatch, "PAUSE_WITHIN", 0.2)
    async with console(config_of(server.url, 1), wait=False) as it:
        await it.press(key)
        it.app.set_interval(0.1, it.app.main.tick)
        while "not sent" not in it.text:
            await it.pilot.pause()
        gate.set()
        await it.until(lambda state: state.robots["robot_0"].queue)
    assert not server.bridge.services.calls


async def test_a_disarmed_console_holds_nothing(server: RosbridgeServer, gate: threading.Event) -> None:
    async with console(config_of(server.url, 1), wait=False) as it:
        it.app.main.dispatch.permissions = Permissions(armed=False)
        await it.press("r")
        assert "not armed" in it.app.main.notices.text
        gate.set()
        await it.until(lambda state: state.robots["robot_0"].queue)
    assert not server.bridge.services.calls
