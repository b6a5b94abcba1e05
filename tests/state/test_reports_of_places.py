"""The position of a robot, and its consequences."""

from fleet_tui.commands.language.lookup import places
from fleet_tui.model import events
from fleet_tui.model.fleet import FleetState, Floor
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import RouteGraph, Vertex
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.state.reducer import apply
from fleet_tui.text.language import Message
from tests.support.fleets import R0, T0, fleet, pose, reduced


def test_labels_are_those_of_the_floor_it_is_on_where_ids_are_the_same() -> None:
    """The floor's frame has another name than the floor."""
    floors = {name: Floor(name, frame) for name, frame in (("floor_0", "map_0"), ("floor_1", "map_1"))}
    maps = {
        name: RobotMap(labels={"1": label}, graph=RouteGraph({"1": Vertex("1", 0.0, 0.0)}))
        for name, label in (("floor_0", "Base"), ("floor_1", "Attic"))
    }
    state = FleetState(floors, {"r": Robot("r", 1, "l", maps)}, {"l": LinkState("l", "ws://x")})
    state = apply(state, events.PoseReported("r", 1.0, Pose(0.0, 0.0), "map_1", None))
    assert state.robots["r"].name_of("1") == "Attic"
    assert [place.name for place in places(state.robots["r"])] == ["Attic", "Base"]


def test_an_offline_alarm_does_not_end_because_the_link_goes_too() -> None:
    robots = {"r": Robot("r", 1, "l", {}, last_received=0.0)}
    state = FleetState({}, robots, {"l": LinkState("l", "ws://x", Phase.UP)})
    state = apply(state, events.TimePassed(10.0, 0.0))
    state = apply(state, events.LinkChanged("l", 11.0, Phase.WAITING, Message("gone")))
    state = apply(state, events.TimePassed(20.0, 0.0))
    assert [alarm.text for alarm in state.alarms if alarm.condition.source == "r"] == ["offline 20 s"]


def test_a_jump_of_localisation_is_kept_in_words_until_the_next() -> None:
    state = reduced(fleet(), pose(T0, 0.0), pose(T0 + 0.1, 0.2), pose(T0 + 0.2, 2.2))
    jumped = state.robots[R0].relocated
    assert jumped is not None and (jumped.value, jumped.at) == ("2.0 m and 0°", T0 + 0.2)
    assert reduced(state, pose(T0 + 0.3, 2.3)).robots[R0].relocated is jumped
    assert reduced(fleet(), pose(T0, 0.0), pose(T0 + 9, 9.0)).robots[R0].relocated is None
