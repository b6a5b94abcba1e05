"""The queue pane: the current order first, each with a Cancel that can be hit."""

import re

import pytest
from msgspec.structs import replace

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.model import events
from fleet_tui.model.commands import CancelOrder, ClearOrders, Stage
from fleet_tui.model.events import CommandAdvanced
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.fleets.events import MemberReported, TaskReported
from fleet_tui.model.geometry import Pose
from fleet_tui.model.kind import Kind
from fleet_tui.model.navigation import Goal
from fleet_tui.model.order import Order, OrderQueue, OrderState, Stop, at_vertices
from fleet_tui.robots.profile import Profile
from fleet_tui.text.sanitize import cells_of
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.queue import CANCEL, CLEAR, queue_table
from fleet_tui.ui.view.tables.queue import CANCEL as CANCEL_BUTTON
from fleet_tui.ui.view.tables.queue import CLEAR as CLEAR_BUTTON
from fleet_tui.ui.view.tables.table import Button, Run, width_of
from tests.support.fleets import (
    R0,
    T0,
    commanded,
    fleet,
    graph,
    labels,
    link_up,
    place_order,
    queue,
    reduced,
    text_of,
    tick,
)
from tests.support.kinds import BARE, FULL, LATE, received

WIDTHS = range(20, 121)
ORDERS = ((11, 1, 2, "Q"), (12, 2, 3, "W"), (15, 3, 99, "X"))


def state(robots: int = 1, current: int = 12) -> FleetState:
    known = (graph(1, 2, 3), labels({1: "Base", 2: "Consumidores"}))
    return reduced(fleet(robots), *known, queue(T0, *ORDERS, current=current), tick(T0))


def lines(fleet_now: FleetState, all_robots: bool = False, width: int = 100) -> list[str]:
    return [text_of(row.runs) for row in queue_table(fleet_now, R0, all_robots, width).rows]


def under(runs: tuple[Run, ...], button: Button) -> str:
    """The text in a button's cells."""
    cells = [letter for letter, width in cells_of(text_of(runs)) for letter in [letter, ""][:width]]
    return "".join(cells[button.start : button.end])


def test_the_current_order_comes_first() -> None:
    words = [line.split() for line in lines(state())]
    assert [word[0] for word in words] == ["#12", "#11", "#15"]
    assert [row.key for row in queue_table(state(), R0, False, 100).rows] == [
        (R0, "12", 0),
        (R0, "11", 1),
        (R0, "15", 2),
    ]


@pytest.mark.parametrize("current", [-1, 0, 99])
def test_a_current_order_that_is_not_there_means_none(current: int) -> None:
    assert [line.split()[0] for line in lines(state(current=current))] == ["#11", "#12", "#15"]


def test_missions_by_label_and_status_in_words() -> None:
    current, waiting, odd = lines(state())
    assert "Consumidores -> 3" in current and " in process" in current
    assert "Base -> Consumidores" in waiting and " queued" in waiting
    assert "3 -> 99?" in odd and " X, " in odd and "unknown vertex" in odd
    assert "unknown vertex" not in current + waiting


@pytest.mark.parametrize(("letter", "word"), [("D", "done"), ("C", "cancelled"), ("Z9", "Z9"), ("", "")])
def test_a_status_is_never_dropped(letter: str, word: str) -> None:
    (line,) = lines(reduced(fleet(), queue(T0, (1, 1, 2, letter))))
    assert word in line and "1 -> 2" in line.replace("?", "")


def test_an_order_is_written_by_its_stops_whatever_they_are() -> None:
    """Also without any, and with an id that no column is wide enough for."""
    stops = (at_vertices("1", "2", "3"), at_vertices("2"), (Stop(pose=Pose(1.24, -3.4)),), ())
    orders = tuple(Order(f"3f2a-77-{n}-000000", one, OrderState.PAUSED, "", n) for n, one in enumerate(stops))
    reported = events.QueueReported(R0, T0, OrderQueue(3, "3f2a-77-0-000000", orders))
    found = lines(reduced(state(), reported))
    for line, way in zip(
        found, ("Base -> Consumidores -> 3", "-> Consumidores", "-> (1.2, -3.4)", "to a point"), strict=True
    ):
        assert way in line and "-000000 " in line and "paused" in line and "unknown" not in line


def test_a_vertex_is_not_called_unknown_before_the_graphs_have_come() -> None:
    (line,) = lines(reduced(fleet(1, 2), graph(1), queue(T0, (1, 1, 99, "Q"))))
    assert "unknown vertex" not in line


@pytest.mark.parametrize("all_robots", [False, True])
def test_cancel_lies_where_it_stands_at_every_width(all_robots: bool) -> None:
    for width in WIDTHS:
        table = queue_table(state(2), R0, all_robots, width)
        for row in table.rows:
            (button,) = row.buttons
            assert button.name == "cancel"
            assert under(row.runs, button) == CANCEL
            assert button.end <= width and width_of(row.runs) <= width


def test_a_state_is_whole_or_not_there_beside_its_button() -> None:
    for width in WIDTHS:
        for line in lines(state(), width=width):
            told = line.removesuffix(CANCEL).rstrip()
            assert not re.search(r", ?(no?|qu?e?u?e?)…$|,$", told), (width, line)


def test_clear_all_lies_where_it_stands_or_is_not_there() -> None:
    seen = set()
    for width in WIDTHS:
        table = queue_table(state(), R0, False, width)
        for button in table.title_buttons:
            assert under(table.title, button) == CLEAR and button.name == "clear"
            assert button.end <= width
        assert (CLEAR in text_of(table.title)) is bool(table.title_buttons)
        seen.add(bool(table.title_buttons))
    assert seen == {True, False}
    assert queue_table(fleet(), R0, False, 100).title_buttons == ()


def test_the_queue_of_all_robots_names_each() -> None:
    both = reduced(state(2), queue(T0, (11, 1, 2, "W"), current=11, robot="robot_1"))
    table = queue_table(both, R0, True, 100)
    assert [row.key for row in table.rows] == [
        (R0, "12", 0),
        (R0, "11", 1),
        (R0, "15", 2),
        ("robot_1", "11", 0),
    ]
    assert text_of(table.rows[3].runs).startswith("robot_1")
    assert text_of(table.title) == "Queue all robots 4 orders"
    assert table.title_buttons == ()


def test_the_title_counts_and_tells_cargo_and_age() -> None:
    loaded = reduced(state(), events.CargoReported(R0, T0, True), tick(T0 + 30))
    assert text_of(queue_table(loaded, R0, False, 100).title).startswith(
        "Queue robot_0 3 orders cargo on board 30 s old"
    )
    one = reduced(fleet(), queue(T0, (1, 1, 2, "Q")))
    assert "1 order " in text_of(queue_table(one, R0, False, 100).title)


def test_nothing_to_do_is_not_nothing_heard() -> None:
    assert queue_table(fleet(), R0, False, 80).empty == "no queue received yet"
    assert queue_table(reduced(fleet(), queue(T0)), R0, False, 80).empty == "no orders: press o to order"


def test_an_order_to_nowhere_is_marked_by_role_too() -> None:
    odd = queue_table(state(), R0, False, 100).rows[2]
    assert {role for text, role in odd.runs if "99?" in text} == {StyleRole.WARN}


def test_what_is_under_way_stands_at_its_order_or_in_the_title() -> None:
    cancel = commanded(1, CancelOrder(R0, "11"), Stage.SENT)
    place = commanded(2, place_order(R0, 1, 2), Stage.SENT, Stage.ACCEPTED)
    now = reduced(state(), *cancel, *place, tick(T0 + 1))
    current, waiting, odd = lines(now)
    assert "cancel sent 1 s ago" in waiting and "cancel" not in (current + odd).replace(CANCEL, "")
    assert "+1 not in the queue yet" in text_of(queue_table(now, R0, False, 100).title)
    shown = reduced(
        state(), *commanded(2, place_order(R0, 1, 2), Stage.SENT), queue(T0 + 1, (900, 1, 2, "Q"))
    )
    assert "not seen" not in text_of(queue_table(shown, R0, False, 100).title)  # only its answer lacks
    clear = reduced(state(), *commanded(3, ClearOrders(R0), Stage.SENT), tick(T0 + 1))
    assert all("cancel sent 1 s ago" in line for line in lines(clear))
    ended = reduced(now, *(CommandAdvanced(id_, Stage.REFUSED, T0 + 1) for id_ in (1, 2)))
    assert "cancel" not in "".join(lines(ended)).replace(CANCEL, "")


@pytest.mark.parametrize("letter", ["D", "C"])
def test_an_order_that_is_over_has_nothing_to_cancel(letter: str) -> None:
    state = reduced(fleet(), queue(T0, (1, 1, 2, letter), (2, 1, 2, "Q")))
    over, waiting = queue_table(state, R0, False, 60).rows
    assert CANCEL not in text_of(over.runs) and not over.buttons
    assert CANCEL in text_of(waiting.runs) and waiting.buttons


def test_the_queue_pane_of_a_kind_without_a_queue() -> None:
    table = queue_table(received(BARE), R0, False, 80)
    assert (text_of(table.title), table.empty) == ("Queue robot_0", "this kind has no queue")
    assert queue_table(received(LATE), R0, False, 80).empty == "no orders reported yet"
    assert queue_table(received(FULL), R0, False, 80).empty == "no queue received yet"


@pytest.mark.parametrize(("kind", "cancels", "clears"), [(FULL, True, True), (LATE, True, False)])
def test_only_what_is_accepted_has_a_button(kind: Kind, cancels: bool, clears: bool) -> None:
    table = queue_table(reduced(received(kind), queue(T0, (1, 1, 2, "Q"))), R0, False, 80)
    assert (CLEAR_BUTTON in text_of(table.title)) is clears
    assert (CANCEL_BUTTON in text_of(table.rows[0].runs)) is cancels


@pytest.mark.parametrize(("width", "cargo"), [(38, " ▪ "), (47, " cargo "), (60, " cargo on board ")])
def test_clear_all_stays_when_cargo_is_on_board(width: int, cargo: str) -> None:
    table = queue_table(reduced(state(), events.CargoReported(R0, T0, True)), R0, False, width)
    assert cargo in text_of(table.title) and text_of(table.title).endswith(CLEAR)
    assert [button.name for button in table.title_buttons] == ["clear"]


def test_who_may_not_command_has_no_buttons_and_no_hint_to_order() -> None:
    state = reduced(fleet(), queue(T0, (1, 2, 3, "Q")))
    assert queue_table(state, R0, False, 80).title_buttons
    table = queue_table(state, R0, False, 80, may=False)
    assert not table.title_buttons and not table.rows[0].buttons
    assert queue_table(reduced(fleet(), queue(T0)), R0, False, 80, may=False).empty == "no orders"


@pytest.mark.parametrize("width", [36, 44, 54, 76])
def test_since_when_a_queue_is_known_stays_beside_a_long_name(width: int) -> None:
    name = "transport_of_the_north_wing/robot_12"
    config = Config(profile=Profile(kind="rmf"), floors=[FloorEntry("floor_0")], robots=[RobotEntry(name)])
    place = MemberReported(name, T0, Pose(1.0, 2.0), "floor_0", 7.0, 80.0, "idle", "")
    task = TaskReported(name, T0, Goal("a", "a", "task", OrderState.QUEUED))
    again = replace(place, at=T0 + 0.1)  # with a second message the age of the first one is known
    known = reduced(initial_state(config, T0), link_up(T0), place, task, again, tick(T0 + 0.1))
    for may in (True, False):
        table = queue_table(known, name, False, width, may=may, clock=lambda wall: "14:02:33")
        title = text_of(table.title)
        assert " since 14:02" in title and title.startswith("Queue tra"), title
        assert width_of(table.title) <= width


def test_a_broad_pane_tells_place_age_and_what_is_left() -> None:
    driven = reduced(state(2), tick(T0 + 65))
    table = queue_table(driven, R0, False, 90)
    head, current, waiting, _ = text_of(table.head), *(text_of(row.runs) for row in table.rows)
    assert head.split() == ["Pos", "Order", "Left", "Age"]
    assert current.split()[:2] == ["#12", "1"] and waiting.split()[:2] == ["#11", "2"]
    assert current.index("Consumidores") == head.index("Order")
    assert not queue_table(driven, R0, False, 50).head and "Pos" not in text_of(
        queue_table(driven, R0, False, 50).head
    )


def test_the_age_of_an_order_is_exact_only_where_it_is_known() -> None:
    """One that was there before this console may have waited for longer."""
    listed = reduced(fleet(), queue(T0, (1, 1, 2, "Q")), tick(T0 + 91))
    (row,) = queue_table(listed, R0, False, 90).rows
    assert " > 91 s " in text_of(row.runs)
    (order,) = listed.robots[R0].orders.orders
    taken = OrderQueue(1, "", (replace(order, taken_at=T0 - 100),))
    (row,) = queue_table(reduced(listed, events.QueueReported(R0, T0 + 91, taken)), R0, False, 90).rows
    assert " 3 min " in text_of(row.runs) and ">" not in text_of(row.runs).replace("->", "")
