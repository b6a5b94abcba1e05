"""Robots with Nav2, recognised by their action servers, else by services or topics that only they have."""

from collections.abc import Iterable, Sequence

from fleet_tui.adapters.discovery import Discovery, Listed, natural
from fleet_tui.adapters.nav2.vocabulary import ACTIONS, VOCABULARY
from fleet_tui.adapters.ros.type_names import same_type

DRIVES = ("navigate_to_pose", "navigate_through_poses", "follow_waypoints")
IS_ACTIVE = VOCABULARY.services["is_active"][0].replace("/{robot}", "")
ONE_BY_ONE = ("odometry", "pose", "battery", "blocked")
"""Topics of one robot."""
ALONE, GROUND = "robot_0", "floor_0"
"""The name of a robot without a namespace, and of a floor that nothing names."""
MAP, TEXT = VOCABULARY.topics["map"][1], "std_msgs/String"


def discover(listed: Listed) -> Discovery:
    """Recognise these robots among what a bridge lists."""
    spaces = _namespaces(listed)
    found = Discovery({space or ALONE: [] for space in spaces})
    if spaces:
        _floors(found, spaces, listed)
        for key in ONE_BY_ONE:
            _topic(found, key, spaces, listed)
        if spaces == [""]:
            found.actions |= {key: f"/{key}" for key in ACTIONS}
            found.services["is_active"] = IS_ACTIVE
    return found


def _namespaces(listed: Listed) -> list[str]:
    """The namespaces of robots without a leading slash; empty is that of a robot alone on its bridge."""
    by_action = {
        space for name in listed.actions for key in DRIVES if (space := _before(name, key)) is not None
    }
    by_service = {space for name in listed.services if (space := _before(name, IS_ACTIVE[1:])) is not None}
    by_topic = _with(listed, "pose") & _with(listed, "odometry")
    spaces = by_action or by_service or by_topic
    return sorted(spaces - {""} or spaces, key=natural)


def _before(name: str, end: str) -> str | None:
    """The namespace in which a name ends so, None where it does not."""
    return name[: -len(end)].strip("/") if name.endswith(f"/{end}") else None


def _with(listed: Listed, key: str) -> set[str]:
    """The namespaces with a topic of this name and type. On ROS 1 the same names are another kind's."""
    name, type_ = VOCABULARY.topics[key]
    end = name.rpartition("/")[2]
    return {
        space
        for topic, other in listed.topics.items()
        if "/msg/" in other and same_type(other, type_) and (space := _before(topic, end)) is not None
    }


def _templates(spaces: Sequence[str], names: Iterable[str]) -> set[str]:
    """Names in the namespaces of robots as a profile has them."""
    if spaces == [""]:
        return set(names)
    return {
        f"/{{robot}}/{name.removeprefix(f'/{space}/')}"
        for name in names
        for space in spaces
        if name.startswith(f"/{space}/")
    }


def _of_type(listed: Listed, type_: str) -> list[str]:
    return [name for name, other in listed.topics.items() if same_type(other, type_)]


def _topic(found: Discovery, key: str, spaces: Sequence[str], listed: Listed) -> None:
    """Name a topic where it is not the usual one. One that no robot has is switched off."""
    name, type_ = VOCABULARY.topics[key]
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
        found.note("topics", f"{key}: nothing of type {type_} is there")


def _floors(found: Discovery, spaces: Sequence[str], listed: Listed) -> None:
    """One map for all, one for each floor, or one of each robot."""
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
    told = [one for one in there if any(word in one.rpartition("/")[2] for word in ("floor", "level"))]
    if len(found.floors) > 1 and told:
        found.topics["floor"] = told[0]
    elif told:
        found.note("topics", f'floor = "{told[0]}"   # if it names the floor as [[floors]] does')
    elif len(found.floors) > 1:
        found.note("topics", 'floor = "..."   # or give each robot its floor: nothing tells where one is')
