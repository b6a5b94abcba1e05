"""Orders of a routine: the request of an instruction, and how the order ended."""

import pytest
from msgspec.structs import replace

from fleet_tui.features.routines.blocks import CarryBlock, GoBlock
from fleet_tui.features.routines.lane import OrderEnded
from fleet_tui.features.routines.rules.orders import earlier_outcome, order_of, outcome_of
from fleet_tui.model.commands import PlaceOrder, Stage
from fleet_tui.model.events import CargoReported, QueueReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import ORDER, ORDER_TO, Kind
from fleet_tui.model.order import at_vertices
from fleet_tui.model.request import Request
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message
from tests.support.fleets import R0, T0, commanded, order_queue, place_order, pose, queue, reduced, tick
from tests.support.routines import two_robots

CARRY = CarryBlock(1, "", "Base", "Packing area")


def vertices(state: FleetState, block: GoBlock | CarryBlock) -> tuple[str, ...]:
    request = order_of(state.robots[R0], block)
    assert request is not None and isinstance(request.commands[0], PlaceOrder)
    return tuple(stop.vertex for stop in request.commands[0].stops)


def go(place: str) -> GoBlock:
    return GoBlock(1, "", place)


def test_a_carry_names_both_places() -> None:
    request = order_of(two_robots().robots[R0], CARRY)
    assert request == Request((PlaceOrder(R0, at_vertices("1", "3")),), (("1", "floor_0"), ("3", "floor_0")))


def test_a_go_starts_at_the_vertex_nearest_to_the_robot_where_an_order_needs_a_start() -> None:
    state = reduced(two_robots(), pose(T0, 1.2))
    assert vertices(state, go("Packing area")) == ("2", "3")
    assert order_of(state.robots[R0], go("Consumidores")) is None, "it is there already"


def test_a_go_is_an_order_to_the_place_alone_where_that_is_possible() -> None:
    state = reduced(two_robots(), CargoReported(R0, T0, True))
    assert vertices(state, go("Packing area")) == ("3",)
    goals = Kind(accepts=(ORDER, ORDER_TO))
    robots = {R0: replace(two_robots().robots[R0], kind=goals)}
    assert vertices(replace(state, robots=robots), go("Base")) == ("1",)


def test_an_unknown_place_and_an_unknown_start_are_errors() -> None:
    state = two_robots()
    with pytest.raises(CommandError, match="robot_0 has no place 'Bas', did you mean Base"):
        order_of(state.robots[R0], go("Bas"))
    with pytest.raises(CommandError, match="robot_1 needs a start"):
        order_of(state.robots["robot_1"], go("Base"))


@pytest.mark.parametrize(
    ("stages", "outcome"),
    [
        ((), None),
        ((Stage.SENT,), None),
        ((Stage.SENT, Stage.UNKNOWN), None),
        ((Stage.NOT_SENT,), OrderEnded(False, Message("not sent: said"))),
        ((Stage.SENT, Stage.REFUSED), OrderEnded(False, Message("refused: said"))),
        (
            (Stage.SENT, Stage.ACCEPTED, Stage.NOT_CONFIRMED),
            OrderEnded(False, Message("not confirmed: said")),
        ),
        ((Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED, Stage.DONE), OrderEnded(True, Message("done: said"))),
        ((Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED, Stage.LOST), OrderEnded(False, Message("lost: said"))),
    ],
)
def test_only_what_was_seen_counts(stages: tuple[Stage, ...], outcome: OrderEnded | None) -> None:
    state = reduced(two_robots(), *commanded(1, place_order(R0, 1, 3), *stages, detail="said"))
    assert outcome_of(state.commands[-1]) == outcome


def test_an_order_in_the_queue_is_open() -> None:
    events = commanded(1, place_order(R0, 1, 3), Stage.SENT, Stage.ACCEPTED)
    state = reduced(two_robots(), *events, queue(T0 + 1, (1, 1, 3, "Q")), tick(T0 + 1))
    assert state.commands[-1].has_open_order and outcome_of(state.commands[-1]) is None


def test_an_order_of_an_earlier_run_is_followed_by_its_id() -> None:
    state = two_robots()
    assert earlier_outcome(state.robots["robot_1"], "1") is None, "no queue was received"
    missed = earlier_outcome(state.robots[R0], "1")
    assert missed == OrderEnded(False, Message("order 1 left the queue while no console followed it"))
    state = reduced(state, queue(T0 + 1, (1, 1, 3, "I"), current=1), pose(T0 + 1, 2.0))
    assert earlier_outcome(state.robots[R0], "1") is None
    state = reduced(state, QueueReported(R0, T0 + 2, order_queue(1, -1)))
    assert earlier_outcome(state.robots[R0], "1") == OrderEnded(True, Message("done: driven to the end"))
