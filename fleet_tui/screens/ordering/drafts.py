"""The draft of an order in the form, as if Enter took the marked match."""

from fleet_tui.model.robot import Robot
from fleet_tui.rules.language.favourites import Favourite
from fleet_tui.rules.language.lookup import HERE, Place
from fleet_tui.rules.routes.order_draft import Draft
from fleet_tui.screens.ordering.choices import Choices
from fleet_tui.screens.ordering.fields import OrderFields


def draft_of(robot: Robot | None, fields: OrderFields, found: Choices, highlighted: int | None) -> Draft:
    """Return the draft of an order, without a robot that of any; `found` are the matches of the current
    field, one may be highlighted."""
    place = found[highlighted] if highlighted is not None and highlighted < len(found) else None
    if isinstance(place, Favourite):
        return Draft(robot.name if robot is not None else "", (place.start, place.end), marked=place.start)
    under_cursor = place if isinstance(place, Place) else None
    taken = {**fields.chosen, fields.current: under_cursor} if under_cursor else fields.chosen
    places = (taken.get("from"), *fields["to"].legs.places, taken.get("to"))
    name = robot.name if robot is not None else ""
    marked = under_cursor if under_cursor != HERE else None
    visited = tuple(one for one in places if one is not None and one != HERE)
    return Draft(name, visited, taken.get("from") == HERE, marked)
