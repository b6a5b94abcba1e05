"""Settings of this kind alone: `[profile.nav2]`."""

from typing import Literal

from msgspec import Struct


class Settings(Struct, frozen=True):
    """`pause`: what stands in for a pause, which Nav2 has not. `hold` cancels the goal and keeps it in this
    console, `lock` locks the motors over `[profile.topics] pause_navigation`, empty is none."""

    pause: Literal["hold", "lock", ""] = "hold"
