"""Causes that silence several topics at once: each is said first, what follows from it is folded. Pure."""

from collections.abc import Iterator
from dataclasses import dataclass

from fleet_tui.headless.doctor.facts import BridgeFacts, TopicFacts
from fleet_tui.headless.doctor.finding import Finding, Verdict, listed
from fleet_tui.model.sourcing import Listening, unsourced_package


@dataclass(frozen=True, slots=True)
class Cause:
    """A finding that explains others: `topics` and `services` it silences, `short` names it there."""

    finding: Finding
    short: str
    topics: frozenset[str] = frozenset()
    services: frozenset[str] = frozenset()


def causes_of(facts: BridgeFacts) -> list[Cause]:
    """What is wrong with a bridge or a node rather than with one topic, in the order in which to mend it."""
    return list(_unsourced(facts))


def _unsourced(facts: BridgeFacts) -> Iterator[Cause]:
    rosapi = facts.rosapi
    listened = [one for one in facts.topics if one.is_silent or one.count]
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
    yield Cause(
        Finding(
            facts.name,
            "messages",
            Verdict.FAIL,
            f"the bridge does not know {package}: nothing comes on {listed(sorted(names))}{by}; other topics"
            " of the same robots come",
            f"source the workspace that has {package} before starting rosbridge, and restart it so",
            {"package": package, "topics": len(names)},
        ),
        f"the bridge does not know {package}",
        names,
    )


def _type(facts: BridgeFacts, one: TopicFacts) -> str:
    return facts.rosapi.topics.get(one.topic) or one.wanted.subscription.type


def _publishers(facts: BridgeFacts, one: TopicFacts) -> int | None:
    nodes = facts.rosapi.publishers.get(one.topic)
    return None if nodes is None else len(nodes)
