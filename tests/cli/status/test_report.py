"""The report of a fleet: what a program reads of it, and what needs attention."""

from fleet_tui.cli.status.report import changes, report
from fleet_tui.model.events import ObstacleReported
from fleet_tui.model.fleets.events import FacilityReported
from fleet_tui.model.fleets.facility import LANES, LIFT, Facility
from fleet_tui.text.language import Message
from tests.support.fleets import R0, T0, reduced, tick
from tests.support.kinds import BARE, FULL, LATE, received
from tests.support.rmf import rmf_fleet


def test_json_has_no_key_for_what_a_kind_never_tells_and_null_for_what_has_not_come() -> None:
    state = reduced(received(BARE, LATE, FULL), ObstacleReported("robot_2", T0, 0.0))
    bare, late, full = report(state)["robots"]
    assert {"battery_percent", "cargo", "obstacle_s", "paused", "orders"}.isdisjoint(bare)
    assert (late["battery_percent"], late["orders"]) == (None, None) and "cargo" not in late
    assert (full["cargo"], full["obstacle_s"], full["paused"]) == (None, 0.0, None)
    assert (bare["never_came"], late["never_came"]) == ([], ["battery"])
    assert [one["kind"] for one in (bare, late)] == ["bare", "late"]


def test_facilities_have_their_age_which_alone_is_no_change() -> None:
    lift = Facility(LIFT, "a", T0, Message("at L1"), user=R0)
    told = [lift, Facility(LANES, "tiny", T0, closed=("2", "5"))]
    before = reduced(rmf_fleet(), *(FacilityReported(R0, T0, one) for one in told), tick(T0 + 1))
    after = reduced(before, tick(T0 + 20))
    (link,) = report(after)["links"]
    assert link["facilities"] == [
        {"sort": "lift", "name": "a", "state": "at L1", "fault": None, "user": R0, "age_s": 20.0},
        {"sort": "lanes", "name": "tiny", "state": None, "fault": None, "user": None}
        | {"closed": ["2", "5"], "age_s": 20.0},
    ]
    assert "links" not in changes(report(before), report(after)).get("changed", {})
    moved = reduced(after, FacilityReported(R0, T0 + 20, Facility(LIFT, "a", T0 + 20, Message("at L2"))))
    assert "links" in changes(report(after), report(moved))["changed"]
