"""Profiles of simulated fleets."""

from fleet_tui.simulator.rmf.profile import profile


def test_all_names_are_the_usual_ones() -> None:
    assert profile(3) == {}
