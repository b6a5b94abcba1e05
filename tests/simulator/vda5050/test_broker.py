"""Tests of simulator/vda5050/broker."""

import asyncio

import pytest

from fleet_tui.config.load import from_text
from fleet_tui.model.commands import PauseRobot, PlaceOrder, ResumeRobot, Stage
from fleet_tui.model.geometry import Pose
from fleet_tui.model.link import CommandPath
from fleet_tui.model.order import Stop
from fleet_tui.simulator.vda5050 import broker as brokers
from fleet_tui.simulator.vda5050.broker import broker, free_port
from fleet_tui.simulator.vda5050.serving import VehicleClient, vehicles_of
from fleet_tui.text.errors import FleetError
from tests.support.broker import needs_mosquitto
from tests.support.driven_time import TIME
from tests.support.links import finished, linked
from tests.support.vda_fleet import config_text

SIMULATED = '[[robots]]\nname = "agv"\nlink = "broker"'


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


async def test_vehicles_on_the_embedded_broker_are_watched_and_driven(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    pytest.importorskip("amqtt")
    TIME.be_real()  # the vehicle's client waits for its socket in a thread that nothing can drive
    monkeypatch.setattr("shutil.which", lambda *_args, **_options: None)
    port = free_port()
    async with broker(port):
        (simulated,) = vehicles_of(["agv"], 1, 1, "")
        vehicle = await asyncio.to_thread(VehicleClient, simulated, port)
        stepping = asyncio.ensure_future(_stepped(vehicle))
        config = from_text(config_text(f"mqtt://127.0.0.1:{port}", robots=SIMULATED))
        async with linked(config) as (link, store):
            await store.until(lambda state: state.links["broker"].command_path is CommandPath.ALIVE)
            await store.until(lambda state: state.robots["agv"].pose and state.robots["agv"].vehicle)
            pose = store.state.robots["agv"].pose
            assert pose is not None
            paused = await finished(link, store, PauseRobot("agv"))
            assert paused.stage is Stage.CONFIRMED
            assert (await finished(link, store, ResumeRobot("agv"))).stage is Stage.CONFIRMED
            near = Stop(pose=Pose(pose.value.x + 0.5, pose.value.y))
            await finished(link, store, PlaceOrder("agv", (near,)))
            await store.until(lambda state: state.commands[-1].stage is Stage.DONE)
        stepping.cancel()
        await asyncio.to_thread(vehicle.close)


async def _stepped(vehicle: VehicleClient) -> None:
    """Let a vehicle live, five times as fast as time."""
    loop = asyncio.get_running_loop()
    while True:
        vehicle.step(0.25, loop.time(), 0.2)
        await asyncio.sleep(0.05)


async def test_without_any_broker_both_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("shutil.which", lambda *_args, **_options: None)
    monkeypatch.setattr(brokers, "find_spec", lambda _name: None)
    with pytest.raises(FleetError, match="apt install mosquitto, or pip install"):
        async with broker(0):
            pass
