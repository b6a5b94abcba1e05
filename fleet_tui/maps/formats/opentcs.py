"""Plant models of openTCS 6 and 7, to be read: XML, millimetres, degrees."""

import math
import re
from collections.abc import Iterator
from typing import Any
from xml.etree.ElementTree import Element, ParseError  # only types and an error: parsing is defusedxml's

from defusedxml import DefusedXmlException
from defusedxml.ElementTree import fromstring

from fleet_tui.maps.formats import fields
from fleet_tui.maps.formats.fields import Table
from fleet_tui.maps.formats.graph_file import GraphFile, ReadChoices
from fleet_tui.model.graphs.document import (
    DocumentEdge,
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    GraphFormat,
    Motion,
    Polyline,
    Station,
)
from fleet_tui.model.graphs.ids import distinct
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import MOST_EDGES, MOST_VERTICES, truncate

OWN = GraphFormat.OPENTCS.value
VERSIONS = ("6", "7")
MM = 0.001
_INTEGER = re.compile(r"[-+]?[0-9]{1,18}")
_HEAD = re.compile(r"""\s*<\?xml(?:[^>]*?\sencoding\s*=\s*["']([\w.-]{1,40})["'])?[^>]*\?>""")
_OTHERS = {"vehicle": "vehicles", "block": "blocks", "locationType": "location types"}


def parse_xml(text: str) -> Element:
    """Return the root of a file, read as UTF-8. Raises GraphError for bad XML, a DTD or entities."""
    head = _HEAD.match(text)
    encoding = (head and head[1]) or "UTF-8"
    try:
        if "\0" in text or text.encode(encoding, "replace") != text.encode():
            raise GraphError(
                Message(
                    "not in {encoding}, the encoding that it declares: save it as UTF-8", encoding=encoding
                )
            )
        root = fromstring(text[head.end() if head else 0 :], forbid_dtd=True)
    except LookupError:
        raise GraphError(
            Message("unknown encoding {encoding}: save it as UTF-8", encoding=encoding)
        ) from None
    except DefusedXmlException:
        raise GraphError(Message("a DTD or entities, which are not read: remove them")) from None
    except ParseError as problem:
        line, _ = problem.position
        raise GraphError(
            Message(
                "not XML: {partition} in line {line}", partition=str(problem).partition(":")[0], line=line
            )
        ) from None
    except (ValueError, RecursionError) as problem:
        raise GraphError(Message("not XML: {problem}", problem=truncate(str(problem), 200))) from None
    if not isinstance(root, Element):
        raise GraphError(Message("not XML: no element"))
    return root


def read(tree: Any, choices: ReadChoices) -> GraphFile:
    """Return the document of a plant model. Raises GraphError."""
    root: Element = tree
    version = root.get("version", "")
    if version.partition(".")[0] not in VERSIONS:
        raise GraphError(
            Message(
                "plant model {version}: save it with openTCS 6 or 7", version=f"{truncate(version, 20)!r}"
            )
        )
    points, locations = (_elements(root, tag, MOST_VERTICES) for tag in ("point", "location"))
    paths = _elements(root, "path", MOST_EDGES)
    named = _linked(locations)
    places = {_name(one): _z(one) for one in points}
    names = _floors(places, choices.floor)
    vertices = [
        (names[_z(one)], vertex) for one, vertex in zip(points, _vertices(points, named), strict=True)
    ]
    edges = list(_edges(paths, _scale(root), {vertex.id: vertex for _, vertex in vertices}))
    floors = {
        floor: DocumentFloor(
            floor,
            {vertex.id: vertex for at, vertex in vertices if at == floor},
            {edge.id: edge for edge in edges if names.get(places.get(edge.start, 0.0)) == floor},
        )
        for floor in dict.fromkeys(names.values())
    }
    at = {vertex.id: floor for floor, vertex in vertices}
    stations = tuple(_station(one, at) for one in locations)
    counts = {text: len(root.findall(tag)) for tag, text in _OTHERS.items()}
    document = GraphDocument(root.get("name", ""), floors, (), stations)
    left_out = {text: count for text, count in counts.items() if count}
    return GraphFile(GraphFormat.OPENTCS, document, (), left_out)


def _elements(root: Element, tag: str, most: int) -> list[Element]:
    found = root.findall(tag)
    if len(found) > most:
        raise GraphError(
            Message(
                "{count} {tag}s, at most {most} are supported",
                count=f"{len(found):,}",
                tag=tag,
                most=f"{most:,}",
            )
        )
    return found


def _floors(places: dict[str, float], name: str) -> dict[float, str]:
    """Return the floor of each height: one floor unless heights differ."""
    heights = sorted(set(places.values())) or [0.0]
    return {z: name if len(heights) == 1 else f"{z:g} m" for z in heights}


def _name(element: Element) -> str:
    return fields.identifier(element.get("name"), f"{element.tag} name")


def _millimetres(element: Element, key: str, default: str | None = None) -> float:
    """Return an attribute in millimetres as metres."""
    text = element.get(key, default)
    if text is None or not _INTEGER.fullmatch(text.strip()):
        where = f"{element.tag} {truncate(element.get('name', ''), 40)!r} {key}"
        shown = "nothing" if text is None else truncate(repr(text), 40)
        raise GraphError(Message("{where}: {shown} instead of whole millimetres", where=where, shown=shown))
    return int(text) / 1000


def _z(point: Element) -> float:
    return _millimetres(point, "positionZ", "0")


def _linked(locations: list[Element]) -> dict[str, tuple[str, str]]:
    """Return the name and type of the location at each point: of the only one, and not of those with several
    points."""
    found: dict[str, list[tuple[str, str]]] = {}
    for location in locations:
        links = {link.get("point", "") for link in location.findall("link")}
        if len(links) == 1:
            found.setdefault(links.pop(), []).append((_name(location), location.get("type", "")))
    return {point: those[0] for point, those in found.items() if len(those) == 1}


def _vertices(points: list[Element], named: dict[str, tuple[str, str]]) -> Iterator[DocumentVertex]:
    for (id_, repeats), point in zip(distinct(map(_name, points)), points, strict=True):
        name = (*repeats, id_)[0]
        label, type_ = named.get(name, (name, ""))
        kind = point.get("type", "HALT_POSITION")
        x, y = _millimetres(point, "positionX"), _millimetres(point, "positionY")
        extra = _properties(point)
        yield DocumentVertex(
            id_,
            x,
            y,
            label,
            type_ if type_ and kind == "HALT_POSITION" else kind,
            _heading(point),
            "",
            {OWN: extra} if extra else {},
            repeats,
        )


def _heading(point: Element) -> float | None:
    """Return the orientation at a point in radians; NaN is none."""
    text = point.get("vehicleOrientationAngle", "NaN")
    try:
        degrees = float(text)
    except ValueError:
        where = f"point {truncate(_name(point), 40)!r} vehicleOrientationAngle"
        raise GraphError(
            Message("{where}: {given} instead of degrees", where=where, given=truncate(repr(text), 40))
        ) from None
    return math.radians(degrees) if math.isfinite(degrees) else None


def _properties(element: Element) -> Table:
    found = {one.get("name", ""): one.get("value", "") for one in element.findall("property")}
    return {"properties": found} if found else {}


def _length(path: Element, start: DocumentVertex | None, end: DocumentVertex | None) -> float | None:
    """Return the length of a path, None where it is the distance as far as whole millimetres tell."""
    if not path.get("length"):
        return None
    metres = _millimetres(path, "length")
    straight = math.dist((start.x, start.y), (end.x, end.y)) if start and end else math.inf
    return None if abs(metres - straight) < 2 * MM else metres


def _edges(
    paths: list[Element], scale: tuple[float, float], places: dict[str, DocumentVertex]
) -> Iterator[DocumentEdge]:
    for (id_, repeats), path in zip(distinct(map(_name, paths)), paths, strict=True):
        ahead, back = (_millimetres(path, key, "0") for key in ("maxVelocity", "maxReverseVelocity"))
        ends = [
            fields.identifier(path.get(key), f"path {id_[:40]}")
            for key in ("sourcePoint", "destinationPoint")
        ]
        points = _control_points(path, scale)
        if back > 0 >= ahead:
            ends, points = ends[::-1], points[::-1]
        own = _properties(path) | (
            {"reverse_speed": back} if back > 0 and ahead > 0 and back != ahead else {}
        )
        layout = path.find("pathLayout")
        own |= {"connectionType": layout.get("connectionType")} if layout is not None and points else {}
        yield DocumentEdge(
            id_,
            ends[0],
            ends[1],
            two_way=ahead > 0 and back > 0,
            speed=ahead or back or None,
            locked=path.get("locked") == "true" or ahead <= 0 >= back,
            motion=_motion(ahead, back),
            length=_length(path, places.get(ends[0]), places.get(ends[1])),
            control_points=points,
            extra={OWN: own} if own else {},
            repeats=repeats,
        )


def _motion(ahead: float, back: float) -> Motion:
    """Return the motion of a path that leads one way; on others it depends on the direction."""
    if ahead > 0 >= back:
        return Motion.FORWARD
    return Motion.BACKWARD if back > 0 >= ahead else Motion.ANY


def _scale(root: Element) -> tuple[float, float]:
    """Return the metres per unit of the drawing, along x and y."""
    layout = root.find("visualLayout")
    if layout is None:
        return 0.05, 0.05
    numbers = []
    for key in ("scaleX", "scaleY"):
        try:
            numbers.append(float(layout.get(key, "50.0")) * MM)
        except ValueError:
            raise GraphError(Message("visualLayout {key}: not a number", key=key)) from None
    return numbers[0], numbers[1]


def _control_points(path: Element, scale: tuple[float, float]) -> Polyline:
    """Return the control points in metres: the drawing's y goes down."""
    found = []
    for point in path.iter("controlPoint"):
        try:
            x, y = float(point.get("x", "")), float(point.get("y", ""))
        except ValueError:
            raise GraphError(
                Message("path {name}: a control point without x and y", name=f"{truncate(_name(path), 40)!r}")
            ) from None
        found.append((x * scale[0], -y * scale[1]))
    return tuple(found)


def _station(location: Element, at: dict[str, str]) -> Station:
    points = [link.get("point", "") for link in location.findall("link")]
    stops = tuple((at[point], point) for point in points if point in at)
    x, y = _millimetres(location, "positionX", "0"), _millimetres(location, "positionY", "0")
    own: Table = {"type": location.get("type", ""), **_properties(location)}
    own |= {"locked": True} if location.get("locked") == "true" else {}
    return Station(_name(location), stops, x, y, extra={OWN: own})
