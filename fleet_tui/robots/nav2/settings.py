"""Settings of this kind alone: `[profile.nav2]`."""

from fleet_tui.robots.ros_navigation.pauses import PauseSettings


class Nav2Settings(PauseSettings, frozen=True):
    """Settings of robots with Nav2."""


SETTINGS = Nav2Settings
