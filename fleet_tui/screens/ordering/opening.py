"""The order form of a console, with the controllers behind it."""

from functools import partial
from typing import TYPE_CHECKING

from fleet_tui.controllers.dispatch import Ask
from fleet_tui.controllers.ordering.anyone import AnyoneOrders
from fleet_tui.controllers.ordering.past_orders import PastOrders
from fleet_tui.screens.ordering.form import OrderForm
from fleet_tui.screens.ordering.sending import Give
from fleet_tui.widgets.background import run_in_background

if TYPE_CHECKING:
    from fleet_tui.screens.main import MainScreen


def order_form(screen: "MainScreen", ask: Ask, give: Give) -> tuple[OrderForm, AnyoneOrders]:
    """Return the form, and the orders for anyone, which can be typed without it. `give` is for those of a
    robot."""
    store, dispatch = screen.store, screen.dispatch
    anyone = AnyoneOrders(store, dispatch, screen.notices, ask)
    past = PastOrders(store, lambda: screen.files.audit, partial(run_in_background, screen))
    return OrderForm(lambda: store.state, give, anyone.give, past, dispatch.objections), anyone
