"""Which topics are wanted from a bridge, and whose they are."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from fleet_tui.adapters.interface import Interface, TopicKind
from fleet_tui.adapters.ros.operations import Subscription
from fleet_tui.adapters.ros.type_names import same_type
from fleet_tui.config.profile import SERVICES, Profile
from fleet_tui.config.schema import Config, RobotEntry


@dataclass(frozen=True, slots=True)
class Wanted:
    """One topic of one robot, on one floor where there is one for each."""

    kind: TopicKind
    robot: str
    floor: str
    subscription: Subscription


def wanted_topics(config: Config, interface: Interface, link: str) -> Iterator[Wanted]:
    """Every topic of a bridge's robots, the most urgent kind first and within it robot by robot."""
    robots = [robot for robot in config.robots if robot.link == link]
    for kind in interface.topics:
        for robot in robots:
            for floor in config.floors_of(robot) if kind.per_floor else [""]:
                topic = config.profile.topic(kind.key, robot.name, floor)
                if topic:
                    yield Wanted(kind, robot.name, floor, _subscription(config, kind, robot, topic))


def _subscription(config: Config, kind: TopicKind, robot: RobotEntry, topic: str) -> Subscription:
    rate = 0
    if not kind.per_floor:
        rate = config.ui.pose_ms if kind.fast else config.ui.status_ms
    compression = "cbor" if kind.heavy else "none"
    return Subscription(topic, config.profile.type(kind.key), rate, compression)


def type_problem(wanted: Wanted, types: Mapping[str, str], profile: Profile) -> str:
    """Why a topic must not be subscribed: with a wrong type it would be lost for every client."""
    found = types.get(wanted.subscription.topic)
    if found is None or same_type(found, wanted.subscription.type):
        return ""
    return (
        f"{wanted.subscription.topic} has type {found}, not {wanted.subscription.type}:"
        f" correct profile.topics.{wanted.kind.key} or profile.types.{wanted.kind.key}"
    )


@dataclass(frozen=True, slots=True)
class WantedService:
    """One service of one robot, and the type it must have."""

    robot: str
    type: str


def wanted_services(config: Config, link: str) -> dict[str, WantedService]:
    """Every service of a bridge's robots by its name, pauses first."""
    robots = [robot.name for robot in config.robots if robot.link == link]
    keys = sorted(SERVICES, key=lambda key: key != "pause")
    return {
        config.profile.service(key, robot): WantedService(robot, config.profile.service_type(key))
        for key in keys
        for robot in robots
    }
