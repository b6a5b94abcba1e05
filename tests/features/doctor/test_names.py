"""Names that were probably meant, written as the configuration wants them."""

from collections.abc import Mapping
from dataclasses import replace

from msgspec.structs import replace as altered

from fleet_tui.features.doctor.names import near_service, near_topic, robots_on, spelling_finding
from fleet_tui.links.discovery.facts import BridgeFacts, RosapiFacts, TopicFacts
from fleet_tui.robots.profile import Profile
from tests.support.bridge_facts import well, with_rosapi
from tests.support.watched_store import config_of

CONFIG = config_of("ws://site:9090", 2, 2)
WELL = well(CONFIG)
TRIGGER = "std_srvs/Trigger"


def renamed(old: str, new: str) -> tuple[TopicFacts, BridgeFacts]:
    """A topic that the bridge has under another name, and the bridge."""
    (one,) = (one for one in WELL.topics if one.topic == old)
    types = {new if name == old else name: type_ for name, type_ in WELL.rosapi.topics.items()}
    return one, with_rosapi(WELL, topics=types, publishers={})


def test_a_renamed_topic_is_proposed_as_a_line_of_the_configuration() -> None:
    one, bridge = renamed("/robot_0/battery", "/robot_0/battery_state")
    meant = 'did you mean /robot_0/battery_state? Set [profile.topics] battery = "/{robot}/battery_state"'
    assert near_topic(CONFIG, one, bridge) == meant


def test_a_renamed_floor_is_proposed_as_a_name_of_the_floor() -> None:
    one, bridge = renamed("/robot_0/floor_1/graph", "/robot_0/level_1/graph")
    assert near_topic(CONFIG, one, bridge).endswith("Rename floor floor_1 to level_1")


def test_nothing_is_proposed_where_nothing_is_near() -> None:
    one, bridge = renamed("/robot_0/battery", "/zzz")
    assert near_topic(CONFIG, replace(one, wanted=one.wanted._replace(type="x/Y")), bridge) == ""
    assert near_pause({"/robot_1/pause": TRIGGER}) == ""


def near_pause(services: Mapping[str, str]) -> str:
    rosapi = RosapiFacts(services=services)
    adapter = WELL.adapters["robot_0"]
    return near_service(adapter, "robot_0", "pause", "/robot_0/pause", TRIGGER, rosapi)


def test_a_near_service_is_proposed_for_every_robot() -> None:
    found = near_pause({"/robot_0/pause_it": TRIGGER})
    assert found == 'did you mean /robot_0/pause_it? Set [profile.services] pause = "/{robot}/pause_it"'


def test_a_service_of_another_type_is_not_proposed_however_near_its_name() -> None:
    assert near_pause({"/robot_0/pause_map": "nav_msgs/SetMap"}) == ""


def test_robots_of_a_bridge_are_found_by_the_names_of_their_topics() -> None:
    names = WELL.adapters["robot_0"].names
    assert robots_on(names, WELL.rosapi) == {"robot_0", "robot_1"}
    stranger = {"/agv_7/battery": "std_msgs/Float32", "/a/b/battery": "std_msgs/Float32"}
    assert robots_on(names, with_rosapi(WELL, topics=stranger).rosapi) == {"agv_7"}


def test_types_that_ros_2_spells_otherwise_are_written_down() -> None:
    assert spelling_finding(CONFIG, WELL) is None
    spelled = {
        name: type_.replace("OH_ressources/", "oh_ressources/msg/")
        for name, type_ in WELL.rosapi.topics.items()
    }
    found = spelling_finding(CONFIG, with_rosapi(WELL, topics=spelled))
    assert found is not None and "[profile.types] " in found.remedy
    assert 'queue = "oh_ressources/msg/' in found.remedy and "battery" not in found.remedy


def test_names_of_a_robot_without_a_namespace_are_proposed_as_they_are() -> None:
    config = altered(
        config_of("ws://site:9090"),
        profile=Profile(topics={"battery": "/battery"}, services={"pause": "/pause"}),
    )
    facts = well(config)
    (battery,) = (one for one in facts.topics if one.topic == "/battery")
    types = {"/battery_state": facts.rosapi.topics["/battery"]}
    bridge = with_rosapi(facts, topics=types, publishers={})
    meant = 'did you mean /battery_state? Set [profile.topics] battery = "/battery_state"'
    assert near_topic(config, battery, bridge) == meant
    another = {"/robot_9/queue": "OH_ressources/ActionQueue"}
    services = RosapiFacts(another, {"/pause_it": TRIGGER, "/robot_9/pause": TRIGGER})
    found = near_service(facts.adapters["robot_0"], "robot_0", "pause", "/pause", TRIGGER, services)
    assert found == 'did you mean /pause_it? Set [profile.services] pause = "/pause_it"'
    of_another = RosapiFacts(another, {"/robot_9/pause": TRIGGER})
    assert near_service(facts.adapters["robot_0"], "robot_0", "pause", "/pause", TRIGGER, of_another) == ""
