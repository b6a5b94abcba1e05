"""What did not change is told now and then, not each time."""

from typing import Any

from fleet_tui.model.events import Event
from fleet_tui.model.navigation_events import GoalsReported
from fleet_tui.model.vehicles.events import NodesReported
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import node, state

ORDER: dict[str, Any] = {"orderId": "o", "nodeStates": [node("a", 2, x=1.0), node("b", 4, x=2.0)]}


def told(found: tuple[Event, ...]) -> list[str]:
    return [type(one).__name__ for one in found if isinstance(one, NodesReported | GoalsReported)]


def test_an_order_is_told_when_it_changes_and_again_before_it_is_old() -> None:
    site = VehicleSite()
    assert told(site.read("state", state(**ORDER))) == ["NodesReported", "GoalsReported"]
    assert told(site.read("state", state(**ORDER))) == []
    assert site.agv.vehicle is not None and site.agv.vehicle.value.nodes_left == ("a", "b")
    site.now += 5.0
    assert told(site.read("state", state(**ORDER))) == ["GoalsReported"]
    assert told(site.read("state", state(orderId="o", nodeStates=[node("b", 4, x=2.0)]))) == [
        "NodesReported",
        "GoalsReported",
    ]


def test_a_replay_that_jumps_tells_all_of_it_again() -> None:
    site = VehicleSite()
    site.read("state", state(**ORDER))
    site.reader.recount()
    assert told(site.read("state", state(**ORDER))) == ["NodesReported", "GoalsReported"]


def test_a_wrong_node_is_named_each_time() -> None:
    site = VehicleSite()
    for _ in range(2):
        site.read("state", state(nodeStates=[{"nodeId": 1, "sequenceId": 0}]))
    assert site.agv.faults == 2


def test_numbers_that_go_back_once_are_a_restart_and_again_and_again_two_senders() -> None:
    site = VehicleSite()
    for number in (5, 6, 1, 2, 3):
        site.read("state", state(headerId=number))
    assert site.agv.faults == 0
    for number in (900, 4, 901, 5):
        site.read("state", state(headerId=number))
    assert site.agv.last_fault == (
        "state: headerId goes back again and again: two senders have this serial number"
    )
