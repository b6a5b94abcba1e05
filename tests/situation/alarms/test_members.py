"""Alarms of robots of fleets."""

import pytest

from fleet_tui.model.fleets.events import FacilityReported, MemberReported, StatusReported
from fleet_tui.model.fleets.facility import LIFT, Facility
from fleet_tui.model.fleets.member import Member
from fleet_tui.model.geometry import Pose
from fleet_tui.situation.alarms.members import issue_remedy, issue_text
from fleet_tui.text.language import Message
from tests.support.fleets import F0, R0, T0, reduced, tick
from tests.support.rmf import rmf_fleet


@pytest.mark.parametrize(
    ("member", "text"),
    [
        (Member(Message("moving")), ""),
        (Member(Message("emergency")), "emergency"),
        (Member(Message("adapter error"), issues=("lift: stuck",)), "lift: stuck"),
        (Member(issues=("a", "b", "c")), "a (and 2 more)"),
    ],
)
def test_the_first_issue_else_a_mode_that_can_not_drive(member: Member, text: str) -> None:
    assert issue_text(member) == text


def test_an_issue_is_an_alarm_until_the_adapter_drops_it() -> None:
    here = MemberReported(R0, T0, Pose(0.0, 0.0), F0, 1.0, 80.0, "moving", "")
    told = StatusReported(R0, T0, "working", "", ("lift: stuck",))
    state = reduced(rmf_fleet(), here, told, tick(T0))
    assert ("issue", "lift: stuck") in [(one.condition.kind, one.text) for one in state.alarms]
    over = reduced(state, StatusReported(R0, T0 + 1, "working", "", ()), tick(T0 + 1), tick(T0 + 5))
    assert not any(one.holds and one.condition.kind == "issue" for one in over.alarms)


def test_an_issue_that_names_a_lift_leads_there() -> None:
    state = reduced(rmf_fleet(), FacilityReported(R0, T0, Facility(LIFT, "lift_1", T0)))
    assert issue_remedy(state, "lift: lift_1 does not answer").startswith("Go to lift_1")
    assert issue_remedy(state, "lift: lift_2 does not answer") == ""
