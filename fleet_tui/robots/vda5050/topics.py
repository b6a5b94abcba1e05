"""Topics of vehicles, in the levels of the standard or of a site's template."""

import re
from collections.abc import Mapping
from typing import NamedTuple

TEMPLATE = "{interface}/{version}/{manufacturer}/{serial}/{name}"
LEVELS = ("interface", "version", "manufacturer", "serial", "name")
INTERFACE = "uagv"
INTERFACE_3 = "vda5050"
"""The interfaces of the standard's examples, before 3.0 and since."""
ANY = "+"
"""A level of any content."""
ORDER = "order"
INSTANT_ACTIONS = "instantActions"
READ = ("connection", "state", "visualization", "factsheet", ORDER, INSTANT_ACTIONS)
"""Names of the topics that are read. The last two have the messages of master controls."""
OF_MASTERS = frozenset({ORDER, INSTANT_ACTIONS})


class VehicleAddress(NamedTuple):
    """A topic: whose it is, its name, and as its base the topic with a NUL, which no topic contains, in place
    of the name."""

    manufacturer: str
    serial: str
    name: str
    base: str


class Topics:
    """The topics of one site."""

    def __init__(self, template: str = TEMPLATE, interface: str = "") -> None:
        """`interface`: the content of that level, empty for any."""
        self._template = template.replace("{interface}", interface or "{interface}")
        pattern = re.escape(self._template)
        for level in LEVELS:
            pattern = pattern.replace(re.escape(f"{{{level}}}"), f"(?P<{level}>[^/]+)", 1)
        self._pattern = re.compile(pattern)

    def filter(self, name: str, manufacturer: str = "", serial: str = "", **levels: str) -> str:
        """Return the subscription to a topic of one vehicle, or of all; its address if the interface and the
        version are among the `levels`."""
        known: Mapping[str, str] = {"name": name, "manufacturer": manufacturer, "serial": serial, **levels}
        found = self._template
        for level in LEVELS:
            found = found.replace(f"{{{level}}}", known.get(level) or ANY)
        return found

    def parse(self, topic: str) -> VehicleAddress | None:
        """Return whose topic this is, None if it is none of a vehicle."""
        found = self._pattern.fullmatch(topic)
        if found is None:
            return None
        start, end = found.span("name")
        levels = found.groupdict()
        base = f"{topic[:start]}\0{topic[end:]}"
        return VehicleAddress(levels.get("manufacturer") or "", levels["serial"], levels["name"], base)


def with_name(base: str, name: str) -> str:
    """Return the topic of a name, by the base of an address."""
    return base.replace("\0", name)
