"""Confirmation of set-up by telemetry: only by a pose that came after the command."""

import math

from msgspec.structs import replace

from fleet_tui.commands.set_up.confirmation import difference, is_near
from fleet_tui.model.commands import Command, Stage
from fleet_tui.model.events import CommandAdvanced, CommandIssued, Event, PoseReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Edge, Vertex
from fleet_tui.model.kind import Kind
from fleet_tui.model.navigation_events import LocalisationReported, ModeReported, OdometryReported
from fleet_tui.model.set_up.commands import CancelGoal, Localise, SendGoal, SendGraph, SetMapping, SetPose
from tests.support.fleets import F0, R0, T0, commanded, fleet, graph, labels, link_up, of_kinds, reduced, tick

WANTED = Pose(3.0, 4.0, 1.0)
SET = SetPose(R0, F0, WANTED)
Before = tuple[Event, ...]
NAVIGATES = Kind("nav2", ("odometry", "pose"), ("pose",), frames_are_floors=False)


def at(pose: Pose, when: float, stamp: float | None = None) -> PoseReported:
    return PoseReported(R0, when, pose, F0, stamp)


def after(
    command: Command, *facts: Event, kind: Kind | None = None, before: tuple[Event, ...] = ()
) -> FleetState:
    state = of_kinds(fleet(), kind) if kind else fleet()
    state = reduced(state, link_up(T0 - 100), *before, tick(T0))
    return reduced(state, *commanded(1, command, Stage.SENT, Stage.ACCEPTED), *facts)


def stage(state: FleetState) -> tuple[Stage, str]:
    (record,) = state.commands
    return record.stage, record.detail


def test_a_pose_since_confirms() -> None:
    state = after(SET, at(Pose(3.3, 4.0, 1.2), T0 + 1), tick(T0 + 1.1))
    assert stage(state) == (Stage.CONFIRMED, "reported within 0.30 m and 11°")


def test_an_earlier_pose_does_not() -> None:
    state = after(SET, tick(T0 + 1), before=(at(WANTED, T0 - 1),))
    assert stage(state)[0] is Stage.ACCEPTED
    assert stage(reduced(state, tick(T0 + 6)))[0] is Stage.NOT_CONFIRMED


def test_a_pose_stamped_before_it_does_not_confirm_however_late_it_comes() -> None:
    before = (at(Pose(0.0, 0.0), T0 - 1, stamp=50.0),)
    state = after(SET, at(WANTED, T0 + 1, stamp=50.9), tick(T0 + 2), before=before)
    assert stage(state)[0] is Stage.ACCEPTED


def test_one_elsewhere_is_named() -> None:
    state = after(SET, at(Pose(0.0, 0.0, 1.0), T0 + 1), tick(T0 + 6))
    assert stage(state) == (Stage.NOT_CONFIRMED, "accepted; the robot reported a pose 5.00 m and 0° from it")


def test_another_floor_proves_nothing() -> None:
    other = PoseReported(R0, T0 + 1, WANTED, "attic", None)
    assert stage(after(SET, other, tick(T0 + 2)))[0] is Stage.ACCEPTED


def test_wheels_alone_do_not_confirm_a_localised_pose() -> None:
    known = LocalisationReported(R0, T0 - 5, WANTED, "map", None, None)
    moved = OdometryReported(R0, T0 + 1, Pose(0.0, 0.0), None)
    state = after(SET, moved, tick(T0 + 2), kind=NAVIGATES, before=(known,))
    assert stage(state)[0] is Stage.ACCEPTED
    localised = LocalisationReported(R0, T0 + 2, WANTED, "map", None, None)
    assert stage(reduced(state, localised, tick(T0 + 3)))[0] is Stage.CONFIRMED


def test_a_latched_pose_that_comes_again_is_as_old_as_its_stamp() -> None:
    clock = OdometryReported(R0, T0 - 2, Pose(0.0, 0.0), 100.0)
    again = LocalisationReported(R0, T0 + 1, WANTED, "map", 90.0, None)
    state = after(SET, again, tick(T0 + 2), kind=NAVIGATES, before=(clock,))
    assert stage(state)[0] is Stage.ACCEPTED


def test_a_goal_is_confirmed_by_motion() -> None:
    goal = SendGoal(R0, F0, WANTED)
    still = (at(Pose(0.0, 0.0), T0 - 5), at(Pose(0.0, 0.0), T0 - 1))
    state = after(goal, at(Pose(0.0, 0.0), T0 + 1), tick(T0 + 2), before=still)
    assert stage(state)[0] is Stage.ACCEPTED
    assert stage(reduced(state, tick(T0 + 6)))[1].endswith("the robot did not move")
    assert stage(reduced(state, at(Pose(0.4, 0.0), T0 + 3), tick(T0 + 3.1)))[0] is Stage.CONFIRMED


def test_what_no_topic_shows_is_said_so() -> None:
    assert stage(after(Localise(R0), tick(T0 + 1)))[0] is Stage.UNVERIFIABLE
    state = after(SetMapping(R0, True), tick(T0 + 1))
    assert stage(state)[0] is Stage.UNVERIFIABLE and state.robots[R0].mapping_by_us


def test_a_reported_mode_confirms() -> None:
    tells = replace(NAVIGATES, reports=("mode",))
    state = after(SetMapping(R0, True), tick(T0 + 1), kind=tells)
    assert stage(state)[0] is Stage.ACCEPTED
    on = reduced(state, ModeReported(R0, T0 + 2, "mapping"), tick(T0 + 2))
    assert stage(on) == (Stage.CONFIRMED, "by the robot")
    off = reduced(state, ModeReported(R0, T0 + 2, "navigation"), tick(T0 + 9))
    assert stage(off) == (Stage.NOT_CONFIRMED, "accepted; the robot reports navigation")


def test_a_difference_goes_the_short_way_round() -> None:
    metres, turn = difference(Pose(0.0, 0.0, math.pi - 0.1), Pose(0.0, 0.0, -math.pi + 0.1))
    assert (metres, round(turn, 6)) == (0.0, 0.2)
    assert is_near(Pose(0.0, 0.0, 0.0), Pose(0.5, 0.0, 0.26)) and not is_near(Pose(0.0, 0.0), Pose(0.51, 0.0))


GRAPH = SendGraph(
    R0, F0, (Vertex("1", 0.0, 0.0), Vertex("2", 1.0, 0.0)), (Edge("5", "2", "1"),), labels=(("1", "Base"),)
)


def test_a_graph_is_confirmed_when_the_robot_has_it_with_its_labels() -> None:
    state = after(GRAPH, graph(1, 2), tick(T0 + 9.9), before=(graph(1, 2, 3), labels({3: "Old"})))
    assert stage(state)[0] is Stage.ACCEPTED
    state = reduced(state, labels({1: "Base"}), tick(T0 + 9.95))
    assert stage(state) == (Stage.CONFIRMED, "by the robot")


def test_another_graph_is_counted_after_ten_seconds() -> None:
    state = after(GRAPH, tick(T0 + 10.1), before=(graph(1, 2, 3), labels({3: "Old"})))
    assert stage(state) == (Stage.NOT_CONFIRMED, "accepted; the robot has 3 vertices, 2 edges, 1 label")
    assert stage(after(GRAPH, tick(T0 + 10.1)))[1].endswith("no graph of floor_0 received")


def test_a_graph_that_no_topic_shows_is_unverifiable() -> None:
    state = after(GRAPH, tick(T0 + 1), kind=Kind("oh_ressources", ("pose", "graph")))
    assert stage(state)[0] is Stage.UNVERIFIABLE


def test_a_graph_in_a_file_is_confirmed_by_the_answer() -> None:
    sent = replace(GRAPH, path="/srv/hall.geojson")
    state = after(sent, tick(T0 + 1), kind=replace(NAVIGATES, loads_graphs=True))
    assert stage(state) == (Stage.CONFIRMED, "the robot has loaded the file")
    steps = CommandAdvanced(1, Stage.SENT, T0), CommandAdvanced(1, Stage.NO_ANSWER, T0 + 1)
    linked = reduced(fleet(), link_up(T0 - 100), tick(T0), CommandIssued(1, sent, T0, 0.0))
    silent = reduced(linked, *steps, tick(T0 + 90))
    assert stage(silent) == (Stage.NOT_CONFIRMED, "no answer; the robot may have loaded the file or not")


def test_a_cancelled_goal_is_confirmed_by_a_robot_that_stops() -> None:
    drives = at(Pose(0.0, 0.0), T0 - 1), at(Pose(1.0, 0.0), T0 - 0.1)
    stands = [at(Pose(1.1, 0.0), T0 + n / 10) for n in range(1, 30)]
    state = after(CancelGoal(R0), *stands, tick(T0 + 3), before=drives)
    assert stage(state) == (Stage.CONFIRMED, "the robot stopped")
    goes_on = [at(Pose(1.0 + n / 10, 0.0), T0 + n / 10) for n in range(1, 70)]
    state = after(CancelGoal(R0), *goes_on, tick(T0 + 7), before=drives)
    assert stage(state) == (Stage.NOT_CONFIRMED, "accepted; the robot was not seen to stop")
    assert stage(after(CancelGoal(R0), tick(T0 + 0.1)))[0] is Stage.UNVERIFIABLE
