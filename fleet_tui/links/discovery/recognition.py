"""Recognition of the kinds of robots behind a bridge: each kind recognises its own. Pure."""

from collections.abc import Mapping
from dataclasses import replace

from fleet_tui.robots.discovery import Discovery, Listed
from fleet_tui.robots.registry import DEFAULT_KIND, KINDS

Found = Mapping[str, Discovery]
"""The findings, by kind."""


def claimed(listed: Listed) -> Found:
    """Return the robots that each kind claims. Guesses count only without certain claims."""
    listed = listed.sane()
    found = {name: kind.discover(listed) for name, kind in KINDS.items()}
    certain = {name: one for name, one in found.items() if one.robots and not one.is_guess}
    guesses = {name: one for name, one in found.items() if one.robots}
    return certain or guesses or {DEFAULT_KIND: found[DEFAULT_KIND]}


def contested(claims: Found) -> dict[tuple[str, ...], list[str]]:
    """Return the robots that several kinds claim, by these kinds."""
    kinds_of = dict[str, list[str]]()
    for kind, one in claims.items():
        for robot in one.robots:
            kinds_of.setdefault(robot, []).append(kind)
    found = dict[tuple[str, ...], list[str]]()
    for robot, kinds in kinds_of.items():
        if len(kinds) > 1:
            found.setdefault(tuple(kinds), []).append(robot)
    return found


def assigned(claims: Found, chosen: Mapping[str, str]) -> Found:
    """Give each robot to one kind: the one `chosen` for it, else the first that claims it."""
    found, taken = dict[str, Discovery](), set[str]()
    for kind, one in claims.items():
        robots = {
            robot: floors
            for robot, floors in one.robots.items()
            if robot not in taken and chosen.get(robot, kind) == kind
        }
        taken |= robots.keys()
        if robots or len(claims) == 1:
            found[kind] = replace(one, robots=robots)
    return found


def discover(listed: Listed) -> Found:
    """Return the findings, by kind; without any robots those of the usual kind."""
    return assigned(claimed(listed), {})
