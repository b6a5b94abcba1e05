"""Lint by the format or robot stack that a graph is for."""

import math
from collections.abc import Iterator
from itertools import combinations, pairwise

from fleet_tui.features.graphs.rules.finding import GraphFinding, LintInputs
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graphs.document import DocumentFloor, GraphDocument, GraphFormat, Lift
from fleet_tui.text.language import Message

LIFT_STOPS = 0.1
"""Metres by which the stops of a lift may be apart in the site's frame."""
UINT16 = 65535


def of_target(document: GraphDocument, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Return what the target refuses or can't report; an empty graph is one of which nothing was read."""
    if not any(floor.vertices for floor in document.floors.values()):
        yield GraphFinding("empty", Message("no vertex: nothing to drive on was read"), True)
    elif inputs.target is GraphFormat.RMF:
        yield from _labels_of_site(document)
        yield from _lifts(document)
    elif inputs.target is GraphFormat.GEOJSON:
        for floor in document.floors.values():
            yield from _nav2(floor)
    elif inputs.target is GraphFormat.LIF and not inputs.vehicle_type:
        for floor in document.floors.values():
            yield from _vehicles(floor)


def _labels_of_site(document: GraphDocument) -> Iterator[GraphFinding]:
    taken = dict[str, tuple[str, str]]()
    for floor in document.floors.values():
        for id_, label in floor.labels.items():
            other = taken.setdefault(label, (floor.name, id_))
            if other[0] != floor.name:
                text = Message(
                    "vertex {id}: label {label} is taken on {other}; RMF allows one per site",
                    id=id_,
                    label=f"{label!r}",
                    other=other[0],
                )
                yield GraphFinding("site label", text, True, floor.name, (id_,))


def _lifts(document: GraphDocument) -> Iterator[GraphFinding]:
    for lift in document.lifts:
        places = list(_stops(document, lift))
        for one, other in pairwise(places):
            metres = math.dist(one[2], other[2])
            if metres > LIFT_STOPS:
                text = Message(
                    "lift {name}: its stops on {one} and {other} are {metres} m apart",
                    name=lift.name,
                    one=one[0],
                    other=other[0],
                    metres=f"{metres:.2f}",
                )
                yield GraphFinding("lift stops", text, True, other[0], (other[1],))
        for one, other in combinations(places, 2):
            if one[0] == other[0]:
                text = Message("lift {name}: two stops on {one}", name=lift.name, one=one[0])
                yield GraphFinding("lift stops", text, True, one[0], (one[1], other[1]))


def _stops(document: GraphDocument, lift: Lift) -> Iterator[tuple[str, str, tuple[float, float]]]:
    """Yield floor, vertex and place in the site of each stop, in the order of the floors."""
    for name, floor in document.floors.items():
        for at, id_ in lift.stops:
            vertex = floor.vertices.get(id_)
            if at == name and vertex is not None:
                place = Pose(*floor.to_site).after(Pose(vertex.x, vertex.y))
                yield name, id_, (place.x, place.y)


def _nav2(floor: DocumentFloor) -> Iterator[GraphFinding]:
    if not floor.edges:
        text = Message("no edge: Nav2 does not load such a graph")
        yield GraphFinding("empty", text, True, floor.name)
    for kind, ids in (("vertex", floor.vertices), ("edge", floor.edges)):
        for id_ in ids:
            if id_.isascii() and id_.isdecimal() and (len(id_) > 9 or int(id_) > UINT16):
                text = Message(
                    "{kind} {id}: id over {limit}, too large for Nav2's messages",
                    kind=Message(kind),
                    id=id_,
                    limit=UINT16,
                )
                of_vertex, of_edge = ((id_,), ()) if kind == "vertex" else ((), (id_,))
                yield GraphFinding("nav2 id", text, True, floor.name, of_vertex, of_edge)


def _vehicles(floor: DocumentFloor) -> Iterator[GraphFinding]:
    own, key = GraphFormat.LIF.value, "vehicleTypeNodeProperties"
    bare = tuple(id_ for id_, vertex in floor.vertices.items() if not vertex.extra.get(own, {}).get(key))
    edges = tuple(id_ for id_, edge in floor.edges.items() if not edge.per_vehicle)
    if bare or edges:
        text = Message(
            "no vehicle type at {bare} vertices and {edges} edges: no vehicle may use them",
            bare=len(bare),
            edges=len(edges),
        )
        yield GraphFinding("vehicle type", text, True, floor.name, bare[:10], edges[:10])
