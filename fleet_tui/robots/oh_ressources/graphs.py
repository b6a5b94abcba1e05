"""Drawn graphs as messages to these robots, which have one-way edges only if their profile says so."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import count

from msgspec.structs import replace

from fleet_tui.model.graph import Edge, Vertex
from fleet_tui.model.set_up.commands import SendGraph
from fleet_tui.robots.adapter import Publication
from fleet_tui.robots.oh_ressources.calls import int32, named
from fleet_tui.robots.ros.facts import is_place
from fleet_tui.robots.ros.names import Names
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message

OWN = {"graph_save": "graph", "labels_save": "labels"}
"""Topics on which a robot takes its graph and its labels, with those on which it publishes them."""


def unset_key(names: Names) -> str:
    """Return the key of the profile that is empty, so that no graph can be sent; empty if none is."""
    missing = (key for key in OWN if not names.topic(key, "robot", "floor"))
    return next((f"{names.table}.topics.{key}" for key in missing), "")


def graph_messages(names: Names, command: SendGraph) -> Sequence[Publication]:
    """Return the messages of a graph and its labels. Raises CommandError for a graph that must not be sent.

    The graph is the first: a robot that checks new labels against its vertices would drop those of new
    vertices for good. Labels of vertices that are gone last only until the second message.
    """
    graph = {
        "vertices": [_vertex(names, vertex) for vertex in command.vertices],
        "edges": [_edge(names, edge) for edge in _edges(command, names)],
    }
    labels = [
        named(names, "label", {"label": label, "vertex_id": _number("vertex", id_)})
        for id_, label in command.labels
    ]
    return (
        _publication(names, command, "graph_save", named(names, "graph", graph)),
        _publication(names, command, "labels_save", named(names, "labels", {"vertices": labels})),
    )


def _publication(names: Names, command: SendGraph, key: str, message: Mapping[str, object]) -> Publication:
    topic = names.topic(key, command.robot, command.floor)
    if not topic:
        raise CommandError(Message("{table}.topics.{key} is empty", table=names.table, key=key))
    if topic in {names.topic(own, command.robot, command.floor) for own in OWN.values()}:
        # Both publishers latch there: a late subscriber would get either.
        text = Message(
            "{topic} is the robot's own topic: name another one in {table}.topics.{key}",
            topic=topic,
            table=names.table,
            key=key,
        )
        raise CommandError(text)
    return Publication(topic, names.type(key), message)


def _vertex(names: Names, vertex: Vertex) -> dict[str, object]:
    if not is_place(vertex.x, vertex.y):
        raise CommandError(Message("vertex {name} has no finite position", name=vertex.id))
    scale = names.scale("vertex")
    number = _number("vertex", vertex.id)
    fields = {"id": number, "x": vertex.x / scale, "y": vertex.y / scale, "type": vertex.type}
    return named(names, "vertex", fields)


def _edge(names: Names, edge: Edge) -> dict[str, object]:
    start, end = (_number("vertex", id_) for id_ in (edge.start, edge.end))
    return named(names, "edge", {"id": _number("edge", edge.id), "start": start, "end": end})


def _number(what: str, id_: str) -> int:
    number = int32(id_, what)
    if str(number) != id_:
        raise CommandError(
            Message(
                "{what} {name} would come back as {number}: write it that way",
                what=what,
                name=f"{id_!r}",
                number=number,
            )
        )
    return number


def _edges(command: SendGraph, names: Names) -> Iterator[Edge]:
    """Return the edges as such robots have them: with a direction or without."""
    is_directed, pairs = names.profile.directed, {(edge.start, edge.end) for edge in command.edges}
    if is_directed == command.directed:
        yield from command.edges
    elif is_directed:
        yield from command.edges
        free = count(1 + max((_number("edge", edge.id) for edge in command.edges), default=0))
        for edge in command.edges:
            if (edge.end, edge.start) not in pairs:
                yield replace(edge, id=str(next(free)), start=edge.end, end=edge.start)
    else:
        yielded = set[tuple[str, str]]()
        for edge in command.edges:
            back = edge.end, edge.start
            if back not in pairs:
                one_way = f"edge {edge.id} leads one way only"
                text = Message(
                    "{one_way}, these robots' edges lead both ways: see {table}.directed",
                    one_way=one_way,
                    table=names.table,
                )
                raise CommandError(text)
            if back not in yielded:
                yielded.add((edge.start, edge.end))
                yield edge
