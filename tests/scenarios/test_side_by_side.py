"""One console with robots behind rosbridge, a vehicle on a broker and fleets of Open-RMF."""

from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path

from fleet_tui.config.load import from_text
from fleet_tui.config.schema import Config
from fleet_tui.model.commands import PauseRobot, PlaceOrder
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import at_vertices
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.ui.view.tables.fleet import fleet_table
from tests.support.broker import broker_in
from tests.support.console_pilot import console
from tests.support.links import linked
from tests.support.rmf_site import FIRST, Hospital, hospital
from tests.support.vda_broker import SpokenFor

TEXT = """
[links.hall]
url = "{hall}"
profile = "oh_ressources"
[links.hospital]
url = "{hospital}"
profile = "rmf"
[links.broker]
url = "{broker}"
role = "master"
[[floors]]
name = "floor_0"
[[robots]]
name = "robot_0"
link = "hall"
[[robots]]
name = "tiny/robot_0"
link = "hospital"
[[robots]]
name = "agv"
manufacturer = "KIT"
serial = "0001"
link = "broker"
"""


Holds = Callable[[FleetState], bool]


def all_online(state: FleetState) -> bool:
    return all(state.is_online(robot) and robot.battery for robot in state.robots.values())


def is_driven(state: FleetState) -> bool:
    return state.robots[FIRST].orders.current is not None


@asynccontextmanager
async def three_kinds(folder: Path) -> AsyncIterator[tuple[Config, Hospital, SpokenFor, Holds]]:
    """A site of each kind: the configuration of all, the hospital, the vehicle, and whether all are known."""
    hall = RosbridgeServer(OhFleet(1, 1, quiet=True))
    await hall.start()
    try:
        with broker_in(folder) as broker:
            async with hospital(robots=1, speed=1.0) as site:
                vehicle = SpokenFor(broker)

                def online(state: FleetState) -> bool:
                    vehicle.say()  # until the console listens
                    return all_online(state) and state.robots[FIRST].knows_all_graphs()

                urls = {"hall": hall.url, "hospital": site.server.url, "broker": broker.url}
                yield from_text(TEXT.format(**urls)), site, vehicle, online
    finally:
        await hall.stop()


async def test_each_kind_is_shown_and_commanded_in_its_own_way(tmp_path: Path) -> None:
    async with three_kinds(tmp_path) as (config, site, vehicle, online), linked(config) as (link, store):
        state = await store.until(online)
        kinds = {name: robot.kind.name for name, robot in state.robots.items()}
        shown = [row.key for row in fleet_table(state, FIRST, 200).rows]
        link.submit(PlaceOrder(FIRST, at_vertices("Store", "Base")))
        await store.until(is_driven)
        for name in kinds:
            link.submit(PauseRobot(name))
        await store.until(lambda state: state.is_paused(state.robots[FIRST]))
        await store.until(lambda state: state.is_paused(state.robots["robot_0"]))
        await vehicle.next("instantActions")
        sent = [one["type"] for one in site.sent()]
    assert sent == ["robot_task_request", "interrupt_task_request"]
    assert kinds == {"robot_0": "oh_ressources", FIRST: "rmf", "agv": "vda5050"}
    assert shown == list(kinds)


async def test_all_kinds_are_on_one_screen_and_paused_by_one_key(tmp_path: Path) -> None:
    async with (
        three_kinds(tmp_path) as (config, _, vehicle, online),
        console(config, (80, 24), wait=False) as it,
    ):
        await it.until(online)
        for shown in ("Fleet 3 of 3 online", "1 robot_0", "2 tiny/robot_0", "3 agv"):
            await it.shows(shown)
        await it.press("2", "colon")
        await it.type("tiny/robot_0 > Store")
        await it.press("enter")
        await it.until(is_driven)
        await it.shows("-> Store")
        await it.press("P", "y")
        await it.until(lambda state: state.is_paused(state.robots[FIRST]))
        await it.until(lambda state: state.is_paused(state.robots["robot_0"]))
        await vehicle.next("instantActions")
