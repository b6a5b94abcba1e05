"""What a vehicle of a master control reports beside the values of all robots, for its page."""

from collections.abc import Iterator

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.rules.alarms.facilities import listed
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.robot_page import named
from fleet_tui.view.tables.table import Run

SHOWN = 12
"""Properties that are listed."""


def vehicle_rows(state: FleetState, robot: Robot) -> Iterator[tuple[Run, ...]]:
    """Yield its connection, mode, node, load and speed, each as far as it is reported."""
    if robot.connection is not None:
        known = robot.connection.value
        text = f"{known.text}, VDA 5050 {known.version}" if known.version else known.text
        yield named("Broker", (sanitize(text), StyleRole.WARN if known.is_gone else StyleRole.TEXT))
    if robot.vehicle is not None:
        vehicle = robot.vehicle.value
        role = StyleRole.TEXT if state.is_fresh(robot, "vehicle") else StyleRole.DIM
        rows = (
            named("Mode", *_run(vehicle.mode.lower(), role)),
            named("Node", *_run(vehicle.last_node, role)),
            named("Load", *_run(vehicle.load or "", role)),
            named("Maps", *_run(", ".join(vehicle.maps), role)),
            named("Zones", *_run(", ".join(vehicle.zone_sets), role)),
            named("Charging", *_run(_yes_or_no(vehicle.charging), role)),
            named("Speed", *_run("" if vehicle.speed is None else f"{vehicle.speed:.2f} m/s", role)),
        )
        yield from (row for row in rows if row)
    for one in listed(state, robot.link):
        if one.user == robot.name:
            yield named(one.sort.capitalize(), (sanitize(f"{one.name}: {one.state}"), StyleRole.TEXT))
    if robot.master is not None:
        text = f"{robot.master.value}, {age(state.now - robot.master.at)} ago"
        yield named("Master", (sanitize(text), StyleRole.TEXT))


def _run(value: str, role: StyleRole) -> tuple[Run, ...]:
    return ((sanitize(value), role),) if value else ()


def _yes_or_no(value: bool | None) -> str:
    return "" if value is None else tr("yes") if value else tr("no")


def factsheet_rows(robot: Robot) -> Iterator[tuple[Run, ...]]:
    """Yield the properties of a vehicle from its factsheet."""
    for name, value in list(robot.factsheet.items())[:SHOWN]:
        yield ((f"{sanitize(name):<20} ", StyleRole.DIM), (sanitize(value), StyleRole.TEXT))
