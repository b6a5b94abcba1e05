"""The questions of set-up commands."""

from msgspec.structs import replace

from fleet_tui.commands.set_up.losses import set_up_losses
from fleet_tui.model.geometry import Pose
from fleet_tui.model.kind import Kind
from fleet_tui.model.set_up.commands import Localise, SendGoal, SendGraph, SetMapping, SetPose, Settle
from tests.support.fleets import F0, R0, T0, fleet, graph, labels, of_kinds, pose, queue, reduced, tick


def test_a_pose_is_compared_with_the_present_one() -> None:
    state = reduced(fleet(), pose(T0, 3.0, 4.0), tick(T0))
    lines = list(set_up_losses(state, state.robots[R0], SetPose(R0, F0, Pose(0.0, 0.0, 0.5))))
    assert lines == ["robot_0: set pose (0.00, 0.00) 29° on floor_0?", "5.00 m and 29° from its present pose"]
    later = reduced(state, tick(T0 + 60))
    assert list(set_up_losses(later, later.robots[R0], SetPose(R0, F0, Pose(0.0, 0.0))))[1].endswith(
        "present pose, reported 60 s ago"
    )


def test_an_old_pose_of_the_localisation_is_not_called_the_present_one() -> None:
    state = reduced(fleet(), pose(T0, 3.0, 4.0), tick(T0 + 60), pose(T0 + 60, 3.0, 4.0))
    robot = replace(state.robots[R0], located=Pose(0.0, 4.0, 0.0), located_at=T0)
    (_, told) = set_up_losses(state, robot, SetPose(R0, F0, Pose(0.0, 0.0)))
    assert told == "4.00 m and 0° from the last pose of its localisation, 60 s ago"


def test_the_harmless_ones_do_not_ask() -> None:
    state = fleet()
    robot = state.robots[R0]
    for command in (Settle(R0), SendGoal(R0, F0, Pose(0.0, 0.0))):
        assert list(set_up_losses(state, robot, command)) == []
    assert len(list(set_up_losses(state, robot, Localise(R0)))) == 1
    assert len(list(set_up_losses(state, robot, SetMapping(R0, True)))) == 2


def test_a_graph_replaces_the_present_one() -> None:
    sent = SendGraph(R0, F0)
    state = fleet()
    assert list(set_up_losses(state, state.robots[R0], sent)) == [
        "robot_0: send graph of floor_0: 0 vertices, 0 edges, 0 labels?",
        "replaces its graph of floor_0, which is unknown here",
        "orders are driven on it from then on",
    ]
    loads = of_kinds(fleet(3), *[Kind("nav2", loads_graphs=True)] * 3)
    filed = SendGraph(R0, F0, path="/srv/hall.geojson")
    assert list(set_up_losses(loads, loads.robots[R0], filed))[2] == "writes /srv/hall.geojson"
    filed = SendGraph(R0, F0, path="/srv/hall.geojson", is_kept=True)
    assert list(set_up_losses(loads, loads.robots[R0], filed))[2:] == [
        "writes /srv/hall.geojson, the old file is kept as .bak",
        "2 other robots of floor_0: send it to each, too",
        "orders are driven on it from then on",
    ]
    driving = queue(T0, (4, 1, 2, "W"), current=4)
    state = reduced(state, graph(1, 2, 3), labels({1: "Base"}), driving, tick(T0))
    assert list(set_up_losses(state, state.robots[R0], sent))[1:] == [
        "replaces 3 vertices, 2 edges, 1 label",
        "orders are driven on it from then on, 1 open order too",
    ]
