"""Wishes of operators: commands in sequence, and what of one a robot is given at a time."""

from collections.abc import Mapping, Sequence
from itertools import pairwise

from msgspec import Struct, field

from fleet_tui.model.commands import Command, PlaceOrder
from fleet_tui.model.kind import Kind
from fleet_tui.model.order import at_vertices


class Request(Struct, frozen=True):
    """One request of an operator: commands in sequence. `floors`: the floor of each vertex that
    was chosen by name, since the wire knows only ids, and floors may have the same ones."""

    commands: tuple[Command, ...]
    floors: Mapping[str, str] = field(default_factory=dict)


def chain(
    robot: str, vertices: Sequence[str], with_cargo: bool = False, in_one: bool = False
) -> tuple[Command, ...]:
    """Orders that visit the vertices one after the other: A, B, C is A -> B and B -> C. `with_cargo`:
    what is on board goes to the first one. `in_one`: such robots take one order with all stops."""
    if in_one:
        return (PlaceOrder(robot, at_vertices(*vertices)),)
    first = [PlaceOrder(robot, at_vertices(vertices[0]))] if with_cargo else []
    return (*first, *(PlaceOrder(robot, at_vertices(*ends)) for ends in pairwise(vertices)))


def given_now(command: Command, kind: Kind, leg: int = 0) -> Command:
    """Return what of a command a robot of this kind is to be given now."""
    if kind.gives_stops and isinstance(command, PlaceOrder):
        return PlaceOrder(command.robot, command.stops[leg : leg + 1])
    return command
