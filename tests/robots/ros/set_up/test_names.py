"""Names of set-up that a kind gives, and those that it leaves empty."""

from fleet_tui.robots.ros.set_up.names import SERVICES, TOPICS, with_names


def test_a_kind_names_some_and_the_others_stay_empty() -> None:
    found = with_names(TOPICS, {"scan": "/{robot}/scan"})
    assert found["scan"] == ("/{robot}/scan", "sensor_msgs/LaserScan")
    assert {name for key, (name, _) in found.items() if key not in ("scan", "tf_static")} == {""}
    assert set(with_names(SERVICES, {})) == set(SERVICES)
