"""The screens before the console under the pilot: what they show at any size, and what they open."""

import pytest

from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.recognition import claimed
from fleet_tui.links.discovery.site import DiscoveredSite
from fleet_tui.robots.discovery import Listed
from tests.support.entry_app import SIZES, entry

ODOM, AMCL = "nav_msgs/msg/Odometry", "geometry_msgs/msg/PoseWithCovarianceStamped"
MAP = "nav_msgs/msg/OccupancyGrid"


def unsure(robots: int = 1) -> DiscoveredSite:
    """A site with two topics for poses, and two floors that nothing tells."""
    topics = {"/hall/map": MAP, "/roof/map": MAP}
    for n in range(robots):
        topics |= {f"/amr_{n}/odom": ODOM, f"/amr_{n}/pose_a": AMCL, f"/amr_{n}/pose_b": AMCL}
    actions = tuple(f"/amr_{n}/navigate_to_pose" for n in range(robots))
    return DiscoveredSite(Link("ws://site:9090"), claimed(Listed(topics, {}, actions)), {}, len(topics))


@pytest.mark.parametrize("size", SIZES)
async def test_what_is_not_certain_is_chosen_first(size: tuple[int, int]) -> None:
    async with entry(unsure(), size=size) as it:
        await it.shows("ws://site:9090: 1 robot (nav2), 2 floors", "Please check.")
        await it.shows("> topic of pose (nav2)", "none of 2", "floor of amr_0", "any floor")
        await it.shows("enter open", "up/down line", "left/right choose", "q quit")
        await it.pilot.press("right")
        await it.shows("/{robot}/pose_a", "1 of 2")
        await it.pilot.press("right", "down", "left")
        await it.shows("/{robot}/pose_b", "< roof", "2 of 2")
        await it.pilot.press("enter")
        await it.ended()
        assert isinstance(it.app.chosen, DiscoveredSite)
        config = it.app.chosen.config
        assert config.profile.topics["pose"] == "/{robot}/pose_b"
        assert config.robots[0].floors == ["roof"]


async def test_many_choices_scroll_with_the_cursor() -> None:
    async with entry(unsure(20), size=(60, 15)) as it:
        await it.shows("floor of amr_0")
        await it.pilot.press(*["down"] * 20)
        await it.shows("> floor of amr_19")
        await it.pilot.press("q")
        await it.ended()
        assert it.app.chosen is None


async def test_of_another_kind_there_are_fewer_choices() -> None:
    topics = {"/amr/odom": ODOM, "/amr/pose_a": AMCL, "/amr/pose_b": AMCL, "/map": MAP}
    topics |= {"/amr/queue": "oh_ressources/msg/ActionQueue", "/amr/pose": "geometry_msgs/msg/PoseStamped"}
    claims = claimed(Listed(topics, {}, ("/amr/navigate_to_pose",)))
    async with entry(DiscoveredSite(Link("ws://site:9090"), claims, {}, 5)) as it:
        await it.shows("kind of amr", "oh_ressources")
        await it.pilot.press("right")
        await it.shows("< nav2", "topic of pose (nav2)")
        await it.pilot.press("down", "up", "right")
        await it.shows("< oh_ressources")
        assert "topic of pose (nav2)" not in it.text
