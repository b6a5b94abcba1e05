"""Maps that a robot saves: requests with harmless names only, and the meaning of answers."""

import pytest
from msgspec.structs import replace

from fleet_tui.adapters.adapter import ServiceCall, Site
from fleet_tui.adapters.profile import Profile
from fleet_tui.adapters.registry import KINDS
from fleet_tui.errors import CommandError
from fleet_tui.model.commands import Stage
from fleet_tui.model.set_up.commands import StoreMap, StorePoseGraph
from tests.support.nav2_adapter import adapter, robot

HALL = StoreMap("tb2", "hall_2")


def asked(command: StoreMap, kind: str = "nav2", **profile: object) -> ServiceCall:
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
        with pytest.raises(CommandError, match="is no name for a map"):
            asked(command)


def test_nor_does_one_of_a_robot_or_floor() -> None:
    template = {"map_save": {"name": {"data": "{floor}_{name}"}}}
    with pytest.raises(CommandError, match="floor 'hall; reboot' is no name"):
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
