"""Names similar to a missing one, and names that ROS 2 spells otherwise. Pure."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import replace

from fleet_tui.config.schema import Config
from fleet_tui.links.discovery.facts import BridgeFacts, RosapiFacts, TopicFacts
from fleet_tui.links.discovery.finding import Finding, Verdict, listed, nearest
from fleet_tui.robots.adapter import Adapter
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.names import Names
from fleet_tui.robots.ros.type_names import plain_type, same_type


def robots_on(names: Names, rosapi: RosapiFacts) -> set[str]:
    """Return the names in place of a robot's in the topics that are published on a bridge."""
    found = set[str]()
    for topic in filter(rosapi.has, rosapi.topics):
        for key in names.vocabulary.topics.keys() - names.vocabulary.floor_topics:
            before, mark, after = names.topic(key, "{robot}").partition("{robot}")
            name = topic[len(before) : len(topic) - len(after)] if mark else ""
            if name and topic == before + name + after and "/" not in name:
                found.add(name)
    return found


def without_namespace(names: Names, rosapi: RosapiFacts) -> list[str]:
    """Return the topics of a robot of this kind that has no namespace, none if there is no such robot."""
    bare = {
        key: template.removeprefix("/{robot}")
        for key, (template, _) in names.vocabulary.topics.items()
        if template.startswith("/{robot}/") and key not in names.vocabulary.floor_topics
    }
    found = {
        key: topic
        for key, topic in bare.items()
        if rosapi.has(topic) and same_type(rosapi.topics.get(topic, ""), names.type(key))
    }
    return list(found.values()) if found.keys() & {"pose", "odometry"} and len(found) > 1 else []


def near_topic(config: Config, facts: TopicFacts, bridge: BridgeFacts) -> str:
    """Return the published names of its type that a topic may have now, as written in the config."""
    wanted, types = facts.wanted, bridge.rosapi.topics
    free = set(filter(bridge.rosapi.has, types)) - {one.topic for one in bridge.topics}
    fitting = [topic for topic in free if same_type(types[topic], wanted.type)]
    own = _own(bridge.adapters[wanted.robot].names, wanted.robot, facts.topic, fitting, bridge.rosapi)
    near = nearest(facts.topic, own) or nearest(facts.topic, fitting)
    if not near:
        return ""
    meant = f"did you mean {listed(near)}?"
    if near[0] not in own:
        return meant
    floor = _floor_in(bridge.adapters[wanted.robot].names, facts, near[0])
    if floor:
        return f"{meant} Rename floor {wanted.floor} to {floor}"
    template = near[0].replace(f"/{wanted.robot}/", "/{robot}/").replace(f"/{wanted.floor}/", "/{floor}/")
    return f'{meant} Set [{bridge.table(wanted.robot)}.topics] {wanted.key} = "{template}"'


def _own(names: Names, robot: str, missing: str, there: Iterable[str], rosapi: RosapiFacts) -> list[str]:
    """Return the names that may be a robot's in place of a missing one: in its namespace; of one without a
    namespace those outside all others."""
    space = f"/{robot}/"
    if missing.startswith(space):
        return [name for name in there if name.startswith(space)]
    others = robots_on(replace(names, profile=Profile()), rosapi)
    return [name for name in there if name.split("/")[1] not in others]


def _floor_in(names: Names, facts: TopicFacts, topic: str) -> str:
    """Return the floor of this topic, "" if its name does not match."""
    if not facts.wanted.floor:
        return ""
    before, _, after = names.topic(facts.wanted.key, facts.wanted.robot, "{floor}").partition("{floor}")
    found = re.fullmatch(f"{re.escape(before)}([^/]+){re.escape(after)}", topic)
    return found.group(1) if found else ""


def near_service(
    adapter: Adapter, robot: str, key: str, service: str, expected: str, rosapi: RosapiFacts
) -> str:
    """Return the name that a robot's service may have now, as written in the profile's table: one of its
    type."""
    own = {name for _, name, _ in adapter.services(robot)}
    fitting = (
        name
        for name, type_ in rosapi.services.items()
        if name not in own and same_type(type_ or "", expected)
    )
    near = nearest(service, _own(adapter.names, robot, service, fitting, rosapi), 1)
    if not near:
        return ""
    template = near[0].replace(f"/{robot}/", "/{robot}/")
    return f'did you mean {near[0]}? Set [{adapter.names.table}.services] {key} = "{template}"'


def spelling_finding(config: Config, facts: BridgeFacts) -> Finding | None:
    """Return the types to write if ROS 2 spells them otherwise: lower-case packages, CamelCase names.

    With rosapi the bridge's spelling is detected; without it the profile's is used to subscribe.
    """
    rosapi = facts.rosapi
    asked = [(one.wanted.key, one.topic, one.wanted.type) for one in facts.topics]
    topics = _spelled(asked, rosapi.topics)
    called = [
        service
        for robot in dict.fromkeys(one.wanted.robot for one in facts.topics)
        for service in facts.adapters[robot].services(robot)
    ]
    services = _spelled(called, rosapi.services)
    written = [
        f"[profile.{table}] " + ", ".join(f'{key} = "{type_}"' for key, type_ in found.items())
        for table, found in (("types", topics), ("service_types", services))
        if found
    ]
    if not written:
        return None
    measured = f"those of {listed([*topics, *services])} use ROS 2 spelling: found only while rosapi responds"
    return Finding(facts.name, "types", Verdict.WARN, measured, "; ".join(written))


def _spelled(wanted: Iterable[tuple[str, str, str]], there: Mapping[str, str | None]) -> dict[str, str]:
    """Return by key the types that match the expected ones except for their spelling."""
    return {
        key: found
        for key, name, expected in wanted
        if (found := there.get(name))
        and same_type(found, expected)
        and plain_type(found) != plain_type(expected)
    }
