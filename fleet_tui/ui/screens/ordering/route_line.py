"""The length of the way of the order that is being typed, in the form."""

from fleet_tui.commands.routes.order_draft import Drafted, draft_route, pace_of
from fleet_tui.model.fleet import FleetState
from fleet_tui.ui.screens.ordering.form import OrderForm
from fleet_tui.ui.view.lines.impact import draft_text


def show_route(form: OrderForm, state: FleetState) -> Drafted | None:
    """Return the order that is being typed and its way, None without a place, and show its length."""
    draft = form.draft()
    robot = None if draft is None else state.robots[draft.robot]
    route = None if draft is None or robot is None else draft_route(robot, draft, pace_of(state, robot))
    text = "" if robot is None or route is None else draft_text(state, robot, route)
    if text != form.route.content:  # an update lays out the whole screen
        form.route.update(text)
    return None if draft is None or not (draft.places or draft.marked) else (draft, route)
