"""What kinds of robots a bridge has: each kind recognises its own. Pure."""

from collections.abc import Mapping

from fleet_tui.adapters.discovery import Discovery, Listed
from fleet_tui.adapters.registry import DEFAULT_KIND, KINDS

Found = Mapping[str, Discovery]
"""What was found, by kind."""


def discover(listed: Listed) -> Found:
    """Return what was found, by kind; of no robots at all what the usual kind makes of it. A robot belongs to
    the first kind that claims it, and guesses count only where nothing is certain."""
    listed = listed.sane()
    found = {name: kind.discover(listed) for name, kind in KINDS.items()}
    certain = {name: one for name, one in found.items() if one.robots and not one.is_guess}
    guesses = {name: one for name, one in found.items() if one.robots}
    kinds, taken = certain or guesses, set[str]()
    for one in kinds.values():
        one.robots = {robot: floors for robot, floors in one.robots.items() if robot not in taken}
        taken |= one.robots.keys()
    return {name: one for name, one in kinds.items() if one.robots} or {DEFAULT_KIND: found[DEFAULT_KIND]}
