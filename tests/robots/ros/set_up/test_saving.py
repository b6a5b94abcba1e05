"""Maps that a robot saves and graphs that it loads: requests, and the meaning of answers."""

import pytest
from msgspec.structs import replace

from fleet_tui.model.commands import Stage
from fleet_tui.model.set_up.commands import SendGraph, StoreMap, StorePoseGraph
from fleet_tui.robots.adapter import ServiceCall, Site
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.registry import KINDS
from fleet_tui.text.errors import CommandError
from tests.support.nav2_adapter import adapter, robot

HALL = StoreMap("tb2", "hall_2")


def asked(command: StoreMap | SendGraph, kind: str = "nav2", **profile: object) -> ServiceCall:
    it = KINDS[kind].adapter(Profile(kind=kind, **profile), Site())  # type: ignore[arg-type]  # each is of its field
    (call,) = it.outgoing(command, 1, robot())
    assert isinstance(call, ServiceCall)
    return call


def test_each_stack_is_asked_in_its_own_way() -> None:
    found = asked(HALL)
    assert (found.address, found.type) == ("/tb2/map_saver/save_map", "nav2_msgs/SaveMap")
    assert found.args["map_url"] == "hall_2" and found.args["map_topic"] == "map"
    found = asked(StorePoseGraph("tb2", "hall"))
    assert (found.address, found.args) == ("/tb2/slam_toolbox/serialize_map", {"filename": "hall"})
    found = asked(HALL, "move_base")
    assert (found.address, found.args) == ("/tb2/slam_toolbox/save_map", {"name": {"data": "hall_2"}})


def test_a_path_is_the_profiles() -> None:
    template = {"map_save": {"map_url": "/maps/{robot}/{name}", "n": 3, "more": ["{name}"]}}
    assert asked(HALL, requests=template).args == {"map_url": "/maps/tb2/hall_2", "n": 3, "more": ["hall_2"]}


@pytest.mark.parametrize(
    "name", ["", "a b", "a;b", "$(a)", "../a", "a/b", "a\n", "ä", "-f", "a" * 65, "{robot}", "{name}", "a'b"]
)
def test_no_other_character_reaches_a_shell(name: str) -> None:
    for command in (StoreMap("tb2", name), StorePoseGraph("tb2", name)):
        with pytest.raises(CommandError, match="is not a map name"):
            asked(command)


def test_nor_does_one_of_a_robot_or_floor() -> None:
    template = {"map_save": {"name": {"data": "{floor}_{name}"}}}
    with pytest.raises(CommandError, match="floor 'hall; reboot' is not a map name"):
        it = adapter(requests=template)
        it.outgoing(HALL, 1, replace(robot(), floor="hall; reboot"))
    (call,) = adapter(requests=template).outgoing(HALL, 1, replace(robot(), floor="hall"))
    assert isinstance(call, ServiceCall) and call.args == {"name": {"data": "hall_hall_2"}}
    assert asked(HALL).args["map_url"] == "hall_2"  # of a floor that the request does not name


def test_an_empty_key_is_named() -> None:
    bare = adapter(services={"map_save": ""})
    assert bare.kind.lack("map save") == "profile.services.map_save is empty: no saving of maps on the robot"
    with pytest.raises(CommandError, match="map_save is empty"):
        bare.outgoing(HALL, 1, robot())
    source = KINDS["oh_ressources"].adapter(Profile(), Site())
    assert {"map save", "pose graph save"} <= source.kind.unset.keys()


SLAM = {"map_save": {"result": 0}}


@pytest.mark.parametrize(
    ("answers", "values", "end"),
    [
        ({}, {"result": True}, (Stage.ACCEPTED, "")),
        ({}, {"result": False}, (Stage.REFUSED, "result False")),
        (SLAM, {"result": 0}, (Stage.ACCEPTED, "")),
        (SLAM, {"result": 1}, (Stage.REFUSED, "result 1 (no map)")),
        (SLAM, {"result": 255}, (Stage.REFUSED, "result 255 (failed)")),
        (SLAM, {"other": 7}, (Stage.REFUSED, "result None")),
        (SLAM, {}, (Stage.ACCEPTED, "")),
        ({"map_save": {}}, {"success": False, "message": "disk full"}, (Stage.REFUSED, "disk full")),
    ],
)
def test_success_is_what_the_profile_says(
    answers: dict[str, dict[str, bool | int | str]], values: object, end: tuple[Stage, str]
) -> None:
    assert adapter(answers=answers).outcome(HALL, values, True) == end


def test_a_call_that_failed_is_no_answer() -> None:
    stage, _ = adapter().outcome(HALL, "Service /x does not exist", False)
    assert stage is Stage.REFUSED


def test_without_fields_the_answer_is_that_it_came() -> None:
    for kind in ("move_base", "oh_ressources"):
        it = KINDS[kind].adapter(Profile(kind=kind), Site())
        assert it.outcome(HALL, {}, True) == (Stage.ACCEPTED, "")


PATH = "/srv/it's a {robot}/$(hall) ü.geojson"
GRAPH = SendGraph("tb2", "hall", path=PATH)


def test_a_route_server_gets_the_path_as_it_is() -> None:
    found = asked(GRAPH)
    assert (found.address, found.type) == ("/tb2/route_server/set_route_graph", "nav2_msgs/SetRouteGraph")
    assert found.args == {"graph_filepath": PATH}
    assert adapter().kind.loads_graphs and adapter().kind.can("graph")


def test_a_site_names_another_service_and_another_path() -> None:
    found = asked(
        GRAPH,
        services={"graph_load": "/{robot}/routes/load"},
        service_types={"graph_load": "site_msgs/Load"},
        requests={"graph_load": {"file": "/data/{floor}.geojson", "of": "{robot}", "again": True}},
    )
    assert (found.address, found.type) == ("/tb2/routes/load", "site_msgs/Load")
    assert found.args == {"file": "/data/hall.geojson", "of": "tb2", "again": True}


def test_no_graph_is_loaded_without_a_file_or_a_service() -> None:
    with pytest.raises(CommandError, match="no file of the graph"):
        asked(SendGraph("tb2", "hall"))
    bare = adapter(services={"graph_load": ""})
    assert bare.kind.lack("graph") == "profile.services.graph_load is empty: no sending of graphs"
    assert not bare.kind.loads_graphs
    with pytest.raises(CommandError, match="graph_load is empty"):
        bare.outgoing(GRAPH, 1, robot())


@pytest.mark.parametrize(
    ("answers", "values", "result", "end"),
    [
        ({}, {"success": True}, True, (Stage.ACCEPTED, "")),
        ({}, {"success": False}, True, (Stage.REFUSED, "success False")),
        ({}, {"other": 1}, True, (Stage.REFUSED, "success None")),
        ({"graph_load": {"code": 0}}, {"code": 4}, True, (Stage.REFUSED, "code 4")),
        ({"graph_load": {"code": 0}}, {"code": 0}, True, (Stage.ACCEPTED, "")),
        ({}, "Service /x does not exist", False, (Stage.REFUSED, "Service /x does not exist")),
        ({}, "it died", False, (Stage.UNKNOWN, "it died")),
    ],
)
def test_a_graph_is_loaded_by_the_servers_word(
    answers: dict[str, dict[str, bool | int | str]], values: object, result: bool, end: tuple[Stage, str]
) -> None:
    assert adapter(answers=answers).outcome(GRAPH, values, result) == end
