"""The speeds of a robot."""

from fleet_tui.model.set_up.driving import STILL, Speeds


def test_the_linear_speed_is_that_of_both_directions_together() -> None:
    assert Speeds(0.3, -0.4, 9.0).linear == 0.5
    assert STILL.linear == 0.0
