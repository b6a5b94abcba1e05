"""Robots with Nav2 on the wire: what recordings of a real bridge tell, what is refused, what leaves."""

import math

from tests.support.nav2_adapter import adapter


def test_names_at_another_site() -> None:
    it = adapter(
        topics={"odometry": "/fleet/{robot}/wheels", "blocked": ""},
        actions={"navigate_to_pose": "/{robot}/nav/go", "dock_robot": ""},
    )
    addresses = [feed.address for feed in it.feeds("tb2", ("hall",))]
    assert "/fleet/tb2/wheels" in addresses and "/tb2/nav/go/_action/status" in addresses
    assert not any("collision" in one or "/dock_robot" in one for one in addresses)
    assert "blocked" not in it.kind.reports


def test_without_odometry_a_pose_never_ages_by_itself() -> None:
    assert adapter(topics={"odometry": ""}).kind.silence_of("pose", 5.0) == math.inf
    assert adapter().kind.silence_of("pose", 5.0) == 5.0
