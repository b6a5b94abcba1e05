"""Edges of a floor's graph by the names of their ends."""

from fleet_tui.commands.language.words import said
from fleet_tui.model.desk.desk import Ends, ends_of
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.robot import Robot
from fleet_tui.text.errors import CommandError, did_you_mean
from fleet_tui.text.language import Message
from fleet_tui.text.limits import some


def edge_named(robot: Robot, floor: str, start: str, end: str) -> Ends:
    """Return the edge between two labels or ids of a floor. Raises CommandError."""
    robot_map = robot.maps.get(floor)
    if robot_map is None or robot_map.graph is None:
        raise CommandError(Message("{name} has no graph of {floor}", name=robot.name, floor=floor))
    one, other = (_vertex(robot, floor, robot_map.graph, word) for word in (start, end))
    joined = {_other(edge.start, edge.end, one) for edge in robot_map.graph.edges} - {""}
    if other not in joined:
        names = sorted(robot_map.labels.get(vertex, vertex) for vertex in joined)
        raise CommandError(
            Message(
                "no edge {start} - {end} on {floor}: {start} connects to {others}",
                start=start,
                end=end,
                floor=floor,
                others=some(names),
            )
        )
    return ends_of(floor, one, other)


def _other(start: str, end: str, one: str) -> str:
    return end if start == one else start if end == one else ""


def _vertex(robot: Robot, floor: str, graph: RouteGraph, word: str) -> str:
    """Return the vertex of a label or an id on a floor. Raises CommandError."""
    id_ = word.removeprefix("id=")
    labels = robot.maps[floor].labels
    found = [one for one, label in labels.items() if label == word and one in graph.vertices]
    found = found or [one for one, label in labels.items() if label.casefold() == word.casefold()]
    if len(found) == 1 and not word.startswith("id="):
        return found[0]
    if id_ in graph.vertices:
        return id_
    if found:
        raise CommandError(
            Message(
                "{said} is ambiguous: use {ids}",
                said=said(word),
                ids=" or ".join(f"id={one}" for one in found),
            )
        )
    raise CommandError(
        Message(
            "no place {said} on {floor}{did_you_mean}",
            said=said(word),
            floor=floor,
            did_you_mean=did_you_mean(word, labels.values()),
        )
    )


def edge_text(robot: Robot, ends: Ends, between: str = " - ") -> str:
    """Return an edge by the labels of its ends, else their ids."""
    floor, *vertices = ends
    robot_map = robot.maps.get(floor)
    labels = robot_map.labels if robot_map is not None else {}
    return between.join(labels.get(vertex, vertex) for vertex in vertices)
