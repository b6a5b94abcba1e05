"""Meanings of a field of the order form, and their texts."""

from collections.abc import Callable, Sequence

from fleet_tui.errors import did_you_mean
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import GOAL
from fleet_tui.model.link import Phase
from fleet_tui.model.robot import Robot
from fleet_tui.rules.language.anyone import ANYONE, any_matches
from fleet_tui.rules.language.favourites import Favourite, Given, favourites
from fleet_tui.rules.language.lookup import Place, matches, places, recent_ends
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import sanitize

SHOWN = 8

Choice = Place | str | Favourite
"""A place, the name of a robot, or a whole order to give again."""
Choices = Sequence[Choice]


def choices(
    state: FleetState,
    robot: Robot | None,
    field: str,
    typed: str,
    chosen: Place | None = None,
    given: Callable[[], Sequence[Given]] = tuple,
) -> Choices:
    """Return the choices, best first; in `to` the robot's last destination leads, in an empty `from` the
    favourites of the orders `given`. Without a robot they are those of any."""
    if field == "robot":
        return _robots(state, typed.strip().casefold())
    if robot is None:
        found = any_matches(state, typed)
    else:
        found = matches(robot, typed, recent_ends(state, robot) if field == "to" else ())
    if field == "from" and not typed.strip():
        listed: list[Choice] = [*favourites(found, given()), *found]
        return listed[:SHOWN]
    if chosen is None or sanitize(chosen.name) != typed:
        return found[:SHOWN]
    # Floors may share labels: Enter takes the chosen one again.
    return [chosen, *(place for place in found[:SHOWN] if place != chosen)]


def _robots(state: FleetState, wanted: str) -> list[str]:
    found = [name for name in state.robots if wanted in name.casefold()][: SHOWN - 1]
    if not wanted:
        return [ANYONE, *found]
    return [*found, ANYONE] if ANYONE.startswith(wanted) else found


def is_in_label(robot: Robot | None, typed: str) -> bool:
    """Tell whether a label of the robot contains this."""
    return robot is not None and any(typed.casefold() in place.name.casefold() for place in places(robot))


def title(robot: Robot | None, has_start: bool) -> str:
    """Return the title of the form; without a robot the order is for anyone."""
    if robot is None:
        return tr("Order for the nearest idle robot")
    return tr("Destination of the cargo on board") if robot.has_cargo and not has_start else tr("Order")


def wanted_now(robot: Robot, only_to: bool) -> str:
    """Return the notice after a change of the robot's cargo or orders."""
    alone = tr("now has cargo and no orders: To only") if robot.has_cargo else tr("needs only To")
    return tr(f"{robot.name} {alone if only_to else tr('now needs From')}. Enter sends")


def missing(field: str, typed: str = "") -> str:
    """Return the text for a missing field."""
    if typed.strip():
        return tr(f"{tr(field.capitalize())}: Enter takes the marked place")
    remedy = tr("its name") if field == "robot" else tr("a label or a vertex id")
    return tr(f"{tr(field.capitalize())} is missing: type {remedy}")


def no_match(robot: Robot | None, field: str, typed: str) -> str:
    """Return the text for typed words that are no choice, with the nearest place or nothing."""
    near = did_you_mean(typed, [place.name for place in places(robot)]) if robot and field != "robot" else ""
    return tr(f"{tr(field.capitalize())}: no match for {typed!r}{sanitize(near)}")


def without_places(robot: Robot | None) -> str:
    """Return the notice for a robot that has no places to choose, empty for others."""
    if robot is None or places(robot):
        return ""
    if "graph" in robot.kind.reports:
        return tr(f"{robot.name} has no route graph yet: there are no places to choose")
    aim = tr("; G sends it to a point of the map") if robot.kind.can(GOAL) else ""
    return tr(f"{robot.name} publishes no route graph: set [[floors]] graph = FILE in the configuration{aim}")


def hindrance(state: FleetState, robot: Robot | None) -> str:
    """Return why no order can be given to a robot now, empty if one can."""
    if robot is not None and state.links[robot.link].phase is not Phase.UP:
        return tr("no link: an order is not sent now, and not later")
    return without_places(robot)


def line(choice: Choice) -> str:
    """Return the line of a choice."""
    if isinstance(choice, Favourite):
        return f"{sanitize(choice.start.name)} -> {sanitize(choice.end.name)}  ({tr(choice.reason)})"
    if isinstance(choice, str):
        return tr(f"{ANYONE}: the nearest idle robot") if choice == ANYONE else choice
    return f"{sanitize(choice.name)}  ({sanitize(choice.vertex)}, {choice.floor})"
