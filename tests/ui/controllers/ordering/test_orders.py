"""Orders of a robot: placed, cancelled, given again, driven back."""

from fleet_tui.commands.language.lookup import Place
from fleet_tui.model.commands import CancelOrder, ClearOrders, Stage
from fleet_tui.model.events import CommandAdvanced
from fleet_tui.model.kind import Kind
from fleet_tui.model.navigation_events import OrderMoved
from fleet_tui.model.set_up.commands import CancelGoal
from fleet_tui.ui.controllers.ordering.orders import OrderRequests
from fleet_tui.ui.widgets.rows_pane import RowsPane
from tests.support.desk import Desk, ready
from tests.support.fleets import (
    F0,
    R0,
    T0,
    commanded,
    fleet,
    graph,
    labels,
    link_up,
    of_kinds,
    place_order,
    pose,
    queue,
    reduced,
    tick,
)
from tests.support.kinds import KEEPING, MUTE

Opened = list[tuple[str, Place | None]]


def requests(desk: Desk) -> tuple[RowsPane, Opened, OrderRequests]:
    queue, opened = RowsPane(id="queue"), Opened()
    return (
        queue,
        opened,
        OrderRequests(
            desk.console(),
            queue=queue,
            open_form=lambda robot, place, _way: opened.append((robot, place)),
            marked=desk.marked,
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
        *("Cancel order", "Repeat", "Return trip", f"Clear all orders of {R0}")
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


def waiting_here() -> Desk:
    """Three orders wait in this console: k1, k2, k3."""
    placed = [commanded(n, place_order(R0, 1, 2), Stage.WAITING, at=T0 + n) for n in (1, 2, 3)]
    known = (graph(1, 2), labels({1: "Base", 2: "Store"}), link_up(T0), pose(T0 + 4), tick(T0 + 4))
    return Desk(reduced(of_kinds(fleet(), KEEPING), *known, *(fact for facts in placed for fact in facts)))


def test_an_order_that_waits_here_is_moved_by_its_menu() -> None:
    desk = waiting_here()
    queue, _, orders = requests(desk)
    orders.menu(R0, "k3")
    assert desk.menus[0].texts[:3] == ["Cancel order", "Move up", "Move to the front"]
    desk.menus[0].choose("Move to the front")
    (event,) = desk.backend.events
    assert isinstance(event, OrderMoved) and (event.order_id, event.before) == ("k3", "k1")
    assert desk.backend.submitted == []
    assert queue.listing.cursor == (R0, "k3", 0), "the next key means the same order"


def test_a_move_means_the_queue_as_it_is_when_it_is_chosen() -> None:
    desk = waiting_here()
    _, _, orders = requests(desk)
    orders.menu(R0, "k3")
    desk.store.apply(CommandAdvanced(1, Stage.CANCELLED, T0 + 5))
    desk.menus[0].choose("Move up")
    (event,) = desk.backend.events
    assert isinstance(event, OrderMoved) and event.before == "k2"
    desk.store.apply(CommandAdvanced(2, Stage.CANCELLED, T0 + 6))
    desk.menus[0].choose("Move up")
    assert desk.notices.text == "order k3 is already there, or no longer waits here"
    assert len(desk.backend.events) == 1


def test_a_queue_of_the_robot_itself_offers_no_moves() -> None:
    state = reduced(ready(), queue(T0 + 1, (1, 1, 2, "W"), (2, 1, 2, "Q"), (3, 1, 2, "Q"), current=1))
    desk = Desk(state)
    _, _, orders = requests(desk)
    orders.menu(R0, "3")
    assert not any(text.startswith("Move") for text in desk.menus[0].texts)


def test_a_console_that_is_not_armed_moves_nothing() -> None:
    desk = waiting_here()
    desk.dispatch.arm()
    desk.backend.events.clear()
    _, _, orders = requests(desk)
    orders.menu(R0, "k1")
    desk.menus[0].choose("Move down")
    assert desk.backend.events == [] and "not armed" in desk.notices.text
