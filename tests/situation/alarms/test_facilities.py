"""Facilities out of service as alarms, in words, and closed lanes as edges."""

from typing import Any

from fleet_tui.model.events import GraphReceived
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.fleets.events import FacilityReported
from fleet_tui.model.fleets.facility import DOOR, LANES, LIFT, Facility
from fleet_tui.model.graph import Edge, RouteGraph, Vertex
from fleet_tui.situation.alarms.facilities import closed_edges, facility_text, listed
from fleet_tui.situation.why.members import lift
from tests.support.fleets import F0, R0, T0, reduced, tick
from tests.support.rmf import rmf_fleet


def with_one(before: FleetState, sort: str, name: str, at: float = T0, **more: Any) -> FleetState:
    return reduced(before, FacilityReported(R0, at, Facility(sort, name, at, **more)), tick(at))


def test_one_out_of_service_is_an_alarm_until_it_is_back() -> None:
    state = with_one(rmf_fleet(), LIFT, "a", state="fire mode, at L1", fault="fire mode")
    (alarm,) = [one for one in state.alarms if one.condition.kind == "facility"]
    assert (alarm.condition.source, alarm.text) == ("a", "lift fire mode")
    over = reduced(with_one(state, LIFT, "a", T0 + 1, state="at L1"), tick(T0 + 9))
    assert not any(one.holds and one.condition.kind == "facility" for one in over.alarms)


def test_those_out_of_service_are_listed_first_and_old_states_with_their_age() -> None:
    state = with_one(rmf_fleet(), LIFT, "a", state="at L1", user="tiny/t1")
    state = with_one(with_one(state, DOOR, "d", fault="offline", state="offline"), DOOR, "c")
    assert [one.name for one in listed(state)] == ["d", "a", "c"]
    assert facility_text(state, listed(state)[1]) == "lift a: at L1, used by tiny/t1"
    late = reduced(state, tick(T0 + 20))
    assert facility_text(late, listed(late)[0]) == "door d: offline, 20 s ago"
    still = with_one(late, LIFT, "a", T0 + 20, state="at L2")
    assert [facility_text(still, one)[-5:] for one in listed(still)] == ["s ago", "at L2", "s ago"]


def test_a_closed_lane_closes_its_edge_in_either_direction() -> None:
    ends = {"A": Vertex("A", 0, 0), "B": Vertex("B", 1, 0), "C": Vertex("C", 2, 0)}
    graph = RouteGraph(ends, (Edge("0", "A", "B", "1"), Edge("2", "B", "C")))
    state = reduced(rmf_fleet(), GraphReceived(R0, F0, graph))
    assert closed_edges(state, state.robots[R0], F0) == []
    for closed, edges in (("1", [(F0, "A", "B")]), ("2", [(F0, "B", "C")]), ("7", [])):
        told = Facility(LANES, R0, T0, closed=(closed,))
        known = reduced(state, FacilityReported(R0, T0, told))
        assert closed_edges(known, known.robots[R0], F0) == edges


def test_the_lift_that_a_robot_has_is_a_reason_while_it_is_reported() -> None:
    state = with_one(rmf_fleet(), LIFT, "a", state="at L1, doors closed", user=R0)
    found = lift(state, state.robots[R0])
    assert found is not None
    assert (found.name, found.evidence) == ("waits for lift a", "at L1, doors closed")
    late = reduced(state, tick(T0 + 20))
    assert lift(late, late.robots[R0]) is None
