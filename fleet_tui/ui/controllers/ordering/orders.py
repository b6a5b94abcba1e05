"""Orders of a robot: place, cancel, clear, again, the way back."""

import time
from collections.abc import Callable, Hashable, Iterator, Sequence
from functools import partial

from fleet_tui.commands.language.lookup import Place
from fleet_tui.commands.queue_moves import moves
from fleet_tui.commands.routes.charging import order_to_charger, way_to_charger
from fleet_tui.commands.subject import subject_of
from fleet_tui.model import kind
from fleet_tui.model.commands import CancelOrder, ClearOrders, PlaceOrder
from fleet_tui.model.navigation_events import OrderMoved
from fleet_tui.model.order import Order
from fleet_tui.model.problem import Right
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import CancelGoal
from fleet_tui.orders.local_queue import all_orders
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message, message_of
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.tables.marked import MarkedCommands
from fleet_tui.ui.controllers.typed import Entry
from fleet_tui.ui.view.tables.missions import mission, way
from fleet_tui.ui.view.tables.order_story import origin
from fleet_tui.ui.widgets.rows_pane import RowsPane


class OrderRequests:
    """From a key or a row of the queue to a request; `open_form` opens the order form for a robot."""

    def __init__(
        self,
        console: Console,
        *,
        queue: RowsPane,
        open_form: Callable[[str, Place | None, Sequence[Place]], None],
        marked: MarkedCommands,
    ) -> None:
        self._store = console.store
        self._dispatch = console.dispatch
        self._notices = console.notices
        self._navigation = console.navigation
        self._queue = queue
        self._open_form = open_form
        self._open_menu = console.open_menu
        self._clock = console.settings.clock
        self._marked = marked

    @property
    def _robot(self) -> Robot:
        return self._store.state.robots[self._navigation.robot]

    def start(self) -> None:
        """Open the order form for the selected robot."""
        if self.may_order():
            self._open_form(self._navigation.robot, None, ())

    def charge(self, robot: str) -> None:
        """Open the order form for a robot with the way to the nearest charger, if there is one."""
        self._navigation.select(robot)
        if self.may_order():
            self._open_form(robot, None, way_to_charger(self._store.state, self._robot))

    def charge_now(self) -> None:
        """Send the selected robot to the nearest charger, after asking."""
        if not self.may_order():
            return
        try:
            request = order_to_charger(self._store.state, self._robot)
        except CommandError as problem:
            self._notices.say(sanitize(message_of(problem)))
        else:
            self._dispatch.do(request, asks=True)

    def may_order(self) -> bool:
        """Tell whether the selected robot takes orders; show a notice if not."""
        robot = self._robot
        if refusal := self._dispatch.permissions.refusal(Right.DISPATCH):
            self._notices.say(refusal)
            return False
        if not robot.kind.can(kind.ORDER):
            self._notices.say(Message("{name}: {text}", name=robot.name, text=robot.kind.lack(kind.ORDER)))
        return robot.kind.can(kind.ORDER)

    def start_at(self, vertex: str, floor: str) -> None:
        """Open the order form for a vertex chosen on the map, if it is one of the robot's own graph."""
        if not self.may_order():
            return
        robot = self._robot
        robot_map = robot.maps.get(floor)
        name = robot_map.name_of(vertex) if robot_map else None
        if name is None:
            self._notices.say(
                Message(
                    "{name} has no vertex {vertex} on {floor}",
                    name=robot.name,
                    vertex=sanitize(vertex),
                    floor=floor,
                )
            )
        else:
            self._open_form(robot.name, Place(vertex, name, floor), ())

    def cancel(self) -> None:
        """Cancel the marked orders, else the one under the queue's cursor, without one the robot's goal
        beside it, after asking."""
        if marks := list(self._queue.listing.marks):
            self._marked.give([Request((CancelOrder(robot, id_),)) for robot, id_ in map(_order_of, marks)])
            return
        match self._queue.listing.cursor:
            case (str(robot), str(order_id), _):
                self.ask_cancel(robot, order_id)
            case _ if self._robot.kind.can(kind.GOAL_CANCEL):
                self._dispatch.do(Request((CancelGoal(self._robot.name),)))
            case _:
                asked = self._robot
                lacks = not asked.kind.can(kind.CANCEL)
                lack = Message("{name}: {text}", name=asked.name, text=asked.kind.lack(kind.CANCEL))
                self._notices.say(lack if lacks else Message("no order to cancel"))

    def ask_cancel(self, robot: str, order_id: str) -> None:
        """Cancel one order, after asking."""
        self._dispatch.do(Request((CancelOrder(robot, order_id),)))

    def clear(self) -> None:
        """Clear all orders of the selected robot, or of all marked ones, after asking."""
        self._marked.do(self._navigation.robot, ClearOrders)

    def menu(self, name: str, order_id: str) -> None:
        """List the actions for an order, below its origin."""
        state = self._store.state
        robot = state.robots[name]
        order = next((order for order in all_orders(state, robot) if order.id == order_id), None)
        if order is None:
            self._notices.say(
                Message("order {order_id} is no longer in the queue", order_id=sanitize(order_id))
            )
            return
        source = origin(state, name, order, self._clock)
        title = Message(
            "Order {order_id} of {name}: {mission}\n{source}",
            order_id=sanitize(order_id),
            name=name,
            mission=mission(robot, order),
            source=source,
        )
        self._open_menu(title, list(self._entries(robot, order)))

    def _entries(self, robot: Robot, order: Order) -> Iterator[Entry]:
        name, back = robot.name, order.stops[::-1]
        if self._dispatch.permissions.refusal(Right.DISPATCH):
            yield Message("Show {name} on the map", name=name), partial(self._navigation.find_robot, name)
            return
        if robot.kind.can(kind.CANCEL):
            yield Message("Cancel order"), partial(self.ask_cancel, name, order.id)
        for move, _ in moves(self._store.state, robot, order.id):
            yield move, partial(self._move, name, order.id, move)
        if order.stops and robot.kind.can(kind.ORDER):
            again = Request((PlaceOrder(name, order.stops),))
            yield Message("Repeat: {way}", way=way(robot, order.stops)), self._as_listed(again)
        if len(back) > 1 and kind.ORDER in robot.kind.accepts:
            returning = Request((PlaceOrder(name, back),))
            yield Message("Return trip: {way}", way=way(robot, back)), self._as_listed(returning)
        if robot.kind.can(kind.CLEAR):
            clearing = Request((ClearOrders(name),))
            yield Message("Clear all orders of {name}", name=name), partial(self._dispatch.do, clearing)

    def _as_listed(self, request: Request) -> Callable[[], None]:
        """Return an action that gives a request, unless its places are others by then."""
        listed = subject_of(self._store.state, request)

        def give() -> None:
            if problem := self._dispatch.withdrawn(request, listed):
                self._notices.say(problem)
            else:
                self._dispatch.do(request)

        return give

    def _move(self, name: str, order_id: str, move: Message) -> None:
        """Move an order in the queue of this console, as it is now: others may have left it meanwhile. The
        cursor goes with it."""
        state, robot = self._store.state, self._store.state.robots[name]
        before = dict(moves(state, robot, order_id)).get(move)
        if before is None:
            self._notices.say(
                Message(
                    "order {order_id} is already there, or no longer waits here", order_id=sanitize(order_id)
                )
            )
            return
        self._dispatch.post(OrderMoved(name, order_id, before, time.monotonic()))
        others = [order.id for order in all_orders(state, robot) if order.id != order_id]
        place = others.index(before) if before else len(others)
        self._queue.listing.cursor = (name, order_id, place)


def _order_of(mark: Hashable) -> tuple[str, str]:
    """Return the robot and the order of a marked row of the queue."""
    assert isinstance(mark, tuple)
    return str(mark[0]), str(mark[1])
