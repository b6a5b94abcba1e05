"""One reason why a robot stands still, and the strength of its evidence."""

from collections.abc import Callable
from enum import IntEnum
from functools import partial

from msgspec import Struct

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import Order, route_text
from fleet_tui.model.robot import Robot
from fleet_tui.situation.fact import Fact
from fleet_tui.text.language import EMPTY, Message

RECENT = 30.0
"""Seconds for which a failed command is a reason, and for which loading takes a moment."""

LOOK_AT = ("centre", "camera", "laser")
"""Ids of the keys that show what is around a robot; those that its kind has no use for are not offered."""


class Strength(IntEnum):
    """The strength of evidence; the smaller the stronger."""

    CERTAIN = 1
    LIKELY = 2
    POSSIBLE = 3
    NONE = 4
    """The cause is unknown."""


class Reason(Struct, frozen=True):
    """`name` is the reason, `evidence` the reports that show it. Monotonic seconds, None if unknown: `since`
    it holds, `seen` when it was last reported. `keys` are the ids of the keys that help; `remedy` is
    what a person can do on site, `page` the page of diagnostics that shows more."""

    name: Message
    evidence: Message
    strength: Strength = Strength.CERTAIN
    since: float | None = None
    seen: float | None = None
    keys: tuple[str, ...] = ()
    remedy: Message = EMPTY
    page: str = "topics"


def reason_of(fact: Fact, strength: Strength = Strength.CERTAIN, since: float | None = None) -> Reason:
    """Return a fact as the reason for standing still; `since`: without one the moment is not told."""
    kind = fact.kind
    name = fact.short or fact.text
    return Reason(name, fact.evidence, strength, since, fact.seen, kind.keys, fact.action, kind.page)


Rule = Callable[[FleetState, Robot], Reason | None]


def stationary_since(robot: Robot) -> float | None:
    """Return the time since which its pose is the same."""
    return robot.standing.at if robot.standing else None


def name_of(robot: Robot, vertex: str) -> str:
    """Return a vertex by its label or id; one missing from every graph of the robot is marked."""
    return robot.name_of(vertex) or f"{vertex}?"


def mission(robot: Robot, order: Order) -> Message:
    """Return an order by its id and its stops. An id that is not a number says nothing beside them."""
    number = (
        Message("order {id}, ", id=order.id)
        if order.id.isdigit() or not (order.stops or order.label)
        else Message("order ")
    )
    return Message(
        "{number}{label}",
        number=number,
        label=order.label or route_text(order.stops, partial(name_of, robot)),
    )
