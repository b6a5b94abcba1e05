"""The choices of the order form's current field, below the fields, one of them marked."""

from collections.abc import Callable, Sequence

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.rules.language.anyone import is_anyone
from fleet_tui.rules.language.favourites import Favourite, Given
from fleet_tui.rules.language.lookup import HERE, Place
from fleet_tui.rules.routes.order_draft import Draft
from fleet_tui.screens.ordering.choices import Choice, Choices, choices, lines, no_match, scope
from fleet_tui.screens.ordering.fields import OrderFields
from fleet_tui.widgets.matches import Matches


class ChoiceList(Matches[Choice]):
    """Lists the choices of the field with the cursor, for a robot if it is known."""

    def __init__(
        self, state: Callable[[], FleetState], fields: OrderFields, given: Callable[[], Sequence[Given]]
    ) -> None:
        super().__init__(id="matches")
        self._state = state
        self._fields = fields
        self._given = given

    def list_for(self, robot: Robot | None, keep: bool = False) -> bool:
        """List the choices, the first one marked if something is typed; to `keep` the mark returns False if
        its choice is gone."""
        typed, fields = self._fields.typed, self._fields
        start = fields.chosen.get("from") if fields.current == "to" else None
        found = self._choices(robot)
        texts = lines(self._state(), robot, typed, found, start if start != HERE else None)
        if keep:
            return self.renew(found, texts)
        self.show(found, texts, mark=0 if typed else None)
        return True

    def scope(self, robot: Robot | None) -> str:
        """Return which places are listed before anything is typed."""
        return scope(robot, self._fields.typed, self.items)

    def unknown(self, robot: Robot | None) -> str:
        """Return that what is typed is no choice, empty if it is one."""
        typed = self._fields.typed
        return no_match(robot, self._fields.current, typed) if typed.strip() and not self.items else ""

    def _choices(self, robot: Robot | None) -> Choices:
        fields, field = self._fields, self._fields.current
        if field != "robot" and self._is_for_nobody(robot):
            return []
        return choices(
            self._state(), robot, field, fields[field].typed, fields.chosen.get(field), self._given
        )

    def draft(self, robot: Robot | None) -> Draft:
        """Return the draft of an order, without a robot that of any, as if Enter took the marked choice."""
        if self._is_for_nobody(robot):
            return Draft("")
        name, marked, fields = robot.name if robot is not None else "", self.marked, self._fields
        if isinstance(marked, Favourite):
            return Draft(name, (marked.start, marked.end), marked=marked.start)
        place = marked if isinstance(marked, Place) else None
        chosen = {**fields.chosen, fields.current: place} if place is not None else fields.chosen
        places = (chosen.get("from"), *fields["to"].legs.places, chosen.get("to"))
        visited = tuple(one for one in places if one is not None and one != HERE)
        return Draft(name, visited, chosen.get("from") == HERE, place if place != HERE else None)

    def _is_for_nobody(self, robot: Robot | None) -> bool:
        return robot is None and not is_anyone(self._fields["robot"].value, self._state())
