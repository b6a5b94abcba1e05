"""The entries of a configuration's floors and robots."""

from typing import Annotated

import msgspec

DEFAULT_LINK = "rosbridge"

Positive = Annotated[float, msgspec.Meta(gt=0, lt=1e6)]
Offset = Annotated[float, msgspec.Meta(ge=-100, le=100)]


class FloorEntry(msgspec.Struct, frozen=True):
    """`[[floors]]`; `map` and `graph` are relative to the config file, `frame_id` defaults to the name."""

    name: str
    map: str = ""
    graph: str = ""
    frame_id: str = ""

    @property
    def frame(self) -> str:
        """Return the frame_id of poses on this floor, without a leading slash."""
        return (self.frame_id or self.name).lstrip("/")


class RobotEntry(msgspec.Struct, frozen=True):
    """`[[robots]]`; no floors means every floor, no link the one of `[rosbridge]`; `profile` names a table of
    `[profiles]` or a kind, by default that of its link, else `[profile]`; size in metres; `laser` is the pose
    of its laser on it, in metres and radians, upside down if `laser_flipped`. `manufacturer` and `serial`:
    which vehicle of VDA 5050 it is, by default the one with its name as its serial number."""

    name: str
    floors: list[str] = []
    link: str = DEFAULT_LINK
    profile: str = ""
    size: tuple[Positive, Positive] | None = None
    laser: tuple[Offset, Offset, Offset] | None = None
    laser_flipped: bool = False
    manufacturer: str = ""
    serial: str = ""
