"""These robots and their floors, recognised by the names and types of topics and services."""

from collections import defaultdict
from collections.abc import Collection, Iterator, Mapping, Sequence

from fleet_tui.model.order import natural
from fleet_tui.robots.discovery import Discovery, Listed
from fleet_tui.robots.oh_ressources.vocabulary import VOCABULARY
from fleet_tui.robots.ros.set_up import names as set_up
from fleet_tui.robots.ros.set_up.discovery import find_set_up
from fleet_tui.robots.ros.type_names import plain_type, same_type

FLOOR_TOPICS = VOCABULARY.floor_topics
SENT = {"goal", "goal_cancel", "graph_save", "labels_save", *set_up.TOPICS}
"""Topics of set-up, and those on which nothing but a console publishes."""
TOPICS = {key: named for key, named in VOCABULARY.topics.items() if key not in SENT}
SERVICES = {key: named for key, named in VOCABULARY.services.items() if key not in set_up.SERVICES}
"""Those of every such robot: what set-up uses is named in a profile."""
QUEUE = TOPICS["queue"][1]
POSE = TOPICS["pose"][1]
PAUSED = "{robot}/paused"
# Types whose one field is read alike.
ALIKE = {"std_msgs/Float32": ("std_msgs/Float64",)}
Below = Mapping[tuple[str, str], Sequence[str]]
"""The rest of the names in the namespaces of robots, by robot and type."""


def discover(listed: Listed) -> Discovery:
    """Recognise these robots among the names that a bridge lists."""
    topics, other_types = _as_usual(listed.topics, TOPICS)
    services, other_service_types = _as_usual(listed.services, SERVICES)
    robots, is_guess = _robots(topics)
    site = Discovery({robot: [] for robot in robots}, is_guess=is_guess)
    site.types |= other_types
    site.service_types |= other_service_types
    below = _below(robots, topics)
    for robot, floors in site.robots.items():
        floors += dict.fromkeys(_floors(robot, below))
    for key in TOPICS:
        _topic(site, key, topics, below)
    of_services = _below(robots, services)
    for key in SERVICES:
        _service(site, key, services, of_services)
    find_set_up(site, listed, VOCABULARY)
    all_floors = set(site.floors)
    for name, type_ in topics.items():
        if type_ == TOPICS["map"][1]:
            site.live_maps |= all_floors.intersection(name.split("/")[1:-1])
    return site


def _as_usual(
    there: Mapping[str, str], usual: Mapping[str, tuple[str, str]]
) -> tuple[dict[str, str], dict[str, str]]:
    """Return names and types with the types spelled as by default, and by key the local spelling if ROS 2
    differs."""
    found, spelled = dict[str, str](), dict[str, str]()
    for name, type_ in there.items():
        keys = [key for key, (_, known) in usual.items() if same_type(type_, known)]
        found[name] = usual[keys[0]][1] if keys else plain_type(type_)
        if keys and plain_type(type_) != found[name]:
            spelled |= dict.fromkeys(keys, type_)
    return found, spelled


def _robots(topics: Mapping[str, str]) -> tuple[list[str], bool]:
    """Return the namespaces with a queue; if there are none, as a guess, those with poses."""
    for type_ in (QUEUE, POSE):
        found = [name.strip("/").split("/") for name, other in topics.items() if other == type_]
        found = [parts for parts in found if len(parts) > 1]
        first = {parts[0] for parts in found}
        # All of them below one name, like /site/robot_1/queue: a robot's name may have a slash.
        depth = (
            2 if len(first) == 1 and len({tuple(parts[:2]) for parts in found if len(parts) > 2}) > 1 else 1
        )
        robots = {"/".join(parts[:depth]) for parts in found if len(parts) > depth}
        if robots:
            return sorted(robots, key=natural), type_ == POSE
    return [], True


def _below(robots: Collection[str], topics: Mapping[str, str]) -> Below:
    """Look up the names of topics or services once for all robots, however many there are."""
    found, known = defaultdict[tuple[str, str], list[str]](list), set(robots)
    for name, type_ in topics.items():
        parts = name.removeprefix("/").split("/", 2)
        for n in range(1, len(parts)):
            if (robot := "/".join(parts[:n])) in known:
                found[robot, type_].append("/".join(parts[n:]))
    return found


def _floors(robot: str, below: Below) -> Iterator[str]:
    """The floors for which a robot gives graphs, labels or maps."""
    for key in ("graph", "labels", "map_metadata", "map"):
        for rest in below.get((robot, TOPICS[key][1]), ()):
            if rest.count("/") == 1:
                yield rest.partition("/")[0]


def _templates(site: Discovery, key: str, below: Below) -> dict[str, int]:
    """Return every template by which topics of a key's type can be named, with its number of robots."""
    found = dict[str, int]()
    for robot, floors in site.robots.items():
        rests, known = set[str](), set(floors)
        for rest in below.get((robot, TOPICS[key][1]), ()):
            first, slash, after = rest.partition("/")
            is_of_floor = bool(slash) and first in known
            if is_of_floor == (key in FLOOR_TOPICS):
                rests.add(f"{{floor}}/{after}" if is_of_floor else rest)
        for rest in rests:
            found["/{robot}/" + rest] = found.get("/{robot}/" + rest, 0) + 1
    return found


def _topic(site: Discovery, key: str, topics: Mapping[str, str], below: Below) -> None:
    found, (usual, type_) = _templates(site, key, below), TOPICS[key]
    if key == "paused":
        if f"/{PAUSED}" in found:
            site.topics[key] = f"/{PAUSED}"
    elif usual not in found and not _alike(site, key, topics):
        known = {TOPICS[other][0] for other in TOPICS} | set(site.topics.values()) | {f"/{PAUSED}"}
        chosen = site.choose("topics", key, [one for one in found if one not in known], usual, type_)
        if chosen:
            site.topics[key] = chosen


def _alike(site: Discovery, key: str, topics: Mapping[str, str]) -> bool:
    """Tell whether a topic exists under its usual name with a type that is read alike."""
    for robot, floors in site.robots.items():
        for floor in floors if key in FLOOR_TOPICS else [""]:
            there = topics.get(TOPICS[key][0].replace("{robot}", robot).replace("{floor}", floor))
            if there in ALIKE.get(TOPICS[key][1], ()):
                site.types[key] = str(there)
                return True
    return False


def _service(site: Discovery, key: str, services: Mapping[str, str], below: Below) -> None:
    usual, type_ = SERVICES[key]
    there = {services[name] for robot in site.robots if (name := usual.replace("{robot}", robot)) in services}
    if there:
        if type_ not in there and there != {""}:
            site.note("service_types", f'{key} = "{min(there)}"   # if the fields match')
        return
    found = {"/{robot}/" + rest for robot in site.robots for rest in below.get((robot, type_), ())}
    known = {template for template, _ in SERVICES.values()} | set(site.services.values())
    if chosen := site.choose("services", key, found - known, usual, type_):
        site.services[key] = chosen
