"""The draft of an order in the form, as if Enter took the marked match."""

from fleet_tui.model.robot import Robot
from fleet_tui.rules.language.favourites import Favourite
from fleet_tui.rules.language.lookup import Place, may_skip_start
from fleet_tui.rules.routes.order_draft import Draft
from fleet_tui.screens.ordering.choices import Choices
from fleet_tui.screens.ordering.fields import OrderFields


def draft_of(robot: Robot | None, fields: OrderFields, found: Choices, marked: int | None) -> Draft:
    """Return the draft of an order, without a robot that of any; `found` are the matches of the current
    field, one may be marked."""
    place = found[marked] if marked is not None and marked < len(found) else None
    if isinstance(place, Favourite):
        return Draft(robot.name if robot is not None else "", (place.start, place.end), marked=place.start)
    under_cursor = place if isinstance(place, Place) else None
    taken = {**fields.chosen, fields.current: under_cursor} if under_cursor else fields.chosen
    has_start = fields["from"].display and not (may_skip_start(robot) and "from" not in taken)
    names = ("from", "to") if has_start else ("to",)
    start, end = (taken.get(name) if name in names else None for name in ("from", "to"))
    places = (start, *fields["to"].legs.places, end)
    name = robot.name if robot is not None else ""
    return Draft(name, tuple(one for one in places if one is not None), not has_start, under_cursor)
