"""The `kinds` command: the reports and requests of each kind of robots."""

import json
import math
from collections.abc import Callable, Iterator

from fleet_tui.model.kind import Kind
from fleet_tui.model.robot import Robot
from fleet_tui.robots.adapter import Site
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.registry import DEFAULT_KIND, KINDS, Registered
from fleet_tui.robots.ros.set_up import names as set_up

VERSION = 1


def _of(registered: Registered) -> tuple[Kind, Kind]:
    """Return a kind without a profile, and with the highest role and a placeholder for every unnamed topic
    and set-up service."""
    words = registered.vocabulary
    unnamed = {key: f"/{{robot}}/{key}" for key, (name, _) in words.topics.items() if not name}
    named = words.services
    services = {key: f"/{{robot}}/{key}" for key in set_up.SERVICES if key in named and not named[key][0]}
    usual, whole = Profile(), Profile(topics=unnamed, services=services)
    return registered.adapter(usual, Site()).kind, registered.adapter(whole, Site(role="master")).kind


def _silence(kind: Kind, offline_after: float) -> dict[str, float | None]:
    """Return by value the seconds after which it is old, None if sent only on change. Maps and graphs never
    are."""
    values = [value for value in kind.reports if value in Robot.__struct_fields__]
    found = {value: kind.silence_of(value, offline_after) for value in values}
    return {value: None if math.isinf(seconds) else seconds for value, seconds in found.items()}


def kinds(as_json: bool, say: Callable[[str], None]) -> None:
    """Print the reports and requests of each kind, in the order of the registry."""
    described = {name: _of(registered) for name, registered in KINDS.items()}
    if as_json:
        found = [_values(name, *both) for name, both in described.items()]
        say(json.dumps({"version": VERSION, "kinds": found}))
        return
    for name, both in described.items():
        for line in _lines(name, *both):
            say(line)


def _values(name: str, usual: Kind, whole: Kind) -> dict[str, object]:
    return {
        "name": name,
        "default": name == DEFAULT_KIND,
        "reports": list(usual.reports),
        "can_report": [value for value in whole.reports if value not in usual.reports],
        "accepts": list(usual.accepts),
        "can_accept": [asked for asked in whole.accepts if asked not in usual.accepts],
        "streams": list(usual.streams),
        "can_stream": [key for key in whole.streams if key not in usual.streams],
        "queue_kept_here": usual.keeps_goals,
        "stops_given_here": usual.gives_stops,
        "pause_holds": usual.holds,
        "silence_s": _silence(usual, Site().offline_after),
    }


def _lines(name: str, usual: Kind, whole: Kind) -> Iterator[str]:
    more = [value for value in whole.reports if value not in usual.reports]
    yield f"{name} (default)" if name == DEFAULT_KIND else name
    yield f"  reports  {', '.join(usual.reports)}"
    if more:
        yield f"           with [profile.topics]: {', '.join(more)}"
    yield f"  accepts  {', '.join(usual.accepts) or 'nothing'}"
    if usual.withheld:
        yield f"           by the role of the link: {', '.join(usual.withheld)}"
    elif further := [asked for asked in whole.accepts if asked not in usual.accepts]:
        yield f"           with names in [profile]: {', '.join(further)}"
    if usual.streams:
        yield f"  streams  {', '.join(usual.streams)}"
    elif whole.streams:
        yield f"  streams  with [profile.topics]: {', '.join(whole.streams)}"
    if usual.keeps_goals:
        yield "  queue    kept by the console that sent the orders"
    if usual.gives_stops:
        yield "  stops    one goal each: the console sends the next when one is reached"
    if usual.holds:
        yield "  pause    cancels the goal; the console keeps it, resume sends it again"
