"""The configured topics of a bag, and notes on the others."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.schema import Config
from fleet_tui.features.recording.bags.opening import Bag, BagError
from fleet_tui.robots.adapter import Adapter, Feed
from fleet_tui.robots.ros.type_names import plain_type, type_problem
from fleet_tui.state.reducer import LIVE_MAPS_KEPT
from fleet_tui.text.errors import did_you_mean
from fleet_tui.text.language import Message
from fleet_tui.text.limits import LONGEST_NAME, truncate

NAMED = 5
"""Maximum topics or robots that a message names; the number of others follows."""

ByTopic = dict[str, list[tuple[str, Feed]]]
"""The users of each topic: a link, and its feed."""


@dataclass
class Chosen:
    """The connections to read, the users of each topic, by link, and notes for a person. `refused` are topics
    of another type, by robot."""

    connections: list[Any] = field(default_factory=list)
    by_topic: ByTopic = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    refused: list[tuple[str, str]] = field(default_factory=list)


def choose(bag: Bag, config: Config) -> Chosen:
    """Return the selection from a bag. Raises BagError if that is empty."""
    adapters = adapters_of(config)
    wanted = _wanted(config, adapters)
    there = {one.topic: plain_type(one.msgtype) for one in bag.connections}
    if not there:
        raise BagError(Message("{path}: empty: no topics in it", path=bag.path))
    if not wanted:
        raise BagError(Message("no robots in the configuration: add [[robots]]"))
    chosen = Chosen(by_topic={topic: ones for topic, ones in wanted.items() if topic in there})
    for connection in bag.connections:
        _take(chosen, connection, adapters)
    _leave_maps(chosen)
    if not chosen.connections:
        raise BagError(Message("{path}: {nothing}", path=bag.path, nothing=_nothing(chosen, wanted, there)))
    chosen.notes += [*_absent(config, wanted, there), *_missing(wanted, there), *_unasked(wanted, there)]
    return chosen


def _wanted(config: Config, adapters: Mapping[str, Adapter]) -> ByTopic:
    found: ByTopic = {}
    for link in config.bridges:
        for one in feeds_of(config, adapters, link):
            found.setdefault(one.address, []).append((link, one))
    return found


def _take(chosen: Chosen, connection: Any, adapters: Mapping[str, Adapter]) -> None:
    for _, one in chosen.by_topic.get(connection.topic, ()):
        problem = type_problem(one, {connection.topic: connection.msgtype}, adapters[one.robot].names.table)
        if problem:
            chosen.refused.append((one.robot, truncate(problem)))
            chosen.notes.append(truncate(problem))
        elif chosen.connections[-1:] != [connection]:
            chosen.connections.append(connection)


def _leave_maps(chosen: Chosen) -> None:
    """Drop live maps above the state's limit, since a bag's can't be requested again: the first ones stay."""
    taken = {connection.topic for connection in chosen.connections}
    maps = [
        topic
        for topic, ones in chosen.by_topic.items()
        if topic in taken and any(one.large for _, one in ones)
    ]
    left = maps[LIVE_MAPS_KEPT:]
    if left:
        chosen.connections = [one for one in chosen.connections if one.topic not in left]
        chosen.notes.append(f"{LIVE_MAPS_KEPT} of {len(maps)} live maps read, not {_some(left)}")


def _nothing(chosen: Chosen, wanted: ByTopic, there: Mapping[str, str]) -> str:
    if chosen.notes:
        return f"nothing readable in it: {chosen.notes[0]}"
    first = next(iter(wanted.values()))[0][1]
    return (
        f"none of the configured topics is in the bag: not {first.address}{_near(first, there)};"
        f" it has {_some(there)}: correct [profile.topics] or [[robots]]"
    )


def _near(wanted: Feed, others: Mapping[str, str]) -> str:
    """Return a topic of that type that may be the intended one."""
    kind = plain_type(wanted.type)
    return did_you_mean(wanted.address, [topic for topic, of in others.items() if of == kind])


def _absent(config: Config, wanted: ByTopic, there: Mapping[str, str]) -> list[str]:
    """Return a note on the robots without any topic."""
    present = _present(wanted, there)
    absent = [robot.name for robot in config.robots if robot.name not in present]
    return [f"not in the bag: {_some(absent)}"] if absent else []


def _present(wanted: ByTopic, there: Mapping[str, str]) -> set[str]:
    return {one.robot for topic, ones in wanted.items() if topic in there for _, one in ones}


def _missing(wanted: ByTopic, there: Mapping[str, str]) -> list[str]:
    """Return the missing topics of the other robots."""
    present = _present(wanted, there)
    others = {topic: kind for topic, kind in there.items() if topic not in wanted}
    missing = [one for topic, ((_, one), *_) in wanted.items() if topic not in there and one.robot in present]
    named = [one.address + _near(one, others) for one in missing[:NAMED]]
    rest = [one.address for one in missing[NAMED:]]
    return [f"not in the bag: {_some([*named, *rest])} (correct [profile.topics])"] if missing else []


def _unasked(wanted: ByTopic, there: Mapping[str, str]) -> list[str]:
    others = [topic for topic in there if topic not in wanted]
    return [f"in the bag, not used: {_some(others)}"] if others else []


def _some(names: Iterable[str]) -> str:
    found = list(names)
    more = f" and {len(found) - NAMED} more" if len(found) > NAMED else ""
    return ", ".join(truncate(name, LONGEST_NAME) for name in found[:NAMED]) + more
