"""Names of simulated fleets."""

from fleet_tui.simulator.rmf.naming import fleet_of, full_name


def test_fleets_take_turns() -> None:
    assert [full_name(n) for n in range(3)] == ["tiny/robot_0", "carrier/robot_1", "tiny/robot_2"]
    assert fleet_of(5, ("a", "b", "c")) == "c"
