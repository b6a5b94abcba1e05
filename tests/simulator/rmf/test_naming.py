"""Names of simulated fleets."""

from fleet_tui.simulator.rmf.naming import fleet_of, full_name


def test_fleets_take_turns() -> None:
    assert [full_name(turn, 3 + 4 * turn) for turn in range(3)] == [
        "tiny/robot_3",
        "carrier/robot_7",
        "tiny/robot_11",
    ]
    assert fleet_of(5, ("a", "b", "c")) == "c"
