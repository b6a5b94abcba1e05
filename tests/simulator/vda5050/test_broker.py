"""Tests of fleet_tui/simulator/vda5050/broker.py."""

import asyncio

import pytest

from fleet_tui.errors import FleetError
from fleet_tui.simulator.vda5050 import broker as brokers
from fleet_tui.simulator.vda5050.broker import broker, free_port
from tests.support.mosquitto import needs_mosquitto


@needs_mosquitto
async def test_a_broker_of_ours_listens_and_ends() -> None:
    port = free_port()
    async with broker(port):
        _, writer = await asyncio.open_connection("127.0.0.1", port)
        writer.close()
    with pytest.raises(OSError):  # any reason not to connect
        await asyncio.open_connection("127.0.0.1", port)


@needs_mosquitto
async def test_a_port_that_is_taken_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    async def never(*_: object) -> None:
        raise OSError

    monkeypatch.setattr(asyncio, "open_connection", never)
    monkeypatch.setattr(brokers, "STARTS_WITHIN", 0.2)
    with pytest.raises(FleetError, match="mosquitto did not start on port"):
        async with broker(free_port()):
            pass


async def test_without_any_broker_both_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("shutil.which", lambda *_args, **_options: None)
    monkeypatch.setattr(brokers, "find_spec", lambda _name: None)
    with pytest.raises(FleetError, match="apt install mosquitto, or pip install"):
        async with broker(0):
            pass
