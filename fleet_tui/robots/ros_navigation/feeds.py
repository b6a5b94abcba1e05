"""The topics of any navigating robot."""

from collections.abc import Iterator, Sequence

from fleet_tui.robots.adapter import Feed, Site
from fleet_tui.robots.ros.names import Names
from fleet_tui.robots.ros.set_up.requests import MOST_PUBLISHERS

PLAN_MS = 1000
"""Milliseconds between two paths, each of which may be long: only its end counts."""


def feed(names: Names, robot: str, like: Feed, key: str) -> Iterator[Feed]:
    """Return a feed like another one for a key, unless this site has no such topic."""
    if topic := names.topic(key, robot, like.floor):
        yield like._replace(key=key, address=topic, type=names.type(key))


def places(names: Names, site: Site, robot: str) -> Iterator[Feed]:
    """Return the topics of a robot's position."""
    yield from feed(names, robot, Feed("", (robot,), "", "", "", site.pose_ms, fast=True), "odometry")
    yield from feed(names, robot, _latched(robot), "pose")
    # The localisation and the wheels publish it, each at its own rate: the newest alone is not enough.
    transforms = Feed("", (robot,), "", "", "", site.pose_ms, silent=True, wanted_for="place", is_shared=True)
    yield from feed(names, robot, transforms._replace(queue_length=MOST_PUBLISHERS), "tf")


def battery(names: Names, site: Site, robot: str) -> Iterator[Feed]:
    """Return the topic of its charge."""
    yield from feed(names, robot, Feed("", (robot,), "", "", "", site.status_ms), "battery")


def surroundings(names: Names, robot: str, floors: Sequence[str]) -> Iterator[Feed]:
    """Return the topics of its floor, its path and its maps."""
    latched = _latched(robot)
    yield from feed(names, robot, latched, "floor")
    plan = Feed("", (robot,), "", "", "", PLAN_MS, silent=True, wanted_for="target")
    yield from feed(names, robot, plan, "plan")
    topic = names.profile.topics.get("map", names.vocabulary.topics["map"][0])
    shown = latched._replace(silent=False, wanted_for="map", large=True, is_shared="{robot}" not in topic)
    for floor in floors:
        yield from feed(names, robot, shown._replace(floor=floor), "map")


def _latched(robot: str) -> Feed:
    return Feed("", (robot,), "", "", "", latched=True, silent=True)
