"""Operator requests: commands in sequence, and the part of one that a robot gets at a time."""

from collections.abc import Sequence
from itertools import pairwise

from msgspec import Struct

from fleet_tui.model.commands import Command, PauseRobot, PlaceOrder
from fleet_tui.model.kind import Kind
from fleet_tui.model.order import at_vertices
from fleet_tui.text.language import EMPTY, Message


class Request(Struct, frozen=True):
    """One request of an operator: commands in sequence. `floors`: each vertex chosen by name with its floor,
    since the wire has only ids, and floors may share ids. `alone`: only for robots without orders. `doubt`: a
    warning for its question."""

    commands: tuple[Command, ...]
    floors: tuple[tuple[str, str], ...] = ()
    alone: bool = False
    doubt: Message = EMPTY

    @property
    def only_pauses(self) -> bool:
        """Tell whether it asks robots to pause and nothing else: only rights and read-only hold it back."""
        return all(isinstance(command, PauseRobot) for command in self.commands)


def chain(
    robot: str, vertices: Sequence[str], with_cargo: bool = False, in_one: bool = False
) -> tuple[Command, ...]:
    """Return orders that visit the vertices in sequence: A, B, C is A -> B and B -> C. `with_cargo`: the
    cargo on board goes to the first one. `in_one`: such robots take one order with all stops."""
    if in_one:
        return (PlaceOrder(robot, at_vertices(*vertices)),)
    first = [PlaceOrder(robot, at_vertices(vertices[0]))] if with_cargo else []
    return (*first, *(PlaceOrder(robot, at_vertices(*ends)) for ends in pairwise(vertices)))


def given_now(command: Command, kind: Kind, leg: int = 0) -> Command:
    """Return the part of a command to send to a robot of this kind now."""
    if kind.gives_stops and isinstance(command, PlaceOrder):
        return PlaceOrder(command.robot, command.stops[leg : leg + 1])
    return command
