"""From the fleet state to the scene of one floor.

The picture is the selected robot's: its map, graph and labels. The others are placed into it through their
own map_metadata.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import lru_cache

from fleet_tui.commands.routes.order_draft import Drafted
from fleet_tui.model.by_identity import Same
from fleet_tui.model.desk.desk import Ends
from fleet_tui.model.fleet import FleetState, Floor
from fleet_tui.model.geometry import Line, MapFrame, Pose
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.model.robot_numbers import marks_of
from fleet_tui.orders.mode import mapping_text
from fleet_tui.situation.alarms.facilities import closed_edges
from fleet_tui.situation.alarms.trouble import (
    acknowledged,
    in_trouble,
    shelved,
    trouble_elsewhere,
    urgency,
    waits,
)
from fleet_tui.situation.pauses import is_held
from fleet_tui.situation.pose_checks.misplaced import misplaced_text
from fleet_tui.situation.robots import blocked_robots, obstacle
from fleet_tui.text.language import Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.map.area import worth_seeing
from fleet_tui.ui.view.map.mission import blocked_edges, edge_lines, way_of
from fleet_tui.ui.view.map.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.ui.view.selection import Selection

MARGIN = 2.0
BLOCK = 10.0
EMPTY_RESOLUTION = 0.05
PATIENCE = 5.0
"""Seconds after a change of the link for which a note is no problem: everything is still arriving."""
NO_MAP = Message("no map yet")
JUMP_MARKED = 10.0
"""Seconds for which a robot that its localisation moved is marked."""
FAR = 1e6
"""Metres beyond which a place is an error and doesn't extend the picture."""

Drawn = tuple[tuple[SceneVertex, ...], tuple[Line, ...], tuple[Line, ...]]


@lru_cache(maxsize=2)
def _drawn(known: Same[RouteGraph | None], named: Same[Mapping[str, str]]) -> Drawn:
    """Return vertices, edges and one-way edges; the same objects as long as graph and labels are the same."""
    graph, labels = known.value or RouteGraph(), named.value
    vertices = tuple(
        SceneVertex(vertex.id, vertex.x, vertex.y, vertex.role, sanitize(labels.get(vertex.id, "")))
        for vertex in graph.vertices.values()
    )
    places, joined = graph.vertices, {(edge.start, edge.end) for edge in graph.edges}
    lines = [
        ((places[start].x, places[start].y, places[end].x, places[end].y), (end, start) not in joined)
        for start, end in ((edge.start, edge.end) for edge in graph.edges)
    ]
    one_way = tuple(line for line, alone in lines if alone and graph.directed)
    return vertices, tuple(line for line, _ in lines), one_way


def map_owner(state: FleetState, selection: Selection) -> Robot | None:
    """Return the robot whose map and graph of the floor are shown: the selected one, else the first."""
    selected = state.robots[selection.robot]
    if selection.floor in selected.maps:
        return selected
    return next((robot for robot in state.robots.values() if selection.floor in robot.maps), None)


def _ground(state: FleetState, floor: str, vertices: tuple[SceneVertex, ...]) -> MapFrame:
    """Return the extent without a map: around the vertices, else around the robots in steps so that it rarely
    changes."""
    points = [(vertex.x, vertex.y) for vertex in vertices]
    if not points:
        for robot in state.robots.values():
            if robot.pose is not None and robot.floor == floor:
                x, y = robot.pose.value.x // BLOCK * BLOCK, robot.pose.value.y // BLOCK * BLOCK
                points += [(x, y), (x + BLOCK, y + BLOCK)]
    points = [(x, y) for x, y in points if abs(x) < FAR and abs(y) < FAR] or [(0.0, 0.0), (BLOCK, BLOCK)]
    left, low = min(x for x, _ in points) - MARGIN, min(y for _, y in points) - MARGIN
    width = max(x for x, _ in points) + MARGIN - left
    height = max(y for _, y in points) + MARGIN - low
    pixels = (max(1, round(width / EMPTY_RESOLUTION)), max(1, round(height / EMPTY_RESOLUTION)))
    return MapFrame(EMPTY_RESOLUTION, *pixels, Pose(left, low))


def _frame_of_others(state: FleetState, floor: str) -> MapFrame | None:
    """Return the first robot's frame of a floor, None if no robot has one."""
    maps = (robot.maps.get(floor) for robot in state.robots.values())
    return next((one.frame for one in maps if one is not None and one.frame is not None), None)


def live_map(state: FleetState, floor: Floor, robot_map: RobotMap) -> OccupancyGrid | None:
    """Return a robot's live map of a floor, else the floor's, else another robot's of the same frame."""
    maps = (robot.maps.get(floor.name) for robot in state.robots.values())
    same = (one.grid for one in maps if one and one.grid and robot_map.frame in (None, one.frame))
    return robot_map.grid or floor.live or next(same, None)


def _with_map(state: FleetState, floor: Floor, robot_map: RobotMap, scene: Scene, is_mapping: bool) -> Scene:
    """Return the floor's configured file first, then the live map, then another robot's, then empty ground
    with a note on the missing map. A robot whose map_metadata is missing is drawn with that of others."""
    grid, frame = floor.grid, robot_map.frame
    if is_mapping and (robot_map.grid or floor.live) is not None:
        grid = None  # the map that grows, not the file
    if grid is not None and floor.tied:
        note = ""
        if frame is not None and not _same_size(frame, grid.frame):
            note = tr("map_metadata differs from the map file")
        return replace(scene, grid=grid, frame=grid.frame, note=note)
    if grid is not None and (frame := frame or _frame_of_others(state, floor.name)) is not None:
        if (frame.width, frame.height) == (grid.frame.width, grid.frame.height):
            return replace(scene, grid=grid, frame=frame)
        image, size = grid.frame, f"{frame.width} x {frame.height}"
        return replace(
            scene,
            note=tr(
                "map image {width} x {height} px, map_metadata {size}",
                width=image.width,
                height=image.height,
                size=size,
            ),
        )
    if floor.problem:
        return replace(scene, note=translate(floor.problem))
    if grid is not None:
        return replace(scene, note=tr("map image waiting for map_metadata"))
    live = live_map(state, floor, robot_map)
    if live is not None:
        return replace(scene, grid=live, frame=live.frame)
    missing = translate(NO_MAP) if robot_map.graph is not None else tr("no map and no graph yet")
    return replace(scene, frame=frame or scene.frame, note=missing)


def _same_size(one: MapFrame, other: MapFrame) -> bool:
    same_pixels = (one.width, one.height) == (other.width, other.height)
    return same_pixels and abs(one.resolution - other.resolution) < 1e-6


def _placed(pose: Pose, own: MapFrame | None, picture: MapFrame) -> tuple[Pose, bool]:
    """Return a pose in the picture's world, and whether the robot's own map is another one."""
    if own is None or own is picture or own == picture:
        return pose, False
    column, row = own.to_pixel(pose.x, pose.y)
    scale = own.resolution / picture.resolution
    x, y = picture.to_world(column * scale, picture.height - (own.height - row) * scale)
    turn = picture.origin.yaw - own.origin.yaw
    return Pose(x, y, pose.yaw + turn), not _same_size(own, picture)


def _robot(
    state: FleetState, robot: Robot, selection: Selection, picture: MapFrame, tied: bool, mark: str
) -> SceneRobot | None:
    if robot.pose is None or robot.floor != selection.floor:
        return None
    robot_map = None if tied else robot.maps.get(selection.floor)
    pose, other_map = _placed(robot.pose.value, robot_map.frame if robot_map else None, picture)
    is_paused = is_held(state, robot)
    return SceneRobot(
        name=robot.name,
        number=robot.number,
        pose=pose,
        cargo=robot.has_cargo,
        selected=robot.name == selection.robot,
        online=state.is_fresh(robot, "pose"),
        paused=is_paused,
        obstacle=obstacle(state, robot) is not None,
        other_map=other_map,
        age=state.now - robot.pose.at,
        size=robot.size,
        mark=mark,
        waits=waits(state, robot) and not is_paused,
        misplaced=misplaced_text(state, robot) != "",
        estimated=robot.is_estimated,
        jumped=robot.relocated is not None and state.now - robot.relocated.at < JUMP_MARKED,
    )


def _robots(state: FleetState, selection: Selection, picture: MapFrame, tied: bool) -> tuple[SceneRobot, ...]:
    seen = acknowledged(state)
    alarmed = in_trouble(state).union(blocked_robots(state)) - seen - shelved(state)
    robots = (
        _robot(state, robot, selection, picture, tied, mark)
        for robot, mark in zip(state.robots.values(), marks_of(tuple(state.robots)), strict=True)
    )
    said = {alarm.condition.source: alarm.text for alarm in sorted(state.alarms, key=urgency, reverse=True)}
    return tuple(
        robot._replace(
            alarmed=robot.name in alarmed,
            acknowledged=robot.name in seen,
            said=sanitize(said.get(robot.name, "")),
        )
        if robot.name in seen or robot.name in alarmed
        else robot
        for robot in robots
        if robot is not None
    )


def _deadlocked(
    state: FleetState, robots: Iterable[SceneRobot], floor: str, picture: MapFrame, tied: bool
) -> tuple[Line, ...]:
    """Return the next edges of robots with an alarm that wait for each other."""
    waiting = [
        one.name for one in robots if one.name in state.deadlocks and (one.alarmed or one.acknowledged)
    ]
    lines = []
    for name in waiting:
        robot_map = None if tied else state.robots[name].maps.get(floor)
        frame = robot_map.frame if robot_map is not None else None
        for x, y, to_x, to_y in state.deadlocks[name].way:
            ends = [_placed(Pose(*end), frame, picture)[0] for end in ((x, y), (to_x, to_y))]
            lines.append((ends[0].x, ends[0].y, ends[1].x, ends[1].y))
    return tuple(lines)


def _elsewhere(state: FleetState, selection: Selection) -> str:
    """Return the selected robot's place, if not here."""
    robot = state.robots[selection.robot]
    if "pose" not in robot.kind.reports:
        return tr("{name}: no position", name=robot.name)
    if robot.pose is None:
        return tr("{name}: no pose yet", name=robot.name)
    if robot.floor is None:
        return tr("{name} is on unknown floor {frame_id}", name=robot.name, frame_id=sanitize(robot.frame_id))
    return (
        tr("{name} is on {floor}", name=robot.name, floor=robot.floor)
        if robot.floor != selection.floor
        else ""
    )


def _closed(state: FleetState, owner: Robot | None, floor: str) -> list[Ends]:
    """Return the edges that people, or the fleet of the map's owner, have closed."""
    by_fleet = closed_edges(state, owner, floor) if owner is not None else []
    return [*(edge.ends for edge in state.desk.closed_on(floor)), *by_fleet]


def floor_scene(state: FleetState, selection: Selection, drafted: Drafted | None = None) -> Scene:
    """Return the scene of the selected floor; while an order is typed its way is in place of the mission."""
    owner = map_owner(state, selection)
    robot_map = owner.maps[selection.floor] if owner else RobotMap()
    vertices, edges, one_way = _drawn(Same(robot_map.graph), Same(robot_map.labels))
    floor = state.floors[selection.floor]
    ground = _ground(state, floor.name, vertices)
    scene = Scene(floor.name, ground, vertices=vertices, edges=edges, one_way=one_way, at=state.now)
    scene = _with_map(state, floor, robot_map, scene, bool(mapping_text(state.robots[selection.robot])))
    selected = state.robots[selection.robot]
    notes = [
        note for note in (_elsewhere(state, selection), scene.note, translate(floor.graph_problem)) if note
    ]
    vertices_of_way, way = way_of(selected, floor.name, drafted)
    is_tied = floor.grid is not None and floor.tied
    placed = _robots(state, selection, scene.frame, is_tied)
    return replace(
        scene,
        area=worth_seeing(scene, placed),
        robots=placed,
        target_vertices=vertices_of_way,
        picked=vertices_of_way[-1] if drafted is not None and vertices_of_way else "",
        mission=way,
        closed=edge_lines(robot_map, _closed(state, owner, floor.name)),
        blocked=edge_lines(robot_map, blocked_edges(state, placed)),
        deadlocked=_deadlocked(state, placed, floor.name, scene.frame, is_tied),
        note=", ".join(notes),
        elsewhere=translate(trouble_elsewhere(state, floor.name)),
        waits=state.now - state.links[selected.link].since < PATIENCE
        # Robots of such a kind never send one: that is no news.
        or (notes == [translate(NO_MAP)] and "map" not in selected.kind.reports),
    )
