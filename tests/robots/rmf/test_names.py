"""Names of robots in fleets."""

from fleet_tui.robots.rmf.names import fleet_and_name, robot_name


def test_a_name_has_its_fleet_first() -> None:
    assert robot_name("tiny", "t1") == "tiny/t1"
    assert fleet_and_name("tiny/t1") == ("tiny", "t1")
    assert fleet_and_name("tiny/a/b") == ("tiny", "a/b")
    assert fleet_and_name("alone") == ("alone", "")
