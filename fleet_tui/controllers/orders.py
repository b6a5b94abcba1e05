"""Orders of a robot: place, cancel, clear, again, the way back."""

from collections.abc import Callable
from functools import partial

from fleet_tui.controllers.dispatch import Dispatch
from fleet_tui.controllers.navigation import Navigation
from fleet_tui.controllers.notices import Notices
from fleet_tui.controllers.typed import Entry, OpenMenu
from fleet_tui.model import kind
from fleet_tui.model.commands import CancelOrder, ClearOrders, PlaceOrder
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import CancelGoal
from fleet_tui.rules.language.lookup import Place
from fleet_tui.state.store import Store
from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.tables.fleet import mission, way
from fleet_tui.view.tables.order_story import origin
from fleet_tui.widgets.rows_pane import RowsPane


class OrderRequests:
    """From a key or a row of the queue to a request; `open_form` opens the order form for a robot."""

    def __init__(
        self,
        store: Store,
        dispatch: Dispatch,
        notices: Notices,
        navigation: Navigation,
        queue: RowsPane,
        open_form: Callable[[str, Place | None], None],
        open_menu: OpenMenu,
        clock: Callable[[float], str],
    ) -> None:
        self._store, self._dispatch, self._notices, self._navigation = store, dispatch, notices, navigation
        self._queue, self._open_form, self._open_menu, self._clock = queue, open_form, open_menu, clock

    @property
    def _robot(self) -> Robot:
        return self._store.state.robots[self._navigation.robot]

    def start(self) -> None:
        """Open the order form for the selected robot."""
        if self.may_order():
            self._open_form(self._navigation.robot, None)

    def may_order(self) -> bool:
        """Tell whether the selected robot takes orders; show a notice if not."""
        robot = self._robot
        if not robot.kind.can(kind.ORDER):
            self._notices.say(f"{robot.name}: {robot.kind.lack(kind.ORDER)}")
        return robot.kind.can(kind.ORDER)

    def start_at(self, vertex: str, floor: str) -> None:
        """Open the order form for a vertex chosen on the map, if it is one of the robot's own graph."""
        if not self.may_order():
            return
        robot = self._robot
        robot_map = robot.maps.get(floor)
        name = robot_map.name_of(vertex) if robot_map else None
        if name is None:
            self._notices.say(f"{robot.name} has no vertex {sanitize(vertex)} on {floor}")
        else:
            self._open_form(robot.name, Place(vertex, name, floor))

    def cancel(self) -> None:
        """Cancel the order under the queue's cursor, without one the robot's goal beside it, after asking."""
        match self._queue.listing.cursor:
            case (str(robot), str(order_id), _):
                self.ask_cancel(robot, order_id)
            case _ if self._robot.kind.can(kind.GOAL_CANCEL):
                self._dispatch.do(Request((CancelGoal(self._robot.name),)))
            case _:
                asked = self._robot
                lacks = not asked.kind.can(kind.CANCEL)
                lack = f"{asked.name}: {asked.kind.lack(kind.CANCEL)}"
                self._notices.say(lack if lacks else "no order to cancel")

    def ask_cancel(self, robot: str, order_id: str) -> None:
        """Cancel one order, after asking."""
        self._dispatch.do(Request((CancelOrder(robot, order_id),)))

    def clear(self) -> None:
        """Clear all orders of the selected robot, after asking."""
        self._dispatch.do(Request((ClearOrders(self._navigation.robot),)))

    def menu(self, name: str, order_id: str) -> None:
        """List the actions for an order, below its origin."""
        robot = self._store.state.robots[name]
        order = next((order for order in robot.orders.orders if order.id == order_id), None)
        if order is None:
            self._notices.say(f"order {sanitize(order_id)} is no longer in the queue")
            return
        back = order.stops[::-1]
        entries: list[Entry] = []
        if robot.kind.can(kind.CANCEL):
            entries.append(("Cancel order", partial(self.ask_cancel, name, order_id)))
        if order.stops and robot.kind.can(kind.ORDER):
            again = Request((PlaceOrder(name, order.stops),))
            entries.append((f"Repeat: {way(robot, order.stops)}", partial(self._dispatch.do, again)))
        if len(back) > 1 and kind.ORDER in robot.kind.accepts:
            returning = Request((PlaceOrder(name, back),))
            entries.append((f"Return trip: {way(robot, back)}", partial(self._dispatch.do, returning)))
        if robot.kind.can(kind.CLEAR):
            clearing = Request((ClearOrders(name),))
            entries.append((f"Clear all orders of {name}", partial(self._dispatch.do, clearing)))
        source = origin(self._store.state, name, order, self._clock)
        self._open_menu(f"Order {sanitize(order_id)} of {name}: {mission(robot, order)}\n{source}", entries)
