"""What can be done with orders: place, cancel, clear, again, the way back."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from fleet_tui.model import kind
from fleet_tui.model.commands import CancelOrder, ClearOrders, PlaceOrder
from fleet_tui.model.request import Request
from fleet_tui.rules.language.lookup import Place
from fleet_tui.screens.dispatch import Dispatch
from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.selection import Selection
from fleet_tui.view.tables.fleet import mission, way
from fleet_tui.widgets.rows_pane import RowsPane

if TYPE_CHECKING:
    from fleet_tui.screens.menu import Entry, Menu
    from fleet_tui.screens.order_form import OrderForm


class OrderActions(Dispatch):
    """From a key or a row to a wish."""

    selection: Selection
    queue: RowsPane
    clock: Callable[[float], str]
    order_form: "OrderForm"
    menu: "Menu"

    def action_order(self) -> None:
        """Open the order form for the selected robot."""
        if self.may_order():
            self.order_form.start(self.selection.robot)

    def may_order(self) -> bool:
        """Tell whether the selected robot takes orders; say so where it does not."""
        robot = self.state.robots[self.selection.robot]
        if not robot.kind.can(kind.ORDER):
            self.say(f"{robot.name}: {robot.kind.lack(kind.ORDER)}")
        return robot.kind.can(kind.ORDER)

    def order_at(self, vertex: str, floor: str) -> None:
        """Open the order form for a vertex chosen on the map, if it is one of the robot's own graph."""
        if not self.may_order():
            return
        robot = self.state.robots[self.selection.robot]
        chart = robot.charts.get(floor)
        name = chart.name_of(vertex) if chart else None
        if name is None:
            self.say(f"{robot.name} knows no vertex {sanitize(vertex)} on {floor}")
        else:
            self.order_form.start(robot.name, Place(vertex, name, floor))

    def action_cancel(self) -> None:
        """Cancel the order under the queue's cursor, after asking."""
        match self.queue.cursor:
            case (str(robot), str(order_id), _):
                self.ask_cancel(robot, order_id)
            case _:
                asked = self.state.robots[self.selection.robot]
                lacks = not asked.kind.can(kind.CANCEL)
                lack = f"{asked.name}: {asked.kind.lack(kind.CANCEL)}"
                self.say(lack if lacks else "there is no order to cancel")

    def ask_cancel(self, robot: str, order_id: str) -> None:
        """Cancel one order, after asking."""
        self.do(Request((CancelOrder(robot, order_id),)))

    def action_clear(self) -> None:
        """Clear all orders of the selected robot, after asking."""
        self.do(Request((ClearOrders(self.selection.robot),)))

    def queue_menu(self, name: str, order_id: str) -> None:
        """Where an order comes from, and what can be done with it."""
        robot = self.state.robots[name]
        order = next((order for order in robot.orders.orders if order.id == order_id), None)
        if order is None:
            self.say(f"order {sanitize(order_id)} is gone already")
            return
        back = order.stops[::-1]
        entries: list[Entry] = []
        if robot.kind.can(kind.CANCEL):
            entries.append(("Cancel this order", lambda: self.ask_cancel(name, order_id)))
        if order.stops and robot.kind.can(kind.ORDER):
            again = Request((PlaceOrder(name, order.stops),))
            entries.append((f"Again: {way(robot, order.stops)}", lambda: self.do(again)))
        if len(back) > 1 and kind.ORDER in robot.kind.accepts:
            returning = Request((PlaceOrder(name, back),))
            entries.append((f"Return trip: {way(robot, back)}", lambda: self.do(returning)))
        if robot.kind.can(kind.CLEAR):
            entries.append((f"Clear all orders of {name}", lambda: self.do(Request((ClearOrders(name),)))))
        from fleet_tui.view.tables.order_story import origin  # the first paint does without it

        told = origin(self.state, name, order, self.clock)
        self.menu.show(f"Order {sanitize(order_id)} of {name}: {mission(robot, order)}\n{told}", entries)
