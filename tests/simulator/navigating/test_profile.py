"""Profiles of simulated robots that navigate."""

from fleet_tui.simulator.kinds import KINDS


def test_topics_of_floors_are_named_only_where_there_are_several() -> None:
    profile = KINDS["nav2"].profile
    assert profile(1) == {"topics": {"mode": "/{robot}/mode"}}
    assert profile(2) == {
        "topics": {"mode": "/{robot}/mode", "floor": "/{robot}/floor", "map": "/{floor}/map"}
    }
    assert KINDS["rmf"].profile(3) == {}
