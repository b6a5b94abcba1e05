"""Kinds of simulated robots."""

import pytest

from fleet_tui.simulator.kinds import KINDS


@pytest.mark.parametrize("kind", KINDS)
def test_a_fleet_has_the_robots_it_is_asked_for(kind: str) -> None:
    fleet = KINDS[kind].build(3, 2, 1, 4, 3)
    assert list(fleet.robots) == [KINDS[kind].named(turn, number) for turn, number in enumerate((4, 7, 10))]
    assert [robot.index for robot in fleet.robots.values()] == [4, 7, 10]
