"""Sites of one console."""

from fleet_tui.model.commands import PauseRobot
from fleet_tui.model.sites import alarms_by_site, of_site, robots_at, site_of, sites_of
from tests.support.fleets import T0, commanded, fleet, reduced, tick
from tests.support.sites import two_sites


def test_a_site_has_its_robots_floors_alarms_and_commands() -> None:
    state = reduced(two_sites(), *commanded(1, PauseRobot("robot_0")), tick(T0))
    assert sites_of(state) == ["north", "south"] and site_of(state, "robot_1") == "south"
    north, south = of_site(state, "robot_2"), of_site(state, "robot_1")
    assert list(north.robots) == robots_at(state, "north") == ["robot_0", "robot_2"]
    assert [list(one.floors) for one in (north, south)] == [["floor_0"], ["floor_1"]]
    assert [len(one.alarms) for one in (north, south)] == [0, 1]
    assert [len(one.commands) for one in (north, south)] == [1, 0]
    assert alarms_by_site(state) == {"south": 1}


def test_an_alarm_of_a_link_is_one_of_its_site() -> None:
    lost = reduced(two_sites(), tick(T0 + 60.0))
    assert all(alarm.condition.source != "b" for alarm in of_site(lost, "robot_0").alarms)


def test_links_of_one_site_or_of_none_are_one() -> None:
    for state in (two_sites("north", "north"), two_sites("", ""), fleet(3)):
        assert sites_of(state) == [] and of_site(state, "robot_0") is state and not alarms_by_site(state)
    assert sites_of(two_sites("north", "")) == ["north", ""]
