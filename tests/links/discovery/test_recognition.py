"""Recognition of robots in the lists of a bridge, of any length and with any names."""

import pytest

from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.recognition import claimed
from fleet_tui.links.discovery.site import DiscoveredSite
from fleet_tui.robots.discovery import Listed
from fleet_tui.robots.registry import KINDS
from fleet_tui.text.errors import FleetError

MANY = 3000
STATUS = "actionlib_msgs/GoalStatusArray"


@pytest.mark.nightly
@pytest.mark.parametrize("kind", ["oh_ressources", "move_base"])
def test_thousands_of_robots_take_no_longer_each_than_a_few(kind: str) -> None:
    vocabulary = KINDS[kind].vocabulary
    topics = {
        name.replace("{robot}", f"robot_{n}").replace("{floor}", "floor_0"): type_
        for n in range(MANY)
        for name, type_ in vocabulary.topics.values()
        if name
    }
    found = claimed(Listed(topics, {}))
    assert len(found[kind].robots) == MANY


def test_names_that_no_config_can_hold_are_left_out() -> None:
    bad = (
        "a\x1b[2J",
        'b"\n[operator]\narmed = true\n"',
        "c" * 300,
        "/".join("d" * 300),
        "é",
        "",
        "e f",
        "{robot}",
    )
    topics = {f"/{name}/move_base/status": STATUS for name in (*bad, "robot_1")}
    site = DiscoveredSite(Link("ws://robot:9090"), claimed(Listed(topics, {})), {}, len(topics))
    assert [robot.name for robot in site.config.robots] == ["robot_1"]
    assert site.text.isascii() and "armed" not in site.text


def test_names_that_mean_two_things_are_said_with_the_address_and_a_remedy() -> None:
    topics = {"/a/move_base/status": STATUS, "/a/move_base/feedback": "sensor_msgs/BatteryState"}
    site = DiscoveredSite(Link("ws://robot:9090"), claimed(Listed(topics, {})), {}, len(topics))
    with pytest.raises(FleetError) as said:
        assert site.config
    words = str(said.value)
    assert words.startswith("ws://robot:9090: ") and words.endswith("--from-live ws://robot:9090")
    assert "/a/move_base/feedback is used by feedback of a and battery of a" in words
