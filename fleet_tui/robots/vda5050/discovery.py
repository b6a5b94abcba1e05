"""Recognition of vehicles: by their connection topics on a broker, never among the topics of a bridge."""

import re
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from fleet_tui.robots.discovery import NAME, Discovery, Listed
from fleet_tui.robots.vda5050.fields import Fields

_UNUSABLE = re.compile(r"[^A-Za-z0-9_]+")


class SeenVehicle(NamedTuple):
    """A vehicle on a broker: its address there, the version of its messages, the maps of its poses."""

    manufacturer: str
    serial: str
    version: str = ""
    maps: tuple[str, ...] = ()


def discover(_listed: Listed) -> Discovery:
    """Return nothing: a bridge has no such vehicles."""
    return Discovery()


def has_header(message: Fields) -> bool:
    """Tell whether a message says which vehicle sent it: any program may publish on topics of this shape."""
    return bool(message.id("manufacturer") and message.id("serialNumber"))


def named(vehicles: Iterable[SeenVehicle], taken: Iterable[str] = ()) -> Mapping[str, SeenVehicle]:
    """Return vehicles by the names of their robots: the serial number as far as it can be a name, with the
    manufacturer where several have the same, or where it is `taken`."""
    taken, found = set(taken), dict[str, SeenVehicle]()
    for one in sorted(vehicles):
        own = _name(one.serial) or "vehicle"
        name = own if own not in taken else _name(f"{one.manufacturer}_{one.serial}") or own
        number = 2
        while name in taken:
            name, number = f"{own}_{number}", number + 1
        found[name] = one
        taken.add(name)
    return found


def _name(text: str) -> str:
    """Return a text as a name: data from the wire may be anything."""
    found = _UNUSABLE.sub("_", text)[:40].strip("_")
    if found[:1].isdigit():  # it would read as a number of something
        found = f"agv_{found}"
    return found if NAME.fullmatch(found) else ""
