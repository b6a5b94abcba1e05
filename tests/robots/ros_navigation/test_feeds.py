"""The topics of a navigating robot: how often each is asked for, and when."""

from fleet_tui.robots.ros_navigation.feeds import PLAN_MS
from tests.support.nav2_adapter import adapter, feeds


def test_places_come_often_and_what_comes_on_change_may_be_silent() -> None:
    found = feeds(adapter())
    assert found["odometry"].fast and not found["odometry"].silent
    assert found["pose"].latched and found["pose"].silent
    assert (found["battery"].rate_ms, found["plan"].rate_ms) == (500, PLAN_MS)


def test_maps_and_paths_come_only_while_they_are_wanted() -> None:
    found = feeds(adapter())
    assert {key for key, feed in found.items() if feed.on_demand} == {
        *("map", "plan", "scan", "camera", "tf", "tf_static")
    }
    assert found["map"].large and found["map"].is_shared


def test_a_floor_has_a_map_and_a_robot_of_its_own_map_shares_it_with_none() -> None:
    it = adapter(topics={"map": "/{robot}/{floor}/map"})
    maps = [feed for feed in it.feeds("tb2", ("hall", "roof")) if feed.key == "map"]
    assert [feed.address for feed in maps] == ["/tb2/hall/map", "/tb2/roof/map"]
    assert not any(feed.is_shared for feed in maps)
