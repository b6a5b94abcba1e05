"""Names on the wire: those of the profile before those of the kind."""

from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.names import Names, Vocabulary

USUAL = Vocabulary(
    topics={"pose": ("/{robot}/pose", "geometry_msgs/PoseStamped"), "map": ("/{robot}/{floor}/map", "a/Map")},
    floor_topics=frozenset({"map"}),
    services={"pause": ("/{robot}/pause", "std_srvs/Trigger")},
    fields={"pose": {"x": "pose.x", "y": "pose.y"}},
    actions={"go": ("/{robot}/go", "a/Go")},
    refusals=("^no$",),
    vertex_types={"E": "elevator"},
)


def names(**changes: object) -> Names:
    return Names(USUAL, Profile(**changes))  # type: ignore[arg-type]  # each test knows the type of its field


def test_usual_names_are_filled_in() -> None:
    usual = names()
    assert usual.topic("map", "r1", "hall") == "/r1/hall/map"
    assert (usual.service("pause", "r1"), usual.action("go", "r1")) == ("/r1/pause", "/r1/go")
    assert (usual.type("pose"), usual.service_type("pause"), usual.action_type("go")) == (
        *("geometry_msgs/PoseStamped", "std_srvs/Trigger", "a/Go"),
    )
    assert (usual.refusals, usual.role("E"), usual.role("?"), usual.scale("pose")) == (
        *(("^no$",), "elevator", "plain", 1.0),
    )


def test_a_profile_overrides_single_names_and_empty_is_none() -> None:
    own = names(
        topics={"pose": "/fleet/{robot}/where"}, services={"pause": ""}, actions={"go": "/{robot}/drive"}
    )
    assert own.topic("pose", "r1") == "/fleet/r1/where"
    assert own.topic("map", "r1", "hall") == "/r1/hall/map"
    assert (own.service("pause", "r1"), own.action("go", "r1")) == ("", "/r1/drive")


def test_a_profile_that_says_no_refusals_or_roles_has_none() -> None:
    own = names(refusals=(), vertex_types={})
    assert (own.refusals, own.role("E")) == ((), "plain")


def test_only_fields_that_differ_have_two_paths() -> None:
    own = names(fields={"pose.x": "where.x", "pose.y": "pose.y"})
    assert own.paths("pose") == {"x": ("pose.x", "where.x")}
    assert (own.path("pose", "x"), own.path("pose", "y")) == ("where.x", "pose.y")
