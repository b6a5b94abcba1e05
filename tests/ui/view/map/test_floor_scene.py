"""The content of the map: its picture, the robots and their positions, and notes on missing data."""

import math

import pytest
from msgspec import structs

from fleet_tui.model import events
from fleet_tui.model.desk import events as desk_events
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import Role, RouteGraph, Vertex
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.occupancy import build_grid, grid_from_ros
from fleet_tui.text.language import Message
from fleet_tui.ui.view.map.floor_scene import JUMP_MARKED, floor_scene, map_owner
from fleet_tui.ui.view.map.glyphs import robot_tag
from fleet_tui.ui.view.map.scene import Scene, SceneRobot
from fleet_tui.ui.view.selection import Selection
from tests.support.fleets import (
    F0,
    R0,
    T0,
    battery,
    fleet,
    graph,
    labels,
    link_up,
    of_kinds,
    pose,
    queue,
    reduced,
    tick,
)

FRAME = MapFrame(0.5, 4, 2, Pose(-1.0, -1.0))
GRID = grid_from_ros(FRAME, bytes(8))
LIVE = (events.FrameReceived(R0, F0, FRAME), events.GridReceived(R0, F0, GRID))


def scene(state: FleetState, robot: str = R0, floor: str = F0) -> Scene:
    return floor_scene(state, Selection(robot, floor))


def image(width: int, height: int) -> OccupancyGrid:
    return build_grid(MapFrame(1.0, width, height), GRID.levels[0][:height, :width])


def placed(state: FleetState, name: str, **more: str) -> SceneRobot:
    (robot,) = [robot for robot in scene(state, **more).robots if robot.name == name]
    return robot


def test_nothing_yet_is_empty_ground_that_says_so() -> None:
    found = scene(fleet())
    assert found.grid is None and found.robots == ()
    assert found.note == "robot_0: no pose yet, no map and no graph yet"
    assert found.frame.width > 0 and found.frame.height > 0


def test_the_live_map_serves_without_a_file() -> None:
    found = scene(reduced(fleet(), *LIVE, pose(T0)))
    assert found.grid is GRID and found.frame == FRAME and found.note == ""


def test_a_configured_map_wins_whole_and_a_difference_is_one_note() -> None:
    other = MapFrame(0.25, 8, 4)
    file = build_grid(other, GRID.levels[0])
    state = reduced(fleet(), *LIVE, pose(T0), events.FloorMapLoaded(F0, file))
    found = scene(state)
    assert found.grid is file and found.frame == other
    assert found.note == "map_metadata differs from the map file"
    same = reduced(state, events.FrameReceived(R0, F0, other))
    assert scene(same).note == ""


def test_a_graph_file_that_cannot_be_read_is_said() -> None:
    problem = "graph a.json: not a FeatureCollection"
    state = reduced(fleet(), *LIVE, pose(T0), events.FloorGraphLoaded(F0, None, {}, problem))
    assert scene(state).note == problem


def test_a_plain_image_is_tied_by_map_metadata() -> None:
    file = image(4, 2)
    loaded = events.FloorMapLoaded(F0, file, tied=False)
    waiting = scene(reduced(fleet(), pose(T0), loaded))
    assert waiting.grid is None and waiting.note == "map image waiting for map_metadata"
    tied = scene(reduced(fleet(), pose(T0), loaded, LIVE[0]))
    assert tied.grid is file and tied.frame == FRAME and tied.note == ""
    wrong = scene(reduced(fleet(), pose(T0), events.FloorMapLoaded(F0, image(3, 2), tied=False), LIVE[0]))
    assert wrong.grid is None and "3 x 2 px, map_metadata 4 x 2" in wrong.note


def test_the_map_stays_when_a_robot_without_map_metadata_is_selected() -> None:
    file = image(4, 2)
    loaded = events.FloorMapLoaded(F0, file, tied=False)
    state = reduced(fleet(2), pose(T0), loaded, LIVE[0])
    for robot in (R0, "robot_1"):
        found = scene(state, robot=robot)
        assert found.grid is file and found.frame == FRAME


def test_a_robot_inside_a_wall_or_off_the_map_by_more_than_its_size_is_marked() -> None:
    frame = MapFrame(0.5, 4, 2)
    grid = grid_from_ros(frame, bytes([0, 100, 0, 255, *bytes(4)]))
    for x, y, is_misplaced in (
        (0.2, 0.2, False),
        (0.7, 0.2, True),
        (0.7, 0.7, False),
        (1.7, 0.2, False),
        (2.5, 0.2, False),
        (3.2, 0.2, True),
        (0.2, -1.5, True),
        (math.nan, 0.2, False),
    ):
        state = reduced(fleet(), pose(T0, x, y), events.FloorMapLoaded(F0, grid), tick(T0))
        assert placed(state, R0).misplaced == is_misplaced, (x, y)
        assert ("?" in robot_tag(placed(state, R0), plain=True)) == is_misplaced


def test_a_map_that_could_not_be_read_says_why() -> None:
    found = scene(
        reduced(fleet(), pose(T0), events.FloorMapLoaded(F0, None, Message("map a.png: no image a.png")))
    )
    assert found.note == "map a.png: no image a.png"


def test_a_missing_map_is_no_news_of_a_kind_that_never_sends_one() -> None:
    state = reduced(fleet(), link_up(T0), pose(T0 + 60), graph(1, 2, 3), tick(T0 + 60))
    silent = of_kinds(
        state, *(structs.replace(one.kind, reports=frozenset({"pose"})) for one in state.robots.values())
    )
    assert [(scene(one).note, scene(one).waits) for one in (state, silent)] == [
        ("no map yet", False),
        ("no map yet", True),
    ]


def test_without_a_map_there_is_ground_for_every_vertex() -> None:
    found = scene(reduced(fleet(), pose(T0), graph(1, 2, 3)))
    assert found.note == "no map yet" and found.grid is None
    for vertex in found.vertices:
        column, row = found.frame.to_pixel(vertex.x, vertex.y)
        assert 0 <= column <= found.frame.width and 0 <= row <= found.frame.height


@pytest.mark.parametrize("far", [1e300, -1e308, math.inf, math.nan])
def test_a_vertex_beyond_all_sense_gets_no_room(far: float) -> None:
    sensible = scene(reduced(fleet(), graph(1, 2, 3))).frame
    vertices = {**graph(1, 2, 3).graph.vertices, "4": Vertex("4", far, far)}
    wild = events.GraphReceived(R0, F0, RouteGraph(vertices))
    assert scene(reduced(fleet(), wild, pose(T0, far))).frame == sensible
    assert scene(reduced(fleet(), pose(T0, far))).frame.width > 0


def test_without_a_graph_there_is_ground_that_stands_still_under_a_moving_robot() -> None:
    frames = {scene(reduced(fleet(), pose(T0, 1.0 + n / 10, 2.0))).frame for n in range(50)}
    assert len(frames) == 1


def test_vertices_with_labels_roles_and_edges_between_them() -> None:
    found = scene(reduced(fleet(), graph(1, 2, 3), labels({2: "Base", 9: "Ghost"})))
    assert [(vertex.id, vertex.label) for vertex in found.vertices] == [("1", ""), ("2", "Base"), ("3", "")]
    assert found.edges == ((0.0, 0.0, 1.0, 0.0), (1.0, 0.0, 2.0, 0.0))
    assert {vertex.role for vertex in found.vertices} == {Role.PLAIN}


def test_what_did_not_change_stays_the_same_object() -> None:
    state = reduced(fleet(), graph(1, 2), labels({1: "A"}), *LIVE, pose(T0))
    before, after = scene(state), scene(reduced(state, pose(T0 + 1, 2.0), tick(T0 + 1)))
    assert before.vertices is after.vertices and before.edges is after.edges and before.grid is after.grid


def test_only_robots_of_this_floor_are_drawn() -> None:
    here = [pose(T0), pose(T0, robot="robot_1", frame="floor_1"), pose(T0, robot="robot_2", frame="attic")]
    state = reduced(fleet(4, 2), *here)
    assert [robot.name for robot in scene(state).robots] == [R0]
    assert [robot.name for robot in scene(state, floor="floor_1").robots] == ["robot_1"]
    assert scene(state, "robot_1").note.startswith("robot_1 is on floor_1")
    assert scene(state, "robot_2").note.startswith("robot_2 is on unknown floor attic")


def test_the_state_of_a_robot_is_drawn() -> None:
    facts = (
        events.CargoReported(R0, T0, True),
        events.PausedReported(R0, T0, True),
        events.ObstacleReported(R0, T0, 10.0),
    )
    state = reduced(fleet(2), pose(T0, 1.0, 2.0), *facts, pose(T0, robot="robot_1"), tick(T0 + 1))
    robot, other = scene(state).robots
    assert (robot.number, robot.selected, robot.cargo, robot.paused, robot.obstacle) == (
        1,
        True,
        True,
        True,
        True,
    )
    assert (other.number, other.selected, other.cargo, other.paused, other.obstacle) == (
        2,
        False,
        *[False] * 3,
    )
    assert robot.online and robot.age == 1.0 and robot.pose == Pose(1.0, 2.0)


def test_an_alarm_is_red_until_it_is_acknowledged_and_its_robot_stays_marked() -> None:
    state = reduced(fleet(), pose(T0), battery(T0, 5.0), tick(T0))
    assert placed(state, R0).alarmed and not placed(state, R0).acknowledged
    seen = placed(reduced(state, desk_events.AlarmAcknowledged()), R0)
    assert seen.acknowledged and not seen.alarmed


def test_a_pose_gone_quiet_never_looks_live() -> None:
    state = reduced(fleet(), pose(T0), battery(T0 + 20), tick(T0 + 20))
    assert state.is_online(state.robots[R0])
    assert not placed(state, R0).online and placed(state, R0).age == 20.0


def test_a_robot_that_its_localisation_moved_is_marked_for_a_while() -> None:
    state = reduced(fleet(), pose(T0), pose(T0 + 0.2, 9.0), tick(T0 + 1.0))
    assert placed(state, R0).jumped
    assert not placed(reduced(state, tick(T0 + 0.2 + JUMP_MARKED)), R0).jumped


def test_another_robot_is_placed_through_its_own_metadata() -> None:
    """Its world starts elsewhere, but one pixel is one pixel of the same floor."""
    own = MapFrame(0.5, 4, 2, Pose(10.0, 20.0))
    state = reduced(fleet(2), *LIVE, pose(T0), pose(T0, 11.0, 20.5, robot="robot_1"))
    state = reduced(state, events.FrameReceived("robot_1", F0, own))
    robot = placed(state, "robot_1")
    assert (robot.pose.x, robot.pose.y) == pytest.approx((0.0, -0.5)) and not robot.other_map
    assert placed(state, R0).pose == Pose(0.0, 0.0)


def test_a_map_of_another_resolution_or_turn_is_marked_and_still_placed() -> None:
    own = MapFrame(1.0, 2, 1, Pose(0.0, 0.0, math.pi / 2))
    state = reduced(fleet(2), *LIVE, pose(T0), pose(T0, 0.0, 1.0, robot="robot_1"))
    robot = placed(reduced(state, events.FrameReceived("robot_1", F0, own)), "robot_1")
    # One metre along its map's lower edge: half the picture's width of two metres.
    assert (robot.pose.x, robot.pose.y) == pytest.approx((0.0, -1.0)) and robot.other_map
    assert robot.pose.yaw == pytest.approx(-math.pi / 2)


def test_the_picture_is_the_selected_robots_else_of_one_that_knows_the_floor() -> None:
    state = reduced(fleet(2, 2), graph(1), graph(2, robot="robot_1"))
    assert [vertex.id for vertex in scene(state, "robot_1").vertices] == ["2"]
    assert [vertex.id for vertex in scene(state).vertices] == ["1"]
    owner = map_owner(state, Selection("robot_1", F0))
    assert owner is not None and owner.name == "robot_1"


def test_the_ends_of_the_current_order_are_its_targets() -> None:
    state = reduced(fleet(), graph(1, 2, 3), queue(T0, (4, 1, 3, "W"), (5, 2, 1, "Q"), current=4))
    assert scene(state).target_vertices == ("1", "3")
    assert scene(reduced(state, queue(T0 + 1, (5, 2, 1, "Q")))).target_vertices == ("2", "1")
    assert scene(reduced(state, queue(T0 + 1))).target_vertices == ()


def test_the_live_map_of_another_robot_serves_if_it_is_the_same() -> None:
    mine = events.FrameReceived("robot_1", F0, FRAME)
    assert scene(reduced(fleet(2), *LIVE, mine), "robot_1").grid is GRID
    other = events.FrameReceived("robot_1", F0, MapFrame(0.5, 4, 2, Pose(5.0, 5.0)))
    assert scene(reduced(fleet(2), *LIVE, other), "robot_1").grid is None


def test_a_robot_without_a_map_of_its_own_is_drawn_on_the_live_one_of_another() -> None:
    mine = graph(1, 2, robot="robot_1")
    shown = scene(reduced(fleet(2), *LIVE, mine), "robot_1")
    assert shown.grid is GRID and "no map" not in shown.note
