"""Orders in a console under the pilot, typed as a person or a paste does, and what reached the wire."""

from typing import Any

from fleet_tui.commands.checks import SAME_WITHIN
from fleet_tui.model.commands import PlaceOrder
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import Console
from tests.support.fleets import place_order


def sent(server: RosbridgeServer) -> list[tuple[str, dict[str, Any]]]:
    """The calls that arrived, services by their last name, without request ids."""
    return [
        (service.rpartition("/")[2], {key: value for key, value in args.items() if key != "request_id"})
        for service, args in server.bridge.services.calls
    ]


def vertex(it: Console, label: str, robot: str = "robot_0") -> int:
    """The id of a vertex as it is on the wire."""
    maps = it.store.state.robots[robot].maps.values()
    return next(int(id_) for robot_map in maps for id_, name in robot_map.labels.items() if name == label)


def order(it: Console, *labels: str, robot: str = "robot_0") -> PlaceOrder:
    """An order from one place to another, or of the cargo on board to one."""
    return place_order(robot, *(vertex(it, label, robot) for label in labels))


async def place(it: Console) -> None:
    """An order by the promised keys; the same one given again at once would count as a slip."""
    given = [record.issued_at for record in it.store.state.commands]
    await it.until(lambda state: not given or state.now - given[-1] >= SAME_WITHIN)
    await it.press("o")
    await it.type("Base")
    await it.press("enter")
    await it.type("Consumidores")
    await it.press("enter")


def one_packet(it: Console, text: str) -> None:
    """Every key arrives at the same moment, a second later, as a slow line or a paste delivers them."""
    named = {"\r": "enter", "\t": "tab", "\x1b": "escape", " ": "space"}
    it.packet(*(named.get(letter, letter) for letter in text))
