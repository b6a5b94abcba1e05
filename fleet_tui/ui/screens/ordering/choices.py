"""Meanings of a field of the order form, and their texts."""

import math
from collections import Counter
from collections.abc import Callable, Sequence

from fleet_tui.commands.checks import robot_problems
from fleet_tui.commands.language.any_robot import ANYONE, any_matches
from fleet_tui.commands.language.favourites import Favourite, Given, favourites
from fleet_tui.commands.language.lookup import HERE, Place, matches, places, recent_ends, starts_here
from fleet_tui.commands.routes.charging import way_to_charger
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import Role, Vertex
from fleet_tui.model.kind import GOAL, ORDER
from fleet_tui.model.link import Phase
from fleet_tui.model.problem import Problem
from fleet_tui.model.robot import Robot
from fleet_tui.situation.battery.charging import charging_remedy, has_low_battery
from fleet_tui.situation.reported_motion import STANDS_AFTER
from fleet_tui.text.errors import did_you_mean
from fleet_tui.text.language import EMPTY, Message, tr, translate
from fleet_tui.text.sanitize import cell_width, sanitize
from fleet_tui.ui.view.tables.news import failed_command, news
from fleet_tui.ui.view.tables.table import column

CHARGE = Message("charge")
SHOWN = 30
LONGEST = 24
"""Choices that are listed, and cells of the column of their names."""
ROLES = {Role.DOCKING: Message("charger"), Role.ELEVATOR: Message("lift")}

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
    start: Place | None = None,
) -> Choices:
    """Return the choices, best first, until something is typed with the remedy of a low battery before all.
    `given` are the orders to give again, `start` the place from which the order leads. Without a robot they
    are those of any."""
    if field == "robot":
        return _robots(state, typed.strip().casefold())
    if field == "from" and robot is not None and ORDER not in robot.kind.accepts:
        return [HERE] if _may_be_here(robot, typed) else []
    if field == "from" and chosen == HERE and typed.strip() == HERE.name:
        typed = ""
    if not typed.strip():
        return _untyped(state, robot, field, given, start)[:SHOWN]
    recent = recent_ends(state, robot) if robot is not None and field == "to" else ()
    found = matches(robot, typed, recent) if robot is not None else any_matches(state, typed)
    if field == "from" and robot is not None and _may_be_here(robot, typed):
        found = [*found, HERE]
    if chosen is None or sanitize(chosen.name) != typed:
        return found[:SHOWN]
    # Floors may share labels: Enter takes the chosen one again.
    return [chosen, *(place for place in found[:SHOWN] if place != chosen)]


def _untyped(
    state: FleetState,
    robot: Robot | None,
    field: str,
    given: Callable[[], Sequence[Given]],
    start: Place | None,
) -> list[Choice]:
    """Return the choices before anything is typed: a charger, if the battery is low; in `from` HERE, if the
    robot can start there, and the orders to give again, in `to` the robot's last destinations; then the
    others by their distance."""
    if robot is None:
        found = any_matches(state, "")
        return [*favourites(found, given()), *found] if field == "from" else [*found]
    found = _by_distance(state, robot, places(robot), start)
    if not robot.kind.changes_floors:
        found = [place for place in found if place.floor == robot.floor] or found
    charge = charge_first(state, robot)
    if field == "from":
        here = [HERE] if starts_here(robot) else []
        first = [Favourite(charge[0], charge[-1], CHARGE)] if charge and not here else []
        return [*first, *here, *favourites(found, given()), *found]
    recent = {vertex: rank for rank, vertex in enumerate(recent_ends(state, robot))}
    found.sort(key=lambda place: recent.get(place.vertex, len(recent)))
    found.sort(key=lambda place: place not in charge[-1:])
    return [*found]


def _by_distance(state: FleetState, robot: Robot, found: Sequence[Place], start: Place | None) -> list[Place]:
    """Sort places of the floor of the start by their distance, before those of other floors."""
    floor = start.floor if start is not None else robot.floor
    return sorted(found, key=lambda place: (place.floor != floor, _metres(state, robot, place, start) or 0.0))


def _metres(state: FleetState, robot: Robot, place: Place, start: Place | None) -> float | None:
    """Return the metres to a place of the same floor in a straight line, from the robot only while it
    stands."""
    vertex, begin = _vertex(robot, place), _vertex(robot, start) if start is not None else None
    if vertex is None or place.floor != (start.floor if start is not None else robot.floor):
        return None
    if start is not None:
        return math.dist((vertex.x, vertex.y), (begin.x, begin.y)) if begin is not None else None
    pose = robot.pose if state.is_fresh(robot, "pose") and robot.still_for >= STANDS_AFTER else None
    return math.dist((vertex.x, vertex.y), (pose.value.x, pose.value.y)) if pose is not None else None


def charge_first(state: FleetState, robot: Robot | None) -> tuple[Place, ...]:
    """Return the way to a charger of a robot whose battery is low; empty if that rises, or without one."""
    if robot is None or not has_low_battery(state, robot) or charging_remedy(state, robot):
        return ()
    return way_to_charger(state, robot)


def _may_be_here(robot: Robot, typed: str) -> bool:
    return starts_here(robot) and HERE.name.startswith(typed.strip().casefold())


def _robots(state: FleetState, wanted: str) -> list[str]:
    found = [name for name in state.robots if wanted in name.casefold()][: SHOWN - 1]
    if not wanted:
        return [ANYONE, *found]
    return [*found, ANYONE] if ANYONE.startswith(wanted) else found


def is_in_label(robot: Robot | None, typed: str) -> bool:
    """Tell whether a label of the robot contains this."""
    return robot is not None and any(typed.casefold() in place.name.casefold() for place in places(robot))


def title(robot: Robot | None) -> str:
    """Return the title of the form; without a robot the order is for anyone."""
    if robot is None:
        return tr("Order for the nearest idle robot")
    carries = robot.kind.brings_cargo and starts_here(robot)
    return tr("Destination of the cargo on board") if carries else tr("Order")


def changed(names: Sequence[str]) -> Message:
    """Return the notice about places that were chosen and are no longer what they were."""
    listed = ", ".join(map(sanitize, names))
    return Message("{listed}: changed meanwhile, choose again", listed=listed)


def missing(field: str, typed: str = "") -> Message:
    if typed.strip():
        return Message("{field}: Enter takes the marked place", field=tr(field.capitalize()))
    remedy = tr("its name") if field == "robot" else tr("a label or a vertex id")
    return Message("{field} is missing: type {remedy}", field=tr(field.capitalize()), remedy=remedy)


def no_match(robot: Robot | None, field: str, typed: str) -> Message:
    """Return the text for typed words that are no choice, with the nearest place or nothing."""
    near = (
        did_you_mean(typed, [place.name for place in places(robot)]) if robot and field != "robot" else EMPTY
    )
    return Message(
        "{field}: no match for {typed}{near}",
        field=tr(field.capitalize()),
        typed=f"{typed!r}",
        near=translate(sanitize(near)),
    )


def without_places(robot: Robot | None) -> Message:
    """Return the notice for a robot that has no places to choose, empty for others."""
    if robot is None or places(robot):
        return EMPTY
    if "graph" in robot.kind.reports:
        return Message("{name} has no route graph yet: there are no places to choose", name=robot.name)
    aim = tr("; G sends it to a point of the map") if robot.kind.can(GOAL) else ""
    return Message(
        "{name} publishes no route graph: set [[floors]] graph = FILE in the configuration{aim}",
        name=robot.name,
        aim=aim,
    )


def hindrance(state: FleetState, robot: Robot | None) -> Message:
    """Return why no order can be given to a robot now, empty if one can."""
    if robot is not None and state.links[robot.link].phase is not Phase.UP:
        return Message("no link: an order is not sent now, and not later")
    return without_places(robot)


def condition(state: FleetState, robot: Robot | None) -> str:
    """Return what is not as usual with a robot, in the words of its row and its alarm, empty for nothing."""
    if robot is None:
        return ""
    texts = [text for text, _ in (*failed_command(state, robot), *news(state, robot))]
    if robot.battery is not None and has_low_battery(state, robot):
        texts.insert(0, tr("battery {percent} %", percent=int(robot.battery.value)))
    return ", ".join(texts)


def warnings(state: FleetState, robot: Robot | None, found: Sequence[Problem]) -> str:
    """Return what speaks against an order now, of its problems `found` those that its robot's condition does
    not tell; empty for nothing."""
    told = robot_problems(state, robot) if robot is not None else []
    texts = (problem.text for problem in found if problem.blocks or problem not in told)
    return "; ".join(translate(sanitize(text)) for text in texts)


def scope(robot: Robot | None, typed: str, found: Choices) -> str:
    """Return which places are listed before anything is typed, empty if all are on one floor."""
    listed = [one for one in found if isinstance(one, Place) and one != HERE]
    if robot is None or typed.strip() or not listed:
        return ""
    every, floor = len(places(robot)), sanitize(listed[0].floor)
    own = sum(one.floor == listed[0].floor for one in listed)
    if own == len(listed) < every:
        return tr("{own} of {every}, all on {floor}: type for others", own=own, every=every, floor=floor)
    if len(listed) < every:
        count = len(listed)
        return tr("{count} of {every}: type for others", count=count, every=every)
    others = every - own
    return (
        tr("{own} on {floor}, then {others} elsewhere", own=own, floor=floor, others=others) if others else ""
    )


def lines(
    state: FleetState, robot: Robot | None, typed: str, found: Choices, start: Place | None = None
) -> list[str]:
    """Return the line of each choice: places in columns, for `to` with their way from the chosen `start`."""
    named = [one for one in found if isinstance(one, Place)]
    same = Counter(one.name for one in named)
    names = {
        one: sanitize(one.name) + (f" ({sanitize(one.vertex)})" if _needs_id(one, same, typed) else "")
        for one in named
    }
    cells = column(names.values(), at_most=LONGEST) + 2
    charger = () if typed.strip() else charge_first(state, robot)[-1:]
    is_first = charger == (*found[:1],)  # elsewhere it is a place as any other
    return [
        _in_column(names[one], cells, _about(state, robot, one, start, is_remedy=is_first and one in charger))
        if isinstance(one, Place)
        else line(one)
        for one in found
    ]


def _in_column(name: str, cells: int, about: str) -> str:
    """Return a name and what is told of it, below each other unless a name is too long."""
    return f"{name}{' ' * max(2, cells - cell_width(name))}{about}".rstrip()


def _needs_id(place: Place, same: Counter[str], typed: str) -> bool:
    return place.vertex not in ("", place.name) and (same[place.name] > 1 or typed.strip() == place.vertex)


def _vertex(robot: Robot, place: Place) -> Vertex | None:
    graph = robot.maps[place.floor].graph if place.floor in robot.maps else None
    return graph.vertices.get(place.vertex) if graph is not None else None


def _about(
    state: FleetState, robot: Robot | None, place: Place, start: Place | None, *, is_remedy: bool
) -> str:
    """Return the kind of a place, its floor if it is on another one than the start or the robot, else the
    metres to it in a straight line."""
    if place == HERE:
        carries = robot is not None and robot.kind.brings_cargo
        return tr("with the cargo on board") if carries else tr("where the robot is")
    if robot is None:
        return sanitize(place.floor) if len(state.floors) > 1 else ""
    vertex = _vertex(robot, place)
    role = ROLES.get(vertex.role, EMPTY) if vertex is not None else EMPTY
    parts = [translate(CHARGE)] if is_remedy else []
    parts += [translate(role)] if role and role not in place.name.casefold() else []
    if vertex is not None and vertex.role is Role.DOCKING and robot.features and robot.features.charges:
        parts.append(tr("charges there"))
    metres = _metres(state, robot, place, start)
    if place.floor != (start.floor if start is not None else robot.floor):
        parts.append(sanitize(place.floor))
    elif start is not None and metres is not None:
        if place != start:
            parts.append(tr("{metres} m from {named}", metres=f"{metres:.0f}", named=sanitize(start.name)))
    elif metres is not None:
        parts.append(tr("{metres} m away", metres=f"{metres:.0f}"))
    return ", ".join(parts)


def line(choice: Favourite | str) -> str:
    """Return the line of an order to give again, or of a robot."""
    if isinstance(choice, Favourite):
        return f"{sanitize(choice.start.name)} -> {sanitize(choice.end.name)}  ({translate(choice.reason)})"
    return tr("{word}: the nearest idle robot", word=ANYONE) if choice == ANYONE else choice
