"""Causes that silence several topics at once: each is listed first, its consequences are folded. Pure."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

from fleet_tui.config.schema import Config
from fleet_tui.features.doctor.managed_nodes import inactive_findings
from fleet_tui.features.doctor.names import robots_on, without_namespace
from fleet_tui.links.discovery.facts import BridgeFacts, RosapiFacts, TopicFacts
from fleet_tui.links.discovery.finding import Finding, Verdict, listed
from fleet_tui.links.discovery.tools import LOOK_FOR_NODE, SAME_GRAPH, STAYS_LISTED, named, rosapi_remedy
from fleet_tui.links.rosbridge.set_up.listeners import BRIDGE, is_bridge
from fleet_tui.model.link import ACTIONS_GLOB, SERVICES_GLOB
from fleet_tui.robots.adapter import Adapter
from fleet_tui.robots.ros.logs import NOT_ALLOWED
from fleet_tui.situation.facts import LOST_SUBSCRIPTIONS
from fleet_tui.situation.missing_packages import Listening, unsourced_package
from fleet_tui.text.units import counted

FEWEST_TOPICS = 2  # of a node that counts as silent: a single one is listed as a topic


@dataclass(frozen=True, slots=True)
class Cause:
    """A finding that explains others: `topics` and `services` it silences, `short` is its name there."""

    finding: Finding
    short: str
    topics: frozenset[str] = frozenset()
    services: frozenset[str] = frozenset()


def rosapi_finding(facts: BridgeFacts) -> Finding:
    """Judge whether types, publishers and services can be looked up at all."""
    rosapi = facts.rosapi
    if not rosapi.problem:
        counts = {"topics": len(rosapi.topics), "services": len(rosapi.services), "nodes": len(rosapi.nodes)}
        measured = ", ".join(f"{count} {what}" for what, count in counts.items())
        return Finding(facts.name, "rosapi", Verdict.OK, measured, values=counts)
    if is_half_dead(facts):
        unheard = "no reply, nor from the bridge's own node"
        return Finding(facts.name, "rosapi", Verdict.SKIPPED, unheard)
    # Its node was asked, too.
    carries = ", not rosbridge: that responds and carries commands" if rosapi.is_silent else ""
    remedy = f"{rosapi_remedy(rosapi)}{carries}"
    lost = f"{rosapi.problem}: names, types, publishers and services are unavailable"
    # Some sites run without it; one that exists and does not work is a failure.
    verdict = Verdict.WARN if rosapi.is_absent else Verdict.FAIL
    return Finding(facts.name, "rosapi", verdict, lost, f"{remedy}; topics work without it")


def is_half_dead(facts: BridgeFacts) -> bool:
    """Tell whether a bridge answers, and nothing of ROS comes through it."""
    return facts.rosapi.is_bridge_mute and not any(one.count for one in facts.topics)


def _half_dead(facts: BridgeFacts) -> Cause:
    finding = Finding(
        facts.name,
        "bridge",
        Verdict.FAIL,
        "rosbridge is half dead: no topic and no node, only the bridge itself answers",
        "restart rosbridge: its ROS thread has ended, its robots may be well",
    )
    return Cause(finding, "behind a half-dead rosbridge", frozenset(one.topic for one in facts.topics))


def causes_of(config: Config, facts: BridgeFacts) -> list[Cause]:
    """Return the faults of a bridge or a node rather than of one topic, in the order in which to fix them."""
    if is_half_dead(facts):
        return [_half_dead(facts)]
    if (elsewhere := _all_elsewhere(config, facts)) is not None:
        return [elsewhere]
    told = [*_not_allowed(facts), *_unsourced(facts)]
    told += _lost_subscriptions(facts, {topic for cause in told for topic in cause.topics})
    explained = {topic for cause in told for topic in cause.topics}
    idle = [Cause(finding, finding.measured) for finding in inactive_findings(facts)]
    return [*idle, *told, *_unregistered(config, facts), *_silent_nodes(facts, explained)]


def _not_allowed(facts: BridgeFacts) -> Iterator[Cause]:
    """Find what the allow-lists of a bridge lack."""
    offered = {name for robot, adapter in facts.adapters.items() for _, name, _ in adapter.services(robot)}
    actions = {name for robot, adapter in facts.adapters.items() for name in adapter.names.actions(robot)}
    lists = {
        "topics_glob": [one.topic for one in facts.topics if one.complaint == NOT_ALLOWED],
        SERVICES_GLOB: sorted(facts.barred & (offered | facts.answers.keys())),
        # Of a goal that any client sent within the last seconds: the doctor sends none.
        ACTIONS_GLOB: sorted(facts.barred & actions),
    }
    for glob, names in lists.items():
        if names:
            finding = Finding(
                facts.name,
                glob,
                Verdict.FAIL,
                f"the bridge does not allow {listed(names)}",
                f"add them, as by {_pattern(names)}, to {glob} of rosbridge, and restart that",
                {"names": names},
            )
            yield Cause(finding, f"not in {glob}", frozenset(names), frozenset(names))


def _lost_subscriptions(facts: BridgeFacts, explained: Collection[str]) -> Iterator[Cause]:
    """Find the topics that nodes publish and to which the bridge is not subscribed in ROS, though we are at
    the bridge."""
    rosapi = facts.rosapi
    lost = [
        one
        for one in facts.topics
        if one.is_silent
        and one.topic not in explained
        and rosapi.publishers.get(one.topic)
        and not any(map(is_bridge, rosapi.subscribers.get(one.topic, (BRIDGE,))))
    ]
    if lost and any(map(is_bridge, rosapi.nodes)):
        robots = sorted({robot for one in lost for robot in one.wanted.robots})
        topics = [one.topic for one in lost]
        finding = Finding(
            facts.name,
            "subscriptions",
            Verdict.FAIL,
            f"{LOST_SUBSCRIPTIONS.word} of {listed(robots)}: nodes publish {listed(topics)}, and it is"
            " not among their subscribers",
            LOST_SUBSCRIPTIONS.action,
            {"topics": topics},
        )
        yield Cause(finding, "rosbridge lost its subscription", frozenset(topics))


def _pattern(names: Sequence[str]) -> str:
    """Return patterns of an allow-list that admit the names: all of a robot, or one without a namespace."""
    first = (name[1:].partition("/") for name in names)
    return listed(list(dict.fromkeys(f"/{space}/*" if rest else f"/{space}" for space, _, rest in first)))


def _all_elsewhere(config: Config, facts: BridgeFacts) -> Cause | None:
    """Find a bridge that sees none of its robots, nor any that could be one of them."""
    robots = [robot.name for robot in config.robots if facts.of(robot.name)]
    if not robots or any(map(facts.knows, robots)):
        return None
    if any(robots_on(facts.adapters[name].names, facts.rosapi) - {*robots} for name in robots):
        return None
    names = frozenset(one.topic for one in facts.topics)
    finding = Finding(
        facts.name,
        "robots",
        Verdict.FAIL,
        f"none of the {counted(len(robots), 'robot')} is on this bridge: {listed(robots)}",
        named(SAME_GRAPH, facts.rosapi.ros),
        {"robots": robots},
    )
    return Cause(finding, "no robot on this bridge", names)


def namespace_finding(facts: BridgeFacts) -> Finding | None:
    """Return what is told of a robot without a namespace that nobody configured."""
    asked = {one.topic for one in facts.topics}
    for adapter in facts.adapters.values():
        topics = without_namespace(adapter.names, facts.rosapi)
        if topics and asked.isdisjoint(topics):
            measured = f"a robot without a namespace is on this bridge, too: {listed(topics)}"
            remedy = "fleet-tui config init writes its names; or start it in a namespace of its own"
            return Finding(facts.name, "namespace", Verdict.WARN, measured, remedy, {"topics": topics})
    return None


def _unregistered(config: Config, facts: BridgeFacts) -> Iterator[Cause]:
    """Find robots lost in a restart of the ROS master: their topics continue between nodes already
    connected."""
    if facts.rosapi.problem:
        return
    received = {one.wanted.robot for one in facts.topics if one.count and not one.wanted.is_shared}
    robots = [robot.name for robot in config.robots if robot.name in received]
    robots = [robot for robot in robots if not _has_services(facts.adapters[robot], robot, facts.rosapi)]
    if not robots:
        return
    services = (name for robot in robots for _, name, _ in facts.adapters[robot].services(robot))
    yield Cause(
        Finding(
            facts.name,
            "nodes",
            Verdict.FAIL,
            "robot nodes not registered: restart them"
            f" (topics of {listed(robots)} arrive, but none of their services exist)",
            f"check them with {named(LOOK_FOR_NODE, 2)}"
            if facts.rosapi.ros == 2
            else "nodes started before a ROS master restart are unknown to the new master",
        ),
        "robot nodes not registered",
        services=frozenset(services),
    )


def _has_services(adapter: Adapter, robot: str, rosapi: RosapiFacts) -> bool:
    """Tell whether a robot has services by the names of the profile, or others: those are listed one by
    one."""
    known = {name for _, name, _ in adapter.services(robot)}
    return not known or any(
        service in known or service.startswith(f"/{robot}/") for service in rosapi.services
    )


def _silent_nodes(facts: BridgeFacts, explained: Collection[str]) -> Iterator[Cause]:
    """Find nodes that are registered but silent. A robot all of whose nodes are silent is listed as a
    robot."""
    live = [one for one in facts.topics if not one.wanted.floor]
    awake = {one.wanted.robot for one in live if one.count}
    of_node: dict[str, list[TopicFacts]] = {}
    for one in facts.topics:
        if (one.count or one.is_silent) and one.topic not in explained:
            for node in facts.rosapi.publishers.get(one.topic, ()):
                of_node.setdefault(node, []).append(one)
    for node, topics in of_node.items():
        robots = list(dict.fromkeys(one.wanted.robot for one in topics))
        if any(one.count for one in topics) or len(topics) < FEWEST_TOPICS:
            continue
        if len(robots) > 1 or robots[0] in awake:
            yield _silent_node(facts, node, topics, robots)


def _silent_node(facts: BridgeFacts, node: str, topics: list[TopicFacts], robots: list[str]) -> Cause:
    names = [one.topic for one in topics]
    waited = max(one.waited for one in topics)
    look = named(LOOK_FOR_NODE, facts.rosapi.ros, node)
    return Cause(
        Finding(
            robots[0] if len(robots) == 1 else facts.name,
            "node",
            Verdict.FAIL,
            f"{node} silent: no messages in {waited:.1f} s on the {len(names)} topics it publishes:"
            f" {listed(names)}",
            f"check that it runs ({look}), or restart it{STAYS_LISTED.get(facts.rosapi.ros, '')}",
            {"node": node, "topics": len(names)},
        ),
        f"node {node} silent",
        frozenset(names),
        frozenset(service for service, owner in facts.rosapi.owners.items() if owner == node),
    )


def _unsourced(facts: BridgeFacts) -> Iterator[Cause]:
    rosapi = facts.rosapi
    listened = [one for one in facts.topics if one.count or one.is_silent]
    package = unsourced_package(
        Listening(one.wanted.robot, _type(facts, one), _publishers(facts, one), bool(one.count))
        for one in listened
    )
    if package is None:
        return
    silent = [one for one in listened if one.is_silent and _type(facts, one).startswith(f"{package}/")]
    names = frozenset(one.topic for one in silent)
    nodes = sorted({node for name in names for node in rosapi.publishers.get(name, ())})
    by = f", published by {listed(nodes)}" if nodes else ""
    remedy = f"source the workspace with {package}, then restart rosbridge"
    if rosapi.problem and package != package.lower():
        remedy += f"; on ROS 2 the package is {package.lower()}: set [profile.types]"
    said = next((f"; rosbridge: {one.complaint}" for one in silent if one.complaint), "")
    yield Cause(
        Finding(
            facts.name,
            "messages",
            Verdict.FAIL,
            f"the bridge lacks {package}: no messages on {listed(sorted(names))}{by}; other topics"
            f" of the same robots arrive{said}",
            remedy,
            {"package": package, "topics": len(names)},
        ),
        f"the bridge lacks {package}",
        names,
    )


def _type(facts: BridgeFacts, one: TopicFacts) -> str:
    return facts.rosapi.topics.get(one.topic) or one.wanted.type


def _publishers(facts: BridgeFacts, one: TopicFacts) -> int | None:
    nodes = facts.rosapi.publishers.get(one.topic)
    return None if nodes is None else len(nodes)
