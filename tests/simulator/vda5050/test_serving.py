"""Tests of simulator/vda5050/serving: `fleet-tui sim --kind vda5050` as a process."""

import signal
import socket
from pathlib import Path

import pytest

from fleet_tui.config.load import from_text
from fleet_tui.maps.route_graphs import load_floor_graph
from fleet_tui.model.commands import ClearOrders, PauseRobot, PlaceOrder, ResumeRobot, Stage
from fleet_tui.model.order import at_vertices
from fleet_tui.simulator.graph_files import write_lif
from fleet_tui.simulator.vda5050.serving import vehicles_of
from fleet_tui.text.errors import ConfigError
from tests.support.in_pty import serving
from tests.support.links import finished, linked
from tests.support.polling import HANGS


def test_vehicles_stand_at_places_of_their_floors_with_their_faults() -> None:
    made = vehicles_of(["robot_0", "robot_1", "robot_2"], 2, 1, "paused:robot_1,battery")
    assert [one.map_id for one in made] == ["floor_0", "floor_1", "floor_0"]
    assert [one.paused for one in made] == [False, True, False] and {one.battery for one in made} == {9.0}
    with pytest.raises(ConfigError, match="unknown fault"):
        vehicles_of(["robot_0"], 1, 1, "teapot")


async def test_a_console_drives_a_simulated_vehicle(tmp_path: Path) -> None:
    (graph,) = write_lif(tmp_path, 1)
    sim = ("sim", "--kind", "vda5050", "--port", "0", "--robots", "1", "--floors", "1", "--speed", "20")
    with serving("fleet_tui", *sim, "--stop-with-stdin") as (url, _):
        config = from_text(
            f'[links.b]\nurl = "{url}"\nrole = "master"\n[[floors]]\nname = "floor_0"\n'
            '[[robots]]\nname = "robot_0"\nlink = "b"\n'
        )
        async with linked(config) as (link, store):
            link.post(load_floor_graph("floor_0", graph))
            await store.until(
                lambda state: state.robots["robot_0"].vehicle and state.robots["robot_0"].factsheet
            )
            for command in (PauseRobot("robot_0"), ResumeRobot("robot_0")):
                assert (await finished(link, store, command)).stage is Stage.CONFIRMED
            goal = "0" if store.state.robots["robot_0"].vehicle.value.last_node != "0" else "19"  # type: ignore[union-attr]  # it came
            assert (
                await finished(link, store, PlaceOrder("robot_0", at_vertices(goal)))
            ).stage is Stage.CONFIRMED
            await store.until(lambda state: state.commands[-1].stage is Stage.DONE)
            assert (await finished(link, store, ClearOrders("robot_0"))).stage is Stage.REFUSED


def test_its_broker_ends_with_the_terminal_that_it_was_started_in() -> None:
    with serving("fleet_tui", "sim", "--kind", "vda5050", "--port", "0", "--robots", "1") as (url, sim):
        port = int(url.rpartition(":")[2])
        socket.create_connection(("127.0.0.1", port)).close()
        sim.send_signal(signal.SIGHUP)
        assert sim.wait(HANGS) == 0
        with pytest.raises(ConnectionRefusedError):
            socket.create_connection(("127.0.0.1", port))
