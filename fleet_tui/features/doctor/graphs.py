"""Findings about a floor's graph: its file, its connections, its labels. Pure."""

from collections.abc import Mapping

from fleet_tui.config.entries import FloorEntry
from fleet_tui.features.doctor.surveys import FloorSurvey
from fleet_tui.links.discovery.finding import Finding, Verdict, listed
from fleet_tui.model.events import FloorGraphLoaded
from fleet_tui.model.graph import Role, RouteGraph
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
