"""Fleets are found in messages, not by names of topics."""

from fleet_tui.robots.discovery import Listed
from fleet_tui.robots.rmf.discovery import discover
from fleet_tui.robots.rmf.vocabulary import VOCABULARY
from tests.support.rmf import member, text

TYPES = {topic: type_.replace("/", "/msg/") for topic, type_ in VOCABULARY.topics.values()}
STATE = {"name": "tiny", "robots": [member("t1"), member("t 2")]}
SLASHED = {"name": "a/b", "robots": [member("c")]}
PLACE = {"map": "L1", "x": 0.0, "y": 0.0, "yaw": 0.0}
UPDATE = text({"data": {"name": "carrier", "robots": {"c1": {"location": PLACE}, "c2": {}}}})
GRAPH = {
    "name": "tiny",
    "vertices": [{"x": 0.0, "y": 0.0, "name": "", "params": [{"name": "map_name", "value_string": "L3"}]}],
    "edges": [],
}
MESSAGES: dict[str, tuple[object, ...]] = {
    "/fleet_states": (STATE, {"odd": 1}, SLASHED),
    "/fleet_state_update": (UPDATE, {"data": "{"}),
    "/nav_graphs": (GRAPH, {}),
}


def test_topics_name_no_robot() -> None:
    assert not discover(Listed(TYPES, {})).robots


def test_messages_name_robots_of_all_fleets_and_the_levels() -> None:
    found = discover(Listed(TYPES, {}, messages=MESSAGES))
    floors = ["L1", "L2", "L3"]
    assert found.robots == dict.fromkeys(("carrier/c1", "carrier/c2", "tiny/t1"), floors)
    assert found.live_maps == set(floors) and not found.topics
    assert found.notes["topics"] == [
        "'a/b/c' can't be a robot name here: its fleet's name contains a /",
        "'tiny/t 2' can't be a robot name here: letters, digits and ./_- only",
    ]


def test_topics_that_are_missing_or_another_stacks_are_switched_off() -> None:
    types = {**TYPES, "/map": "nav_msgs/msg/OccupancyGrid"}
    del types["/nav_graphs"]
    found = discover(Listed(types, {}, messages=MESSAGES))
    assert found.topics == {"graphs": "", "building": ""} and not found.live_maps
