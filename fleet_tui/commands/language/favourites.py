"""Orders to give again: the last one, and those given most often."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence

from msgspec import Struct

from fleet_tui.commands.language.lookup import Place
from fleet_tui.model.commands import PlaceOrder, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import vertices_of
from fleet_tui.text.language import Message

MOST = 3
"""Number of favourites that are offered."""
OFTEN = 2
"""Times from which an order counts as frequent."""


class Given(Struct, frozen=True):
    """An order that was given, from one vertex to another: their ids and labels, which are the ids for
    vertices without one."""

    start: str
    start_name: str
    end: str
    end_name: str


class Favourite(Struct, frozen=True):
    """An order to give again, and why it is offered: `last`, or how often it was given."""

    start: Place
    end: Place
    reason: Message


def given_here(state: FleetState) -> Iterator[Given]:
    """Return the orders that this console gave to any robot and that left it, newest first."""
    for record in reversed(state.commands):
        command = record.command
        robot = state.robots.get(command.robot)
        if not isinstance(command, PlaceOrder) or robot is None:
            continue
        vertices = vertices_of(command.stops)
        if len(vertices) == len(command.stops) == 2 and record.stage not in (Stage.NOT_SENT, Stage.REFUSED):
            start, end = vertices
            yield Given(start, robot.name_of(start) or start, end, robot.name_of(end) or end)


def favourites(places: Iterable[Place], given: Sequence[Given]) -> list[Favourite]:
    """Return the last and the most frequent of the orders given, newest first, as far as `places` still has
    both ends: by the label, and of several by the id."""
    known: dict[str, list[Place]] = {}
    for place in places:
        known.setdefault(place.name, []).append(place)
    routes = [ends for one in given if (ends := _ends(known, one)) is not None]
    counted = Counter(routes)
    # Equally frequent ones stay in their sequence, the newest first.
    often = (ends for ends, times in counted.most_common() if times >= OFTEN and ends != routes[0])
    found = [Favourite(*ends, Message("last")) for ends in routes[:1]]
    return [*found, *(Favourite(*ends, Message("{count} times", count=counted[ends])) for ends in often)][
        :MOST
    ]


def _ends(known: Mapping[str, Sequence[Place]], given: Given) -> tuple[Place, Place] | None:
    start, end = _place(known, given.start, given.start_name), _place(known, given.end, given.end_name)
    return (start, end) if start is not None and end is not None else None


def _place(known: Mapping[str, Sequence[Place]], vertex: str, name: str) -> Place | None:
    """Return the place of a label, of several the one with the id."""
    same = known.get(name, ())
    return next((one for one in same if one.vertex == vertex), same[0] if len(same) == 1 else None)
