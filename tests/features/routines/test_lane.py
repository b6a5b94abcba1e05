"""States of a lane."""

from fleet_tui.features.routines.lane import Lane, LanePhase, Part, Position


def test_a_lane_has_failed_while_it_carries_out_what_follows_a_failure() -> None:
    assert not Lane("r").has_failed and not Lane("r", phase=LanePhase.DONE).has_failed
    assert Lane("r", (Position(Part.FAILURE),)).has_failed and Lane("r", phase=LanePhase.FAILED).has_failed


def test_a_lane_is_over_at_each_of_its_ends() -> None:
    over = [phase for phase in LanePhase if Lane("r", phase=phase).is_over]
    assert over == [LanePhase.DONE, LanePhase.FAILED, LanePhase.STOPPED]
