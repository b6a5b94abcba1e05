"""Fleets of Open-RMF: their robots are named in messages only, not by topics."""

from collections.abc import Iterator

from fleet_tui.model.order import natural
from fleet_tui.robots.discovery import NAME, Discovery, Listed
from fleet_tui.robots.rmf.encoded import text_reader
from fleet_tui.robots.rmf.facilities import READERS
from fleet_tui.robots.rmf.fleets import FleetMessage, FleetUpdate, MemberMessage, MemberUpdate
from fleet_tui.robots.rmf.graphs import LEVEL, NavGraphMessage, NodeMessage
from fleet_tui.robots.rmf.names import robot_name
from fleet_tui.robots.rmf.vocabulary import VOCABULARY
from fleet_tui.robots.ros import messages as ros
from fleet_tui.robots.ros.type_names import same_type
from fleet_tui.text.errors import WireError
from fleet_tui.text.language import Message

SAMPLES = ("fleets", "statuses", "graphs")
"""Keys of the topics whose messages name robots and levels."""


def discover(listed: Listed) -> Discovery:
    """Name the robots of all fleets and the levels, and the topics that are missing."""
    members, levels = set[tuple[str, str]](), set[str]()
    for fleet, name, level in _members(listed):
        members.add((fleet, name))
        levels.add(level)
    robots = {robot_name(*one) for one in members}
    slashed = {robot_name(*one) for one in members if "/" in one[0]}
    odd = sorted(name for name in robots if name in slashed or not NAME.fullmatch(name))
    floors = sorted((levels | set(_levels(listed))) - {""}, key=natural)
    found = Discovery({name: list(floors) for name in sorted(robots - set(odd), key=natural)})
    if not found.robots:
        return found
    for key, (topic, type_) in VOCABULARY.topics.items():
        there = listed.topics.get(topic, "") or listed.heard.get(topic, "")
        if key not in ("requests", "responses") and not same_type(there, type_):
            found.topics[key] = ""
            if key in READERS:
                continue  # not every site has them
            found.note(
                "topics", Message("{key}: no {topic} of type {type}", key=key, topic=topic, type=type_)
            )
    if "building" not in found.topics:
        found.live_maps |= set(floors)
    for name in odd:
        if name in slashed:
            found.note(
                "topics",
                Message("{name} can't be a robot name here: its fleet's name contains a /", name=f"{name!r}"),
            )
        else:
            found.note(
                "topics",
                Message("{name} can't be a robot name here: letters, digits and ./_- only", name=f"{name!r}"),
            )
    return found


def _messages(listed: Listed, key: str) -> tuple[object, ...]:
    return listed.messages.get(VOCABULARY.topics[key][0], ())


def _members(listed: Listed) -> Iterator[tuple[str, str, str]]:
    """Yield the fleet, the name and the level of each robot in the messages that can be read."""
    read, read_one = ros.reader(FleetMessage), ros.reader(MemberMessage)
    read_update, read_place = text_reader(FleetUpdate), ros.reader(MemberUpdate)
    for message in _messages(listed, "fleets"):
        try:
            fleet = read(message)
            for one in map(read_one, fleet.robots):
                yield fleet.name, one.name, one.location.level_name
        except WireError:
            continue
    for message in _messages(listed, "statuses"):
        try:
            update = read_update(message).data
            for name, one in update.robots.items():
                place = read_place(one).location
                yield update.name, name, place.map if place else ""
        except WireError:
            continue


def _levels(listed: Listed) -> Iterator[str]:
    """Yield the levels of navigation graphs: a robot may be on one without having been there."""
    read, read_node = ros.reader(NavGraphMessage), ros.reader(NodeMessage)
    for message in _messages(listed, "graphs"):
        try:
            for node in map(read_node, read(message).vertices):
                yield from (one.value_string for one in node.params if one.name == LEVEL)
        except WireError:
            continue
