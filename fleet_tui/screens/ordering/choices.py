"""Meanings of a field of the order form, and their texts."""

from collections.abc import Sequence

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import Phase
from fleet_tui.model.request import Request, chain
from fleet_tui.model.robot import Robot
from fleet_tui.rules.language.lookup import Place, matches, places, recent_ends
from fleet_tui.text.sanitize import sanitize

SHOWN = 8

Choices = list[Place] | list[str]


def choices(
    state: FleetState, robot: Robot | None, field: str, typed: str, chosen: Place | None = None
) -> Choices:
    """Return the choices, best first; in `to` the robot's last destination leads."""
    if field == "robot":
        wanted = typed.strip().casefold()
        return [name for name in state.robots if wanted in name.casefold()][:SHOWN]
    if robot is None:
        return []
    found = matches(robot, typed, recent_ends(state, robot) if field == "to" else ())[:SHOWN]
    if chosen is None or sanitize(chosen.name) != typed:
        return found
    # Floors may share labels: Enter takes the chosen one again.
    return [chosen, *(place for place in found if place != chosen)]


def is_in_label(robot: Robot | None, typed: str) -> bool:
    """Tell whether a label of the robot contains this."""
    return robot is not None and any(typed.casefold() in place.name.casefold() for place in places(robot))


def order(robot: Robot, visited: Sequence[Place], only_to: bool) -> Request:
    """Return orders that visit the places in sequence; `only_to`: without a start."""
    floors = {place.vertex: place.floor for place in visited}
    vertices = [place.vertex for place in visited]
    return Request(chain(robot.name, vertices, only_to, robot.kind.takes_stops), floors)


def title(robot: Robot | None, has_start: bool) -> str:
    """Return the title of the form."""
    loaded = robot is not None and robot.has_cargo
    return "Destination of the cargo on board" if loaded and not has_start else "Order"


def wanted_now(robot: Robot, only_to: bool) -> str:
    """Return the notice after a change of the robot's cargo or orders."""
    alone = "now has cargo and no orders: To only" if robot.has_cargo else "needs only To"
    return f"{robot.name} {alone if only_to else 'now needs From'}. Enter sends"


def missing(field: str, typed: str = "") -> str:
    """Return the text for a missing field."""
    if typed.strip():
        return f"{field.capitalize()}: Enter takes the marked place"
    remedy = "its name" if field == "robot" else "a label or a vertex id"
    return f"{field.capitalize()} is missing: type {remedy}"


def without_places(robot: Robot | None) -> str:
    """Return the notice for a robot that has no places to choose, empty for others."""
    if robot is None or places(robot):
        return ""
    return f"{robot.name} has no route graph yet: there are no places to choose"


def hindrance(state: FleetState, robot: Robot | None) -> str:
    """Return why no order can be given to a robot now, empty if one can."""
    if robot is not None and state.links[robot.link].phase is not Phase.UP:
        return "no link: an order is not sent now, and not later"
    return without_places(robot)


def line(choice: Place | str) -> str:
    """Return the line of a choice."""
    return (
        choice
        if isinstance(choice, str)
        else f"{sanitize(choice.name)}  ({sanitize(choice.vertex)}, {choice.floor})"
    )
