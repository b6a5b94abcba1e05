"""Findings about floors: map, graph, labels, and the robots' places. Pure."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.schema import Config
from fleet_tui.features.doctor.surveys import OFF_MAP, FloorSurvey, class_at, live_grid, surveys_of
from fleet_tui.links.discovery.facts import TopicFacts
from fleet_tui.links.discovery.finding import Finding, Verdict, listed, nearest
from fleet_tui.model.events import FloorGraphLoaded, FloorMapLoaded, PoseReported
from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.graph import Role, RouteGraph
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.navigation_events import LocalisationReported
from fleet_tui.model.occupancy import FREE, OCCUPIED, UNKNOWN
from fleet_tui.model.order import natural


def graph_file_finding(floor: FloorEntry, file: FloorGraphLoaded | None, needing: int) -> Finding:
    """Judge whether a graph file exists if robots need one, and was read completely."""
    if file is None:
        absent = (
            f"none, and {needing} of its robots publish{'es' * (needing == 1)} no graph: places have no names"
        )
        remedy = "set floors.graph of this floor to a graph file, such as GeoJSON"
        return Finding(floor.name, "graph file", Verdict.SKIPPED, absent, remedy)
    if file.graph is not None and not needing:
        unused = f"{floor.graph} unused: all robots of the floor publish a graph"
        return Finding(floor.name, "graph file", Verdict.WARN, unused, "remove floors.graph")
    if file.graph is None:
        remedy = "correct floors.graph of this floor"
        return Finding(floor.name, "graph file", Verdict.FAIL, file.problem, remedy)
    if file.problem:
        return Finding(floor.name, "graph file", Verdict.WARN, file.problem, "correct the file")
    counts = f"{len(file.graph.vertices)} vertices, {len(file.labels)} labels"
    return Finding(floor.name, "graph file", Verdict.OK, f"{floor.graph}: {counts}")


def connection_finding(
    floor: FloorEntry, by: str, survey: FloorSurvey, graph: RouteGraph, has_others: bool
) -> Finding:
    """Judge whether all vertices can be reached from every other."""
    lost = _cut_off(graph, has_others)
    count = f"{len(graph.edges)} edges{by}"
    if not lost:
        return Finding(floor.name, "graph", Verdict.OK, f"{count}, all vertices reachable")
    names = listed([survey.name_of(vertex) for vertex in sorted(lost, key=natural)])
    return Finding(
        floor.name,
        "graph",
        Verdict.FAIL,
        f"{count}: {len(lost)} of {len(graph.vertices)} vertices unreachable: {names}",
        "add the missing edges: orders to or from there will stall",
    )


def _cut_off(graph: RouteGraph, has_others: bool) -> set[str]:
    """Return the vertices to or from which the largest part of the graph has no way. Elevators connect over
    the other floors."""
    onward: dict[str, set[str]] = {id_: set() for id_ in graph.vertices}
    backward: dict[str, set[str]] = {id_: set() for id_ in graph.vertices}
    shafts = (
        [id_ for id_, vertex in graph.vertices.items() if vertex.role is Role.ELEVATOR] if has_others else []
    )
    pairs = [(edge.start, edge.end) for edge in graph.edges]
    pairs += [(shafts[0], shaft) for shaft in shafts[1:]] + [(shaft, shafts[0]) for shaft in shafts[1:]]
    if not graph.directed:
        pairs += [(end, start) for start, end in pairs]
    for start, end in pairs:
        onward[start].add(end)
        backward[end].add(start)
    largest, rest = set[str](), set(graph.vertices)
    while len(rest) > len(largest):
        start = min(rest)
        part = _reached(start, onward) & _reached(start, backward)
        largest = max(largest, part, key=len)
        rest -= part
    return set(graph.vertices) - largest


def _reached(start: str, ways: Mapping[str, set[str]]) -> set[str]:
    seen, todo = {start}, [start]
    while todo:
        new = ways[todo.pop()] - seen
        seen |= new
        todo.extend(new)
    return seen


def label_finding(floor: FloorEntry, by: str, labels: Mapping[str, str], graph: RouteGraph) -> Finding:
    """Judge whether each label names exactly one vertex."""
    lost = [f"{label} ({vertex})" for vertex, label in labels.items() if vertex not in graph.vertices]
    if lost:
        measured = f"{len(lost)} of {len(labels)} labels{by} name a missing vertex: {listed(lost)}"
        remedy = "check that labels and graph match, and the label's id field"
        return Finding(floor.name, "labels", Verdict.FAIL, measured, remedy)
    twice = sorted({label for label in labels.values() if list(labels.values()).count(label) > 1})
    if twice:
        remedy = "make labels unique: orders by label use the first match"
        return Finding(floor.name, "labels", Verdict.WARN, f"duplicate{by}: {listed(twice)}", remedy)
    if not labels:
        return Finding(
            floor.name,
            "labels",
            Verdict.WARN,
            f"none{by}",
            "publish labels: without them orders need vertex ids",
        )
    return Finding(floor.name, "labels", Verdict.OK, f"{len(labels)} labels{by}, all valid")


class FloorFiles(NamedTuple):
    """The files of a floor, None if not configured."""

    map: FloorMapLoaded | None = None
    graph: FloorGraphLoaded | None = None


def floor_findings(
    config: Config, floor: FloorEntry, files: FloorFiles, mute: list[RobotEntry], topics: list[TopicFacts]
) -> Iterator[Finding]:
    """Judge the floor's map, then each different report of it. `mute`: robots that publish no graph."""
    loaded, file = files
    grid = loaded.grid if loaded else live_grid(floor.name, topics)
    yield _map(floor, loaded, grid)
    surveys = surveys_of(floor.name, topics)
    needing = [robot for robot in mute if floor.name in config.floors_of(robot)]
    if file is not None or needing:
        yield graph_file_finding(floor, file, len(needing))
        if file is not None and file.graph is not None:
            surveys.append((FloorSurvey(file.graph, file.labels), [floor.graph]))
    for survey, robots in surveys:
        by = f" by {listed(robots)}" if len(surveys) > 1 else ""
        if grid is not None and survey.frame is not None:
            yield _sizes(floor, by, grid.frame, survey.frame, loaded is None or loaded.tied)
        placed = placed_grid(loaded, topics, floor.name, survey)
        if survey.graph is not None:
            yield _vertices(floor, by, survey, survey.graph, placed)
            yield connection_finding(floor, by, survey, survey.graph, len(config.floors) > 1)
        if survey.graph is not None and survey.labels is not None:
            yield label_finding(floor, by, survey.labels, survey.graph)


def placed_grid(
    loaded: FloorMapLoaded | None, topics: list[TopicFacts], floor: str, survey: FloorSurvey
) -> OccupancyGrid | None:
    """Return a floor's map at its place in the world: a plain image is placed by a report's map_metadata."""
    grid = loaded.grid if loaded else live_grid(floor, topics)
    if grid is None or loaded is None or loaded.tied:
        return grid
    return OccupancyGrid(survey.frame, grid.levels) if survey.frame else None


def _map(floor: FloorEntry, loaded: FloorMapLoaded | None, grid: OccupancyGrid | None) -> Finding:
    if loaded is not None and loaded.problem:
        return Finding(floor.name, "map", Verdict.FAIL, loaded.problem, "correct floors.map of this floor")
    if grid is None:
        nothing = "no map file configured and no live map received"
        remedy = "set floors.map or publish the map: until then the floor is blank"
        return Finding(floor.name, "map", Verdict.WARN, nothing, remedy)
    source = floor.map if loaded else "the live map"
    return Finding(floor.name, "map", Verdict.OK, f"{source}: {_size(grid.frame)}")


def _size(frame: MapFrame) -> str:
    return f"{frame.width} x {frame.height} px, {frame.resolution:.3g} m each"


def _sizes(floor: FloorEntry, by: str, map_: MapFrame, reported: MapFrame, tied: bool) -> Finding:
    """Judge whether the picture and map_metadata describe one map; a plain image has only its size."""
    same = (map_.width, map_.height) == (reported.width, reported.height)
    if same and tied:
        pixel = reported.resolution
        same = abs(map_.resolution - pixel) < 1e-4 * pixel and all(
            abs(one - other) < pixel
            for one, other in (
                (map_.origin.x, reported.origin.x),
                (map_.origin.y, reported.origin.y),
                (map_.origin.yaw, reported.origin.yaw),
            )
        )
    if same:
        return Finding(floor.name, "map size", Verdict.OK, f"agrees with map_metadata{by}")
    return Finding(
        floor.name,
        "map size",
        Verdict.FAIL,
        f"map {_place(map_)}, map_metadata{by} {_place(reported)}",
        "use the map the robots drive by, or restart their map server",
    )


def _place(frame: MapFrame) -> str:
    return f"{_size(frame)} from ({frame.origin.x:.2f}, {frame.origin.y:.2f})"


def _vertices(
    floor: FloorEntry, by: str, survey: FloorSurvey, graph: RouteGraph, grid: OccupancyGrid | None
) -> Finding:
    count = f"{len(graph.vertices)} vertices{by}"
    if not graph.vertices:
        return Finding(floor.name, "vertices", Verdict.FAIL, f"none in the graph{by}", "reload the graph")
    if grid is None:
        return Finding(floor.name, "vertices", Verdict.SKIPPED, f"{count}, no map to check them against")
    found: dict[int, list[str]] = {FREE: [], OCCUPIED: [], UNKNOWN: [], OFF_MAP: []}
    for vertex in graph.vertices.values():
        type_ = f", type {vertex.type}," if vertex.type else ""
        place = f"{survey.name_of(vertex.id)}{type_} at ({vertex.x:.2f}, {vertex.y:.2f})"
        found[class_at(grid, vertex.x, vertex.y)].append(place)
    remedy = 'check that map and graph match, and [profile] origin ("ros" or "added")'
    if found[OFF_MAP]:
        off = f"{len(found[OFF_MAP])} of {count} off the map: {listed(found[OFF_MAP])}"
        return Finding(floor.name, "vertices", Verdict.FAIL, off, remedy)
    if found[OCCUPIED]:
        walled = f"{len(found[OCCUPIED])} of {count} in a wall: {listed(found[OCCUPIED])}"
        return Finding(floor.name, "vertices", Verdict.FAIL, walled, remedy)
    if found[UNKNOWN]:
        unknown = f"{len(found[UNKNOWN])} of {count} on unknown ground: {listed(found[UNKNOWN])}"
        return Finding(floor.name, "vertices", Verdict.WARN, unknown, remedy)
    return Finding(floor.name, "vertices", Verdict.OK, f"{count}, all on free ground")


Placed = PoseReported | LocalisationReported


def place_finding(
    config: Config, pose: Placed, grids: Mapping[str, OccupancyGrid | None], floors: list[str], reported: str
) -> Finding:
    """Judge whether a robot is on a map it knows. `reported`: the floor by its own report, if its frame means
    none."""
    if isinstance(pose, LocalisationReported):
        return _place_on(pose, grids, floors, reported)
    frame = pose.frame_id.lstrip("/")
    floor = next((floor for floor in config.floors if floor.frame == frame), None)
    if floor is None:
        near = nearest(frame, [one.frame for one in config.floors])
        remedy = f'set frame_id = "{frame}" on its floor' + (f" (nearest: {near[0]})" if near else "")
        measured = f"pose frame {pose.frame_id!r} matches no floor"
        return Finding(pose.robot, "place", Verdict.FAIL, measured, remedy)
    return _place_on(pose, grids, floors, floor.name)


def _place_on(
    pose: Placed, grids: Mapping[str, OccupancyGrid | None], floors: list[str], floor: str
) -> Finding:
    at = f"({pose.pose.x:.2f}, {pose.pose.y:.2f}) on {floor or 'an unknown floor'}"
    if not floor:
        remedy = 'set [[robots]] floors = ["NAME"], or [profile.topics] floor'
        return Finding(pose.robot, "place", Verdict.WARN, at, remedy)
    if floor not in floors:
        remedy = f"add {floor} to its floors in the configuration"
        return Finding(pose.robot, "place", Verdict.WARN, f"{at}, not one of its floors", remedy)
    grid = grids.get(floor)
    if grid is None:
        return Finding(pose.robot, "place", Verdict.SKIPPED, f"{at}, no map to check it against")
    ground = class_at(grid, pose.pose.x, pose.pose.y)
    if ground == OFF_MAP:
        remedy = "check the floor's map and the robot's localisation"
        return Finding(pose.robot, "place", Verdict.FAIL, f"{at} is off the map", remedy)
    if ground == OCCUPIED:
        remedy = "check the robot's localisation, and whether the map is current"
        return Finding(pose.robot, "place", Verdict.WARN, f"{at} is in a wall", remedy)
    return Finding(pose.robot, "place", Verdict.OK, f"{at}, {'free' if ground == FREE else 'unknown'} ground")
