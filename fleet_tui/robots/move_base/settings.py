"""Settings of this kind alone: `[profile.move_base]`."""

from fleet_tui.robots.ros_navigation.pauses import PauseSettings


class MoveBaseSettings(PauseSettings, frozen=True):
    """Settings of robots with move_base."""


SETTINGS = MoveBaseSettings
