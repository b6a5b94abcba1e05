"""Orders of a robot: placed, cancelled, given again, driven back."""

from fleet_tui.controllers.orders import OrderRequests
from fleet_tui.model.commands import CancelOrder, ClearOrders
from fleet_tui.model.kind import Kind
from fleet_tui.model.set_up.commands import CancelGoal
from fleet_tui.rules.language.lookup import Place
from fleet_tui.widgets.rows_pane import RowsPane
from tests.support.desk import Desk, ready
from tests.support.fleets import F0, R0, T0, fleet, of_kinds, place_order, queue, reduced
from tests.support.kinds import MUTE

Opened = list[tuple[str, Place | None]]


def requests(desk: Desk) -> tuple[RowsPane, Opened, OrderRequests]:
    queue, opened = RowsPane(id="queue"), Opened()
    return (
        queue,
        opened,
        OrderRequests(
            *(desk.store, desk.dispatch, desk.notices, desk.navigation, queue),
            lambda robot, place: opened.append((robot, place)),
            desk.open_menu,
            lambda _wall: "12:00",
        ),
    )


def test_the_form_opens_for_the_selected_robot_and_for_a_vertex_it_knows() -> None:
    desk = Desk(ready())
    _, opened, orders = requests(desk)
    orders.start()
    orders.start_at("2", F0)
    orders.start_at("77", F0)
    assert opened == [(R0, None), (R0, Place("2", "Store", F0))]
    assert desk.notices.text == f"{R0} has no vertex 77 on {F0}"


def test_a_robot_that_takes_no_orders_says_so() -> None:
    desk = Desk(of_kinds(fleet(), MUTE))
    _, opened, orders = requests(desk)
    orders.start()
    assert opened == [] and desk.notices.text == f"{R0}: this kind has no orders"
    orders.cancel()
    assert desk.notices.text == f"{R0}: this kind has no cancel"


def test_the_order_under_the_cursor_is_cancelled_after_asking() -> None:
    desk = Desk(ready())
    queue, _, orders = requests(desk)
    orders.cancel()
    assert desk.notices.text == "no order to cancel"
    queue.listing.cursor = (R0, "1", "order")
    orders.cancel()
    assert desk.backend.submitted == []
    desk.say_yes()
    assert desk.backend.submitted == [CancelOrder(R0, "1")]


def test_without_an_order_it_is_the_goal_beside_the_queue() -> None:
    state = reduced(ready(), queue(T0 + 1))
    desk = Desk(of_kinds(state, Kind("", ("queue",), ("goal cancel",))))
    _, _, orders = requests(desk)
    orders.cancel()
    assert desk.backend.submitted == []
    desk.say_yes()
    assert desk.backend.submitted == [CancelGoal(R0)]


def test_the_menu_of_an_order_gives_it_again_and_back() -> None:
    desk = Desk(ready())
    _, _, orders = requests(desk)
    orders.menu(R0, "1")
    (menu,) = desk.menus
    assert menu.title.startswith(f"Order 1 of {R0}: ")
    assert [text.partition(":")[0] for text in menu.texts] == [
        *("Cancel order", "Repeat", "Return trip", f"Clear all orders of {R0}"),
    ]
    menu.choose("Return trip")
    menu.choose("Clear")
    desk.say_yes()
    assert desk.backend.submitted == [place_order(R0, 2, 1), ClearOrders(R0)]


def test_an_order_that_is_gone_has_no_menu() -> None:
    desk = Desk(ready())
    _, _, orders = requests(desk)
    orders.menu(R0, "9")
    assert desk.menus == [] and desk.notices.text == "order 9 is no longer in the queue"
