"""The commands of the main screen: from a key or a button to a Command."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from textual.screen import Screen

from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    Command,
    PauseRobot,
    ResumeRobot,
)
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.lookup import Place
from fleet_tui.screens.overlay import Overlay
from fleet_tui.store import Store
from fleet_tui.view.fleet_rows import mission
from fleet_tui.view.selection import Selection
from fleet_tui.view.text import visible
from fleet_tui.widgets.bindings import EAGER
from fleet_tui.widgets.rows_pane import RowsPane

if TYPE_CHECKING:
    from fleet_tui.screens.confirm import Confirm
    from fleet_tui.screens.menu import Menu
    from fleet_tui.screens.order_form import OrderForm
    from fleet_tui.screens.why import Why


class CommandActions(Screen[None], inherit_bindings=False):
    """What can be asked of robots from here. Destructive ones ask once; a pause never asks."""

    store: Store
    submit: Callable[[Command], None]
    tell: Callable[[Event], None]
    selection: Selection
    queue: RowsPane
    order_form: "OrderForm"
    confirm: "Confirm"
    menu: "Menu"
    why: "Why"

    @property
    def state(self) -> FleetState:
        """The newest picture of the fleet."""
        return self.store.state

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """What opens something does not reach through what is open already."""
        return action not in EAGER or not any(overlay.is_open for overlay in self.query(Overlay))

    def action_order(self) -> None:
        """Open the order form for the selected robot."""
        self.order_form.start(self.selection.robot)

    def order_at(self, vertex: int, floor: str) -> None:
        """Open the order form for a vertex chosen on the map, if it is one of the robot's own graph."""
        robot = self.state.robots[self.selection.robot]
        chart = robot.charts.get(floor)
        name = chart.name_of(vertex) if chart else None
        if name is None:
            self.say(f"{robot.name} knows no vertex {vertex} on {floor}")
        else:
            self.order_form.start(robot.name, Place(vertex, name, floor))

    def action_cancel(self) -> None:
        """Cancel the order under the queue's cursor, after asking."""
        key = self.queue.cursor
        if isinstance(key, tuple):
            self.ask_cancel(*key[:2])
        else:
            self.say("there is no order to cancel")

    def ask_cancel(self, robot_name: str, order_id: int) -> None:
        """Ask, with what will be lost."""
        robot = self.state.robots[robot_name]
        order = next((order for order in robot.orders.orders if order.id == order_id), None)
        if order is None:
            self.say(f"order {order_id} is gone already")
            return
        if order_id <= 0:
            self.say(f"order id {order_id} would mean all orders to the robot: use clear for that")
            return
        lines = [f"Cancel order {order_id} of {robot_name}?", mission(robot, order)]
        self.confirm.ask(lines, lambda: self.submit(CancelOrder(robot_name, order_id)))

    def action_clear(self) -> None:
        """Clear all orders of the selected robot, after asking."""
        robot = self.state.robots[self.selection.robot]
        orders = robot.orders.in_sequence()
        if not orders:
            self.say(f"{robot.name} has no orders")
            return
        lost = [f"  {order.id}  {mission(robot, order)}" for order in orders[:6]]
        more = [f"  and {len(orders) - 6} more"] if len(orders) > 6 else []
        lines = [f"Clear all {len(orders)} orders of {robot.name}?", *lost, *more]
        self.confirm.ask(lines, lambda: self.submit(ClearOrders(robot.name)))

    def action_pause(self) -> None:
        """Pause the selected robot, at once."""
        self.submit(PauseRobot(self.selection.robot))

    def action_resume(self) -> None:
        """Resume the selected robot, at once."""
        self.submit(ResumeRobot(self.selection.robot))

    def action_pause_all(self) -> None:
        """Pause every robot, at once."""
        for name in self.state.robots:
            self.submit(PauseRobot(name))

    def action_why(self) -> None:
        """Why the selected robot stands still."""
        self.why.show()

    def queue_menu(self, robot: str, order_id: int) -> None:
        """What can be done with an order."""
        self.menu.show(
            f"Order {order_id} of {robot}",
            [
                ("Cancel this order", lambda: self.ask_cancel(robot, order_id)),
                (f"Clear all orders of {robot}", lambda: self._for(robot, self.action_clear)),
            ],
        )

    def robot_menu(self, robot: str) -> None:
        """What can be done with a robot."""
        fault = self.state.robots[robot].last_fault
        self.menu.show(
            f"{robot}: {visible(fault)}" if fault else robot,
            [
                ("Order", lambda: self._for(robot, self.action_order)),
                ("Pause", lambda: self._for(robot, self.action_pause)),
                ("Resume", lambda: self._for(robot, self.action_resume)),
                ("Clear all orders", lambda: self._for(robot, self.action_clear)),
                ("Show on the map", lambda: self.find_robot(robot)),
                ("Why does it stand still?", lambda: self._for(robot, self.action_why)),
            ],
        )

    def _for(self, robot: str, action: Callable[[], None]) -> None:
        self.select(robot)
        action()

    def select(self, robot: str) -> None:
        """Select a robot."""
        raise NotImplementedError

    def find_robot(self, robot: str) -> None:
        """Select a robot and bring the map to it."""
        raise NotImplementedError

    def say(self, text: str) -> None:
        """Tell the operator why nothing happened."""
        raise NotImplementedError
