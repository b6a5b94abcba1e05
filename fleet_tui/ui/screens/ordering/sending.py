"""From the fields of the order form to a request: the robot's own, or one for the nearest idle robot."""

from collections.abc import Callable, Sequence

from fleet_tui.commands.language.any_robot import is_anyone
from fleet_tui.commands.language.lookup import Place, order_of
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.text.language import Message
from fleet_tui.ui.screens.ordering.choices import missing
from fleet_tui.ui.screens.ordering.fields import OrderFields

Give = Callable[[Request, Callable[[], None]], Message]
"""Sends a request, and calls back when it was sent. Returns its problem."""
GiveAnyone = Callable[[Sequence[Place], Callable[[], None]], Message]
"""Does so with the places of an order without a robot."""


class OrderSending:
    """Gives the order of the fields, if it is complete."""

    def __init__(
        self, state: Callable[[], FleetState], fields: OrderFields, give: Give, give_anyone: GiveAnyone
    ) -> None:
        self._state = state
        self._fields = fields
        self._give = give
        self._give_anyone = give_anyone

    def finish(self, robot: Robot | None, sent: Callable[[], None]) -> tuple[Message, str]:
        """Give a complete order, to any robot if the field for it is empty. Returns the problem, empty for
        none, and the field to correct."""
        if robot is not None:
            return self._for(robot, sent)
        if not is_anyone(typed := self._fields["robot"].value.strip(), self._state()):
            return Message("Robot: no match for {typed}", typed=f"{typed!r}"), "robot"
        return self._without(("from", "to")) or (self._give_anyone(self._fields.visited, sent), "to")

    def _for(self, robot: Robot, sent: Callable[[], None]) -> tuple[Message, str]:
        self._fields.choose_for(robot.name)
        if problem := self._without(("from", "to")):
            return problem
        return self._give(order_of(robot, self._fields.visited), sent), "to"

    def _without(self, names: Sequence[str]) -> tuple[Message, str] | None:
        """Return the first field that lacks a place, None without one."""
        field = self._fields.missing(names)
        return (missing(field, self._fields[field].typed), field) if field else None
