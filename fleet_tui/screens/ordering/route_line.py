"""The length of the way of the order that is being typed, in the form."""

from fleet_tui.model.fleet import FleetState
from fleet_tui.rules.routes.order_draft import Drafted, draft_route
from fleet_tui.screens.ordering.form import OrderForm


def show_route(form: OrderForm, state: FleetState) -> Drafted | None:
    """Return the order that is being typed and its way, None without a place, and show its length."""
    draft = form.draft()
    route = None if draft is None else draft_route(state.robots[draft.robot], draft)
    text = "" if route is None else route.text
    if text != form.route.content:  # an update lays out the whole screen
        form.route.update(text)
    return None if draft is None or not (draft.places or draft.marked) else (draft, route)
