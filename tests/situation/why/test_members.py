"""Reasons of robots of fleets."""

from fleet_tui.model.fleets.events import MemberReported, StatusReported
from fleet_tui.model.geometry import Pose
from fleet_tui.model.order import OrderState
from fleet_tui.situation.why.members import emergency, failed_mode, issues
from tests.support.fleets import F0, R0, T0, reduced, tick
from tests.support.rmf import ON, reported, rmf_fleet


def test_mode_and_issues_are_reasons_and_a_usual_mode_is_none() -> None:
    here = MemberReported(R0, T0, Pose(0.0, 0.0), F0, 1.0, 80.0, "emergency", "")
    state = reduced(rmf_fleet(), here, StatusReported(R0, T0, "idle", "", ("lift: stuck",)), tick(T0))
    found = [rule(state, state.robots[R0]) for rule in (failed_mode, issues)]
    assert [one and one.name for one in found] == ["emergency", "lift: stuck"]
    usual = reduced(rmf_fleet(), MemberReported(R0, T0, Pose(0.0, 0.0), F0, 1.0, 80.0, "moving", ""))
    assert failed_mode(usual, usual.robots[R0]) is None and issues(usual, usual.robots[R0]) is None


def test_a_task_without_a_token_is_held_by_an_emergency() -> None:
    held = reduced(rmf_fleet(), reported(T0, "a", OrderState.PAUSED), tick(T0))
    ours = reduced(rmf_fleet(), reported(T0, "a", OrderState.PAUSED, tokens=("0",)), reported(T0, "b", ON))
    found = emergency(held, held.robots[R0])
    assert found is not None and found.name == "held by an emergency"
    assert emergency(ours, ours.robots[R0]) is None
