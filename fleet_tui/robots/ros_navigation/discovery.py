"""Robots of navigation stacks by their namespaces: their topics, and the floors that they are on."""

from collections.abc import Iterable, Sequence

from fleet_tui.model.order import natural
from fleet_tui.robots.discovery import Discovery, Listed
from fleet_tui.robots.ros.names import Vocabulary
from fleet_tui.robots.ros.type_names import same_type

ALONE = "robot_0"
GROUND = "floor_0"
"""The name of a robot without a namespace, and of an unnamed floor."""
MAP = "nav_msgs/OccupancyGrid"
TEXT = "std_msgs/String"


def namespaces(names: Iterable[str], ends: Iterable[str]) -> set[str]:
    """Return the namespaces, without a leading slash, of names with this ending; empty for a robot alone on
    its bridge."""
    ends = tuple(ends)
    return {name[: -len(end)].strip("/") for name in names for end in ends if name.endswith(f"/{end}")}


def of_robots(spaces: set[str]) -> list[str]:
    """Return the namespaces of robots: an empty one counts only if it is the only one."""
    return sorted(spaces - {""} or spaces, key=natural)


def found_at(spaces: Sequence[str], keys: Iterable[str], vocabulary: Vocabulary, listed: Listed) -> Discovery:
    """Name the floors, the topics with these keys, and the set-up of robots in the namespaces; of a robot
    without one everything else, too."""
    found = Discovery({space or ALONE: [] for space in spaces})
    if spaces == [""]:
        _name_without_space(found, vocabulary)
    if spaces:
        find_floors(found, spaces, listed)
        for key in keys:
            find_topic(found, key, vocabulary, spaces, listed)
        _find_sensors(found, vocabulary, spaces, listed)
        _find_services(found, vocabulary, spaces, listed)
    return found


def _name_without_space(found: Discovery, vocabulary: Vocabulary) -> None:
    """Name all topics, services and actions of a robot without a namespace."""
    for usual, names in (
        (vocabulary.topics, found.topics),
        (vocabulary.services, found.services),
        (vocabulary.actions, found.actions),
    ):
        for key, (name, _) in usual.items():
            if "/{robot}" in name:
                names[key] = name.replace("/{robot}", "")


def _templates(spaces: Sequence[str], names: Iterable[str]) -> set[str]:
    """Names in the namespaces of robots as a profile has them."""
    if spaces == [""]:
        return set(names)
    known, found = set(spaces), set[str]()
    for name in names:
        parts = name.removeprefix("/").split("/")
        cuts = [n for n in range(1, len(parts)) if "/".join(parts[:n]) in known]
        found |= {"/".join(("/{robot}", *parts[n:])) for n in cuts}
    return found


def _of_type(listed: Listed, type_: str) -> list[str]:
    return [name for name, other in listed.topics.items() if same_type(other, type_)]


def find_topic(
    found: Discovery, key: str, vocabulary: Vocabulary, spaces: Sequence[str], listed: Listed
) -> None:
    """Name a topic if it is not the usual one. One that no robot has is switched off."""
    name, type_ = vocabulary.topics[key]
    usual = name.replace("/{robot}", "") if spaces == [""] else name
    there = _templates(spaces, _of_type(listed, type_))
    there = {one for one in there if not one.endswith("/initialpose")}
    if usual in there or not there:
        chosen = usual if there else ""
    else:
        chosen = found.choose("topics", key, there, usual, type_)
        if not chosen:
            return
    if chosen != name:
        found.topics[key] = chosen
    if not there:
        found.note("topics", f"{key}: no topic of type {type_}")


def _find_sensors(found: Discovery, vocabulary: Vocabulary, spaces: Sequence[str], listed: Listed) -> None:
    """Name lasers with another name, and transforms that each robot has in its own namespace."""
    for key in ("tf", "tf_static"):
        name, type_ = vocabulary.topics[key]
        if f"/{{robot}}{name}" in _templates(spaces, _of_type(listed, type_)):
            found.topics[key] = f"/{{robot}}{name}"
    lasers = _templates(spaces, _of_type(listed, vocabulary.topics["scan"][1]))
    if lasers:
        find_topic(found, "scan", vocabulary, spaces, listed)


def _find_services(found: Discovery, vocabulary: Vocabulary, spaces: Sequence[str], listed: Listed) -> None:
    """Name services with another name than usual by their types, where a type tells what a service does."""
    # Types are asked for as far as time allows.
    untyped = _templates(spaces, (one for one, type_ in listed.services.items() if not type_))
    for key, (name, type_) in vocabulary.services.items():
        alike = (one for one, other in listed.services.items() if same_type(other, type_))
        there = _templates(spaces, alike) if name and not type_.startswith("std_srvs/") else set()
        if len(there) == 1 and found.services.get(key, name) not in there | untyped:
            found.services[key] = there.pop()


def find_floors(found: Discovery, spaces: Sequence[str], listed: Listed) -> None:
    """Find the floors: one map for all, one for each floor, or one of each robot."""
    maps = [name for name in _of_type(listed, MAP) if name.endswith("/map")]
    named = [name.split("/")[1] for name in maps if name.count("/") == 2]
    floors = sorted({one for one in named if one not in spaces}, key=natural)
    if "/map" in maps or not floors:
        floors = [GROUND]
        if "/map" not in maps:
            own = "/{robot}/map" in _templates(spaces, maps)
            found.topics["map"] = "/{robot}/map" if own else ""
    else:
        found.topics["map"] = "/{floor}/map"
    found.live_maps |= set(floors) if found.topics.get("map", "/map") else set()
    for robot in found.robots:
        found.robots[robot] = list(floors)
    _floor_topic(found, spaces, listed)


def _floor_topic(found: Discovery, spaces: Sequence[str], listed: Listed) -> None:
    there = sorted(_templates(spaces, _of_type(listed, TEXT)))
    floor_topics = [
        one for one in there if any(word in one.rpartition("/")[2] for word in ("floor", "level"))
    ]
    if len(found.floors) > 1 and floor_topics:
        found.topics["floor"] = floor_topics[0]
    elif floor_topics:
        found.note("topics", f'floor = "{floor_topics[0]}"   # if its names match [[floors]]')
    elif len(found.floors) > 1:
        found.note("topics", 'floor = "..."   # or set the floor of each robot: no topic reports it')
