"""Every topic and service of the robots' interface under its name, and each can be renamed."""

import pytest

from fleet_tui.robots.oh_ressources.vocabulary import VOCABULARY
from fleet_tui.robots.profile import Profile
from tests.support.adapters import names_of

TOPICS, SERVICES = VOCABULARY.topics, VOCABULARY.services
FIELDS = {f"{message}.{field}" for message, fields in VOCABULARY.fields.items() for field in fields}

# As the robots' interface is written down.
PROMISED = {
    "map_metadata": ("/r/f/map_metadata", "nav_msgs/MapMetaData"),
    "map": ("/r/f/map", "nav_msgs/OccupancyGrid"),
    "labels": ("/r/f/labeled_vertices", "OH_ressources/LabeledVertices"),
    "graph": ("/r/f/graph", "OH_ressources/Graph"),
    "pose": ("/r/pose", "geometry_msgs/PoseStamped"),
    "cargo": ("/r/cargo", "std_msgs/Bool"),
    "battery": ("/r/battery", "std_msgs/Float32"),
    "obstacle": ("/r/obstacle", "std_msgs/Float32"),
    "queue": ("/r/queue", "OH_ressources/ActionQueue"),
    "paused": ("", "std_msgs/Bool"),
    "goal": ("", "geometry_msgs/PoseStamped"),
    "goal_cancel": ("", "actionlib_msgs/GoalID"),
    "initial_pose": ("", "geometry_msgs/PoseWithCovarianceStamped"),
    "scan": ("", "sensor_msgs/LaserScan"),
    "camera": ("", "sensor_msgs/CompressedImage"),
    "path": ("", "nav_msgs/Path"),
    "tf_static": ("/tf_static", "tf2_msgs/TFMessage"),
    "mode": ("", "std_msgs/String"),
    "drive": ("", "geometry_msgs/Twist"),
    "graph_save": ("", "OH_ressources/Graph"),
    "labels_save": ("", "OH_ressources/LabeledVertices"),
}
CALLED = {
    "order": "Execute_order",
    "order_with_cargo": "Execute_order_with_cargo",
    "cancel": "Cancel_order",
    "clear": "Clear_orders",
    "resume": "Resume",
    "pause": "Pause",
}


def test_topics_have_the_promised_names_and_types() -> None:
    names = names_of()
    assert {key: (names.topic(key, "r", "f"), names.type(key)) for key in TOPICS} == PROMISED


def test_services_have_the_promised_names() -> None:
    assert {key: names_of().service(key, "r") for key in SERVICES} == {
        key: f"/r/Application_layout/{name}" for key, name in CALLED.items()
    } | dict.fromkeys(("localise", "settle", "mapping_on", "mapping_off", "map_save", "map_pose_graph"), "")


@pytest.mark.parametrize("key", list(TOPICS))
def test_every_topic_and_type_can_be_renamed(key: str) -> None:
    names = names_of(Profile(topics={key: "/x/{robot}/y"}, types={key: "a/B"}))
    assert (names.topic(key, "r", "f"), names.type(key)) == ("/x/r/y", "a/B")
    others = [other for other in TOPICS if other != key]
    assert [names.topic(other, "r", "f") for other in others] == [PROMISED[other][0] for other in others]


@pytest.mark.parametrize("key", list(SERVICES))
def test_every_service_can_be_renamed(key: str) -> None:
    assert names_of(Profile(services={key: "/{robot}/{robot}"})).service(key, "r") == "/r/r"


def test_braces_of_other_names_stay_as_they_are() -> None:
    assert names_of(Profile(topics={"pose": "/{x}/{robot}"})).topic("pose", "r") == "/{x}/r"


def test_only_what_depends_on_a_floor_has_one_for_each() -> None:
    names = names_of()
    depends = {key for key in TOPICS if names.topic(key, "r", "f1") != names.topic(key, "r", "f2")}
    assert depends == {key for key in VOCABULARY.floor_topics if TOPICS[key][0]}


def test_the_names_of_one_messages_fields() -> None:
    profile = Profile(
        fields={"vertex.id": "vid", "vertex.x": "px", "order.id": "number", "order_call.end_point": "to"}
    )
    names = names_of(profile)
    assert names.paths("vertex") == {"id": ("id", "vid"), "x": ("x", "px")}
    assert names.paths("order") == {"id": ("id", "number")}
    assert names.path("order_call", "end_point") == "to"
    assert names.paths("edge") == {}
    assert set(profile.fields) <= FIELDS
