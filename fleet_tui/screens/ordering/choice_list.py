"""The choices of the order form's current field, below the fields, one of them marked."""

from collections.abc import Callable, Sequence

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.rules.language.anyone import is_anyone
from fleet_tui.rules.language.favourites import Given
from fleet_tui.rules.language.lookup import HERE
from fleet_tui.rules.routes.order_draft import Draft
from fleet_tui.screens.ordering.choices import Choice, Choices, choices, lines, no_match, scope
from fleet_tui.screens.ordering.drafts import draft_of
from fleet_tui.screens.ordering.fields import OrderFields
from fleet_tui.widgets.matches import Matches


class ChoiceList(Matches):
    """Lists the choices of the field with the cursor, for a robot if it is known."""

    def __init__(
        self, state: Callable[[], FleetState], fields: OrderFields, given: Callable[[], Sequence[Given]]
    ) -> None:
        super().__init__(id="matches")
        self._state, self._fields, self._given = state, fields, given
        self._found: Choices = []
        self.scope = ""

    def refill(self, robot: Robot | None) -> None:
        """List the choices, the first one marked if something is typed."""
        self._show(robot, self._choices(robot))
        self.highlighted = 0 if self._fields.typed and self._found else None

    def renew(self, robot: Robot | None) -> bool:
        """List the choices anew, the same one marked; without it none. Returns False if it is gone."""
        marked = self.at(self.highlighted) if self.highlighted is not None else None
        self._show(robot, self._choices(robot))
        is_there = marked is not None and marked in self._found
        self.highlighted = self._found.index(marked) if is_there and marked is not None else None
        return marked is None or is_there

    def _show(self, robot: Robot | None, found: Choices) -> None:
        typed, fields = self._fields.typed, self._fields
        start = fields.chosen.get("from") if fields.current == "to" else None
        self._found = found
        self.show(lines(self._state(), robot, typed, found, start if start != HERE else None), mark=False)
        self.scope = scope(robot, typed, found)

    def unknown(self, robot: Robot | None) -> str:
        """Return that what is typed is no choice, empty if it is one."""
        typed = self._fields.typed
        return no_match(robot, self._fields.current, typed) if typed.strip() and not self._found else ""

    def _choices(self, robot: Robot | None) -> Choices:
        fields, field = self._fields, self._fields.current
        if field != "robot" and self._is_for_nobody(robot):
            return []
        return choices(
            self._state(), robot, field, fields[field].typed, fields.chosen.get(field), self._given
        )

    def at(self, index: int) -> Choice | None:
        """Return the choice of a line, None beyond the last one."""
        return self._found[index] if index < len(self._found) else None

    def choice(self) -> Choice | None:
        """Return the choice for Enter, None if none is marked."""
        return self.at(self.highlighted) if self.highlighted is not None else None

    def draft(self, robot: Robot | None) -> Draft:
        """Return the draft of an order, as if Enter took the marked choice."""
        draft = draft_of(robot, self._fields, self._found, self.highlighted)
        return Draft("") if self._is_for_nobody(robot) else draft

    def _is_for_nobody(self, robot: Robot | None) -> bool:
        return robot is None and not is_anyone(self._fields["robot"].value, self._state())
