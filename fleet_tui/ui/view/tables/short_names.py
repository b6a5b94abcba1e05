"""Names of robots and floors as they are shown in few cells."""

from collections import Counter
from collections.abc import Collection, Mapping
from functools import lru_cache
from itertools import takewhile

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot

UNKNOWN_FLOOR = "unknown floor"
NO_FLOOR = ("", "-", UNKNOWN_FLOOR)


def floor_text(state: FleetState, robot: Robot) -> str:
    """Return the floor a robot is on, as far as its pose shows."""
    if robot.pose is None:
        return "-" if "pose" in robot.kind.reports else ""
    return robot.floor or UNKNOWN_FLOOR


@lru_cache(maxsize=4)
def own_names(robots: tuple[str, ...]) -> Mapping[str, str]:
    """Return the names of robots without that of their fleet, before a `/`, where they are unique so."""
    ends = Counter(name.rpartition("/")[2] for name in robots)
    own = {name: name.rpartition("/")[2] for name in robots}
    return {name: end if end and ends[end] == 1 else name for name, end in own.items()}


def shortened(floors: Collection[str]) -> Mapping[str, str]:
    """Return floors without the beginning that all of them have, up to its last separator: `floor_0` and
    `floor_1` as `0` and `1`, an unknown one as `?`."""
    real = [name for name in floors if name not in NO_FLOOR]
    pairs = zip(min(real), max(real), strict=False) if len(real) > 1 else ()
    common = "".join(one for one, _ in takewhile(lambda pair: pair[0] == pair[1], pairs))
    start = max(common.rfind(mark) for mark in " _-.") + 1
    found = {name: name if name in NO_FLOOR else name[start:] or name for name in floors}
    return found | ({UNKNOWN_FLOOR: "?"} if UNKNOWN_FLOOR in found else {})
