"""The adapters of a configuration: one per robot, and their needs of each link."""

import hashlib
import os
import platform
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import msgspec

from fleet_tui.config.entries import RobotEntry
from fleet_tui.config.schema import Config, link_key
from fleet_tui.robots.adapter import Adapter, Feed, Limit, Site
from fleet_tui.robots.profile import DriveConfig, Profile
from fleet_tui.robots.registry import KINDS, kind_of

OF_BROKERS = "vda5050"
"""The kind of the robots of a broker."""
STEERING = frozenset({"drive", "goal", "initial_pose"})
"""Keys of the topics that move a robot, or its place on the map."""


def profile_of(config: Config, robot: RobotEntry) -> tuple[str, Profile]:
    """Return the profile of a robot, and its table in the config."""
    link = config.link(robot.link)
    name = robot.profile or link.profile
    if not name and link.is_broker and kind_of(config.profile) != OF_BROKERS:
        name = OF_BROKERS
    if name in config.profiles:
        return f"profiles.{name}", config.profiles[name]
    return ("profile", config.profile) if not name else (f"profiles.{name}", Profile(kind=name))


def drive_of(config: Config, robot: RobotEntry) -> DriveConfig:
    """Return the limits of a robot that is driven by hand: those of its profile, else of all robots."""
    return profile_of(config, robot)[1].drive or config.drive


def adapters_of(config: Config) -> dict[str, Adapter]:
    """Return the adapter of each robot, one for all robots of a profile, and of a broker."""
    made: dict[tuple[str, str], Adapter] = {}
    found = {}
    for robot in config.robots:
        table, profile = profile_of(config, robot)
        # What a console may do depends on the broker: one adapter for each.
        key = table, robot.link if config.link(robot.link).is_broker else ""
        if key not in made:
            made[key] = KINDS[kind_of(profile)].adapter(profile, _site(config, table, robot.link))
        found[robot.name] = made[key]
    return found


def _site(config: Config, table: str, link: str) -> Site:
    return Site(
        config.ui.pose_ms,
        config.ui.status_ms,
        config.alarms.offline_after,
        table,
        {floor.name: floor.frame for floor in config.floors},
        config.link(link).role,
        f"{link_key(link)}.role",
        {one.name: (one.manufacturer, one.serial) for one in config.robots if one.link == link},
        _console(config.operator.name),
    )


def _console(operator: str) -> str:
    """Return twelve hexadecimal digits for an operator on this computer: orders of an earlier console of the
    same are not another one's."""
    return hashlib.sha256(f"{operator or os.geteuid()}@{platform.node()}".encode()).hexdigest()[:12]


def watching(config: Config) -> Config:
    """Return the same configuration for a watching console: no advertisements, no commands."""
    operator = msgspec.structs.replace(config.operator, read_only=True)
    return msgspec.structs.replace(config, operator=operator)


def feeds_of(config: Config, adapters: Mapping[str, Adapter], link: str) -> list[Feed]:
    """Return every topic of a link's robots, the most urgent of all robots first. A topic of several robots
    is one feed."""
    found: list[tuple[int, Feed]] = []
    for robot in config.robots:
        if robot.link == link:
            found += enumerate(adapters[robot.name].feeds(robot.name, config.floors_of(robot)))
    feeds: dict[str, Feed] = {}
    for _, feed in sorted(found, key=lambda ranked: ranked[0]):
        known = feeds.get(feed.address)
        shared = known is not None and known.key == feed.key
        feeds[feed.address] = feed._replace(robots=known.robots + feed.robots) if known and shared else feed
    return list(feeds.values())


def limit_of(config: Config, link: str) -> Limit:
    """Return the largest message that a link accepts."""
    return Limit(config.bridges[link].max_message_mb, f"{link_key(link)}.max_message_mb")


class Service(NamedTuple):
    """A service of a robot, and the type it must have."""

    robot: str
    type: str


def publications_of(config: Config, adapters: Mapping[str, Adapter], link: str) -> list[tuple[str, str]]:
    """Return name and type of every topic of a link on which commands are published, empty where none are
    given. A disarmed console may pause, and be armed."""
    if config.operator.read_only or config.watches:
        return []
    robots = [robot.name for robot in config.robots if robot.link == link]
    return [one for robot in robots for one in adapters[robot].publications(robot)]


def services_of(config: Config, adapters: Mapping[str, Adapter], link: str) -> dict[str, Service]:
    """Return every service of a link's robots by its name, pauses first."""
    found: list[tuple[int, str, Service]] = []
    for robot in config.robots:
        if robot.link == link:
            for rank, (_, name, type_) in enumerate(adapters[robot.name].services(robot.name)):
                found.append((rank, name, Service(robot.name, type_)))
    return {name: service for _, name, service in sorted(found, key=lambda ranked: ranked[0])}


def shared_topics(config: Config, adapters: Mapping[str, Adapter]) -> Iterator[str]:
    """Return each topic with two values, which would be ambiguous."""
    taken: dict[tuple[str, str], tuple[str, Feed]] = {}
    for robot in config.robots:
        adapter = adapters[robot.name]
        for feed in adapter.feeds(robot.name, config.floors_of(robot)):
            table, other = taken.setdefault((robot.link, feed.address), (adapter.names.table, feed))
            is_shared = feed.is_shared and (other.key, other.floor) == (feed.key, feed.floor)
            if _owner(other) != _owner(feed) and not is_shared:
                both = f"{_owner(other)} and {_owner(feed)}: add {{robot}} or {{floor}}"
                yield f"{table}.topics.{feed.key}: {feed.address} is used by {both}"


def shared_steering(config: Config, adapters: Mapping[str, Adapter]) -> Iterator[str]:
    """Return each topic on which two robots would follow what is meant for one of them."""
    taken: dict[tuple[str, str], str] = {}
    for robot in config.robots:
        names = adapters[robot.name].names
        for key in sorted(STEERING & names.vocabulary.topics.keys()):
            topic = names.topic(key, robot.name)
            other = taken.setdefault((robot.link, topic), robot.name)
            if topic and other != robot.name:
                both = f"{other} and {robot.name}: add {{robot}}"
                yield f"{names.table}.topics.{key}: {topic} moves both {both}"


def _owner(feed: Feed) -> str:
    return " ".join(part for part in (feed.key, "of", feed.robot, feed.floor) if part)
