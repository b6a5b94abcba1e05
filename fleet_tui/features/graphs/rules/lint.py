"""Lint: all rules over a floor, and over the document that it is in."""

from collections.abc import Iterable, Iterator

from msgspec.structs import replace

from fleet_tui.features.graphs.rules.elements import ELEMENT_RULES, named
from fleet_tui.features.graphs.rules.finding import GraphFinding, LintInputs, limited
from fleet_tui.features.graphs.rules.neighbours import neighbours
from fleet_tui.features.graphs.rules.reach import reach
from fleet_tui.features.graphs.rules.targets import of_target
from fleet_tui.model.graph import Role
from fleet_tui.model.graphs.document import DocumentFloor, GraphDocument
from fleet_tui.model.graphs.live import route_graph
from fleet_tui.text.language import Message


def lint(document: GraphDocument, inputs: LintInputs) -> tuple[GraphFinding, ...]:
    """Return the findings on all floors of a document, errors first.

    The map, the orders and the live graph of `inputs` are those of every floor: give them with one floor.
    """
    found = list[GraphFinding]()
    for floor in document.floors.values():
        found += lint_floor(floor, replace(inputs, elsewhere=_elsewhere(document, floor, inputs)))
    found += limited(list(of_target(document, inputs)))
    found += limited(list(_lost_stops(document)))
    found += _docking(document.floors.values(), inputs)
    return _errors_first(found)


def _lost_stops(document: GraphDocument) -> Iterator[GraphFinding]:
    """Yield the stops of lifts and stations that are not in the document."""
    stops = [("lift", one.name, stop) for one in document.lifts for stop in one.stops]
    stops += [("station", one.name, stop) for one in document.stations for stop in one.stops]
    for kind, name, (floor, id_) in stops:
        if floor not in document.floors:
            yield GraphFinding(
                "stop",
                Message(
                    "{kind} {name}: stops on unknown floor {floor}",
                    kind=Message(kind),
                    name=name,
                    floor=floor,
                ),
                True,
            )
        elif id_ not in document.floors[floor].vertices:
            text = Message(
                "{kind} {name}: stops at unknown vertex {id} on {floor}",
                kind=Message(kind),
                name=name,
                id=id_,
                floor=floor,
            )
            yield GraphFinding("stop", text, True, floor)


def lint_floor(floor: DocumentFloor, inputs: LintInputs) -> tuple[GraphFinding, ...]:
    """Return the findings on one floor, errors first, without those about the site as a whole."""
    groups = [list(rule(floor, inputs)) for rule in ELEMENT_RULES]
    groups += neighbours(floor)
    groups.append(_unreachable(floor, inputs))
    if inputs.grid is not None and floor.vertices:
        from fleet_tui.features.graphs.rules.clearance import clearance  # not without a map

        groups += clearance(floor, inputs.grid, inputs.width)
    found = [one for group in groups for one in limited(group)]
    return _errors_first(replace(one, floor=floor.name) for one in found)


def _errors_first(findings: Iterable[GraphFinding]) -> tuple[GraphFinding, ...]:
    return tuple(sorted(findings, key=lambda one: not one.is_error))


def _elsewhere(document: GraphDocument, floor: DocumentFloor, inputs: LintInputs) -> frozenset[str] | None:
    """Return the labels of elevators on other floors; those of lifts count wherever they stop."""
    others = [one for one in document.floors.values() if one.name != floor.name]
    if not others:
        return None if inputs.elsewhere is None else frozenset(inputs.elsewhere)
    found = {
        vertex.label
        for one in others
        for vertex in one.vertices.values()
        if inputs.roles(vertex.type) is Role.ELEVATOR
    }
    for lift in document.lifts:
        if len({name for name, _ in lift.stops}) > 1:
            found |= {floor.vertices[id_].label for _, id_ in lift.stops if id_ in floor.vertices}
    return frozenset(found | set(inputs.elsewhere or ()))


def _unreachable(floor: DocumentFloor, inputs: LintInputs) -> list[GraphFinding]:
    graph, labels = route_graph(floor, inputs.roles)
    found = reach(graph, labels, with_lifts=bool(inputs.elsewhere))
    return [
        GraphFinding(
            "reach",
            Message(
                "vertex {named}: {reason}", named=named(floor.vertices[id_]), reason=_reason(id_, found.traps)
            ),
            False,
            "",
            (id_,),
        )
        for id_ in found.lost
    ]


def _reason(id_: str, traps: tuple[str, ...]) -> Message:
    return (
        Message("a dead end, no way back to the others")
        if id_ in traps
        else Message("not reachable from the others")
    )


def _docking(floors: Iterable[DocumentFloor], inputs: LintInputs) -> list[GraphFinding]:
    types = {vertex.type for floor in floors for vertex in floor.vertices.values()}
    if not types or any(inputs.roles(type_) is Role.DOCKING for type_ in types):
        return []
    return [GraphFinding("docking", Message("no docking vertex"), False)]
