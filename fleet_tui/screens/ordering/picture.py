"""The part of the state that the choices of an order depend on."""

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.rules.language.lookup import starts_here

Picture = tuple[tuple[object, ...], tuple[object, ...]]
"""Values, and the graphs and labels, each of which is replaced as a whole."""


def picture_of(state: FleetState, robot: Robot | None) -> Picture:
    """Return that of a robot, or of all for an order that any robot may drive."""
    robots = [robot] if robot is not None else list(state.robots.values())
    maps = tuple(
        part for one in robots for known in one.maps.values() for part in (known.graph, known.labels)
    )
    values = () if robot is None else (robot.name, robot.floor, starts_here(robot), robot.kind)
    return (*values, len(maps)), maps


def is_same(one: Picture, other: Picture) -> bool:
    """Tell whether two pictures have the same values and the very same maps."""
    return one[0] == other[0] and all(part is same for part, same in zip(one[1], other[1], strict=True))
