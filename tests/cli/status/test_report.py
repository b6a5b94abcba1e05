"""The report of a fleet: what a program reads of it, and what needs attention."""

from fleet_tui.cli.status.report import report
from fleet_tui.model.events import ObstacleReported
from tests.support.fleets import (
    T0,
    told,
)
from tests.support.kinds import BARE, FULL, LATE, received


def test_json_has_no_key_for_what_a_kind_never_tells_and_null_for_what_has_not_come() -> None:
    state = told(received(BARE, LATE, FULL), ObstacleReported("robot_2", T0, 0.0))
    bare, late, full = report(state)["robots"]
    assert {"battery_percent", "cargo", "obstacle_s", "paused", "orders"}.isdisjoint(bare)
    assert (late["battery_percent"], late["orders"]) == (None, None) and "cargo" not in late
    assert (full["cargo"], full["obstacle_s"], full["paused"]) == (None, 0.0, None)
    assert (bare["never_came"], late["never_came"]) == ([], ["battery"])
    assert [one["kind"] for one in (bare, late)] == ["bare", "late"]
