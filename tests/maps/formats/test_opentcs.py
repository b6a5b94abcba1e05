"""Plant models of openTCS."""

import math

import pytest

from fleet_tui.maps.formats.opentcs import parse_xml
from fleet_tui.model.graphs.document import GraphFormat, Motion
from fleet_tui.text.errors import GraphError
from tests.support.graph_files import SHARED, read_text


def plant(*parts: str, version: str = "7.0.0") -> str:
    head = '<?xml version="1.0" encoding="UTF-8"?>\n'
    return f'{head}<model version="{version}" name="p">{"".join(parts)}</model>'


def point(name: str, x: int, y: int, more: str = "") -> str:
    return f'<point name="{name}" positionX="{x}" positionY="{y}" {more}/>'


POINTS = point("a", 0, 0, 'vehicleOrientationAngle="90.0"') + point("b", 3000, 4000, 'type="PARK_POSITION"')


def path(name: str, ahead: int, back: int, more: str = 'locked="false"', inner: str = "") -> str:
    speeds = f'maxVelocity="{ahead}" maxReverseVelocity="{back}"'
    return f'<path name="{name}" sourcePoint="a" destinationPoint="b" {speeds} {more}>{inner}</path>'


def test_points_locations_and_headings() -> None:
    location = (
        '<location name="Dock 007" type="Station" positionX="1" positionY="2"><link point="a"/></location>'
    )
    both = '<location name="Two" type="T"><link point="a"/><link point="b"/></location>'
    found = read_text(plant(POINTS, location, both, '<vehicle name="v"/>'), floor="f")
    floor = found.document.floors["f"]
    assert [(one.id, one.x, one.y, one.label, one.type, one.heading) for one in floor.vertices.values()] == [
        ("a", 0.0, 0.0, "Dock 007", "Station", math.pi / 2),
        ("b", 3.0, 4.0, "b", "PARK_POSITION", None),
    ]
    assert [(one.name, one.stops) for one in found.document.stations] == [
        ("Dock 007", (("f", "a"),)),
        ("Two", (("f", "a"), ("f", "b"))),
    ]
    assert found.left_out == {"vehicles": 1}


def test_directions_are_those_of_the_velocities() -> None:
    paths = (
        path("1", 500, 0),
        path("2", 0, 300),
        path("3", 500, 300),
        path("4", 0, 0),
        path("5", 1, 1, 'locked="true"'),
    )
    edges = read_text(plant(POINTS, *paths), floor="f").document.floors["f"].edges
    assert [(e.start, e.two_way, e.speed, e.motion, e.locked) for e in edges.values()] == [
        ("a", False, 0.5, Motion.FORWARD, False),
        ("b", False, 0.3, Motion.BACKWARD, False),
        ("a", True, 0.5, Motion.ANY, False),
        ("a", False, None, Motion.ANY, True),
        ("a", True, 0.001, Motion.ANY, True),
    ]
    assert edges["3"].extra == {"opentcs": {"reverse_speed": 0.3}}


def test_lengths_and_control_points() -> None:
    layout = '<pathLayout connectionType="BEZIER"><controlPoint x="20" y="-40"/></pathLayout>'
    scale = '<visualLayout scaleX="50.0" scaleY="25.0"/>'
    paths = path("1", 1, 0, 'length="5001"'), path("2", 1, 0, 'length="6000"', layout)
    edges = read_text(plant(POINTS, *paths, scale), floor="f").document.floors["f"].edges
    assert (edges["1"].length, edges["2"].length, edges["2"].control_points) == (None, 6.0, ((1.0, 1.0),))


def test_heights_are_floors() -> None:
    text = plant(point("a", 0, 0), point("b", 0, 0, 'positionZ="4000"'))
    assert {n: list(f.vertices) for n, f in read_text(text).document.floors.items()} == {
        "0 m": ["a"],
        "4 m": ["b"],
    }


DTD = '<!DOCTYPE m [<!ENTITY a "x"><!ENTITY b "&a;&a;">]>'


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        (f'{DTD}<model version="7.0.0">&b;</model>', "a DTD or entities, which are not read: remove them"),
        ('<!DOCTYPE m SYSTEM "file:///etc/passwd"><model/>', "a DTD or entities"),
        ("<model>\n<point", "not XML: unclosed token in line 2"),
        ("<model>" * 200_000, "not XML"),
        ("<model>\x1b</model>", "not XML"),
        (plant(version="0.0.5"), "plant model '0.0.5': save it with openTCS 6 or 7"),
        (
            plant('<point name="a" positionX="NaN" positionY="0"/>'),
            "point 'a' positionX: 'NaN' instead of whole",
        ),
        (
            plant('<point name="a" positionX="1"/>'),
            "point 'a' positionY: nothing instead of whole millimetres",
        ),
        (
            plant(point("a", 0, 0, 'vehicleOrientationAngle="x"')),
            "vehicleOrientationAngle: 'x' instead of degrees",
        ),
        (plant('<point positionX="1" positionY="1"/>'), "point name: nothing instead of text"),
        (plant(POINTS, '<path name="p" sourcePoint="a"/>'), "path p: nothing instead of text"),
        (plant(f'<point name="a" positionX="{"9" * 30}" positionY="0"/>'), "positionX: '9999"),
        (plant(POINTS, path("p", 1, 1, "", "<controlPoint/>")), "path 'p': a control point without x and y"),
    ],
)
def test_bad_files(text: str, problem: str) -> None:
    with pytest.raises(GraphError, match=problem):
        read_text(text, GraphFormat.OPENTCS)


@pytest.mark.skipif(not SHARED.is_dir(), reason="samples lie beside the repository only where it was built")
def test_the_sample() -> None:
    floor = read_text((SHARED / "graphs" / "opentcs7.sample.xml").read_text(), floor="f").document.floors["f"]
    assert (len(floor.vertices), len(floor.edges)) == (15, 7)
    assert [one.length for one in floor.edges.values()] == [None] * 7
    assert floor.edges["Point-0013 --- Point-0014"].locked


DECLARED = '<?xml version="1.0" encoding="{}"?><model name="Lager"/>'


@pytest.mark.parametrize("encoding", ["UTF-8", "utf-8", "US-ASCII", "ISO-8859-1"])
def test_a_text_that_is_the_same_in_its_encoding_is_read(encoding: str) -> None:
    assert parse_xml(DECLARED.format(encoding)).get("name") == "Lager"


@pytest.mark.parametrize(
    "text",
    [
        DECLARED.format("UTF-16"),
        DECLARED.format("ISO-8859-1").replace("Lager", "Läger"),
        DECLARED.format("no-such"),
        DECLARED.format("UTF-16").encode("utf-16-le").decode(),
    ],
)
def test_another_encoding_than_the_declared_one_is_named(text: str) -> None:
    with pytest.raises(GraphError, match=r"encoding.*: save it as UTF-8"):
        parse_xml(text)
