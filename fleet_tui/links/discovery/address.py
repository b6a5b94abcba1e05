"""An address as a person types it."""

import msgspec

from fleet_tui.config.check import checked
from fleet_tui.config.entries import DEFAULT_LINK, RobotEntry
from fleet_tui.config.schema import Config, Link
from fleet_tui.text.errors import ConfigError, is_address

_WEB = {"http": "ws", "https": "wss"}
USUAL_PORT = 9090
"""The port of rosbridge where nobody has changed it."""


def bridge_at(url: str, known: Link | None = None) -> Link:
    """Return the bridge or broker at an address, with the settings of a `known` one. Raises ConfigError for
    an invalid address."""
    bridge = msgspec.structs.replace(known or Link(), url=url.strip())
    scheme, _, rest = bridge.url.partition("://")
    wrong = [
        line
        for line in checked(Config(rosbridge=bridge, robots=[RobotEntry("robot")]))
        if line.startswith(f"{DEFAULT_LINK}.")
    ]
    if wrong:
        raise ConfigError([_meant(bridge, scheme, rest) or wrong[0].removeprefix(f"{DEFAULT_LINK}.")])
    return bridge


def _meant(bridge: Link, scheme: str, rest: str) -> str:
    """Return the probably intended address, empty if unknown."""
    if scheme.lower() in _WEB and rest:
        meant = f"{_WEB[scheme.lower()]}://{rest}"
    elif "://" not in bridge.url and is_address(bridge.url):
        meant = f"ws://{bridge.url}" if ":" in bridge.url else f"ws://{bridge.url}:{USUAL_PORT}"
    else:
        return ""
    return f"{bridge.shown} is not a rosbridge address: did you mean {Link(meant).shown}?"
