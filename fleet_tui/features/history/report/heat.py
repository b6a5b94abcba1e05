"""Places where robots were blocked: circles on the map of a floor, as an SVG picture."""

import math
from collections.abc import Sequence
from xml.etree.ElementTree import Element

from msgspec import Struct

from fleet_tui.features.history.report.html import element
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.history.totals import BlockedPlace
from fleet_tui.text.units import age

LARGEST = 0.03
"""Radius of the worst place as a part of the picture's size."""
MARGIN = 3.0
"""Metres around the places on a floor without a map."""
NAMED = 6
APART = 0.12
"""Places whose seconds are written, and how far apart these are, as a part of the picture's size."""


class FloorHeat(Struct, frozen=True):
    """The blocked places of a floor, the worst first, in the pixels of `frame`; `picture` is a PNG of the map
    as a data URL, empty without a map."""

    name: str
    places: Sequence[BlockedPlace]
    frame: MapFrame
    picture: str = ""


def around(places: Sequence[BlockedPlace]) -> MapFrame:
    """Return a frame around places, of a floor whose map is unknown."""
    left, bottom = min(one.x for one in places) - MARGIN, min(one.y for one in places) - MARGIN
    right, top = max(one.x for one in places) + MARGIN, max(one.y for one in places) + MARGIN
    resolution = max(right - left, top - bottom) / 600.0
    size = math.ceil((right - left) / resolution), math.ceil((top - bottom) / resolution)
    return MapFrame(resolution, *size, Pose(left, bottom))


def heat(floor: FloorHeat) -> Element:
    width, height = floor.frame.width, floor.frame.height
    size, worst = max(width, height), floor.places[0].seconds
    circles, texts = [], []
    named: list[tuple[float, float]] = []
    for place in floor.places:
        x, y = floor.frame.to_pixel(place.x, place.y)
        radius = size * LARGEST * max(0.25, math.sqrt(place.seconds / worst))
        title = element("title", f"{age(place.seconds)} at ({place.x:.1f}, {place.y:.1f})")
        circles.append(element("circle", title, cx=x, cy=y, r=radius, class_="heat"))
        if len(named) < NAMED and all(math.dist((x, y), other) > size * APART for other in named):
            named.append((x, y))
            text = element("text", age(place.seconds), x=x + radius * 1.2, y=y, font_size=size / 45.0)
            texts.append(text)
    below = [element("image", href=floor.picture, width=width, height=height)] if floor.picture else []
    viewbox = f"0 0 {width} {height}"
    picture = element("svg", *below, *circles[::-1], *texts, viewBox=viewbox, class_="floor", role="img")
    total = age(sum(place.seconds for place in floor.places))
    caption = element("figcaption", element("b", floor.name), f" robots were blocked for {total} in all")
    return element("figure", picture, caption)
