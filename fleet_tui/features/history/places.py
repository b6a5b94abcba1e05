"""Places where robots were blocked, on the map of a floor, with the worst places beside it."""

import math
from collections.abc import Sequence
from dataclasses import replace

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.totals import BlockedPlace
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import fit, sanitize
from fleet_tui.text.units import age
from fleet_tui.ui.view.map.floor_scene import floor_scene
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.map_picture import CAPTION_ROWS, MapPicture
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.selection import Selection
from fleet_tui.ui.view.tables.table import Row, Run, Table, cut

NEAR = 4.0
"""Metres within which a place is named after a vertex."""
SHORTEST = 5.0
"""Seconds below which a place is left out: robots slow down everywhere."""
LISTED = 34
"""Cells of the list beside the map."""
HEAT = ("·", "•", "●"), (".", "o", "@")
"""Signs for up to a tenth, up to a half, and more of the worst place's time."""


def near(state: FleetState, place: BlockedPlace) -> str:
    """Return the label of the nearest vertex, empty if none is near."""
    found: list[tuple[float, str]] = []
    for robot in state.robots.values():
        robot_map = robot.maps.get(place.floor)
        if robot_map is not None and robot_map.graph is not None:
            for id_, label in robot_map.labels.items():
                if (vertex := robot_map.graph.vertices.get(id_)) is not None:
                    found.append((math.hypot(vertex.x - place.x, vertex.y - place.y), label))
            break
    metres, label = min(found, default=(math.inf, ""))
    return label if metres <= NEAR else ""


def heat_rows(
    state: FleetState,
    selection: Selection,
    places: Sequence[BlockedPlace],
    options: MapOptions,
    size: tuple[int, int],
    is_ascii: bool,
) -> list[Row]:
    """Return rows of the floor's map with its blocked places, the worst listed at the right; `size` are cells
    and lines."""
    here = [place for place in places if place.floor == selection.floor and place.seconds >= SHORTEST]
    width, height = size
    listed = _listed(state, here)
    map_width = max(20, width - LISTED) if listed else width
    drawn = _drawn(state, selection, here, options, (map_width, height), HEAT[is_ascii])
    rows = []
    for n in range(height):
        left = cut(drawn[n], map_width) if n < len(drawn) else ((" " * map_width, StyleRole.TEXT),)
        rows.append(Row(None, (*left, *(listed[n] if n < len(listed) else ()))))
    return rows


def _listed(state: FleetState, places: Sequence[BlockedPlace]) -> list[tuple[Run, ...]]:
    total = sum(place.seconds for place in places)
    lines: list[tuple[Run, ...]] = (
        [((tr(" {age} blocked here", age=age(total)), StyleRole.TITLE),)] if places else []
    )
    for place in places:
        at = f"({place.x:.1f}, {place.y:.1f})"
        name = near(state, place)
        where = f"{sanitize(name)} {at}" if name else at
        lines.append(((f" {fit(age(place.seconds), 7)}", StyleRole.ALARM), (f" {where}", StyleRole.TEXT)))
    return lines


def _drawn(
    state: FleetState,
    selection: Selection,
    places: Sequence[BlockedPlace],
    look: MapOptions,
    size: tuple[int, int],
    signs: Sequence[str],
) -> list[tuple[Run, ...]]:
    picture = MapPicture()
    picture.options = replace(look, trails=False, cursor=None, pointed=None)
    scene = floor_scene(state, selection)
    picture.show(replace(scene, robots=(), mission=None, elsewhere="", beams=None, path=None))
    cells = picture.cells(*size, focused=False)
    if cells is None or picture.scene is None:
        return []
    camera, worst = picture.viewport.camera(picture.scene), max((one.seconds for one in places), default=0.0)
    for place in reversed(places):  # the worst last: it covers the others
        x, y = camera.to_cell(*picture.scene.frame.to_pixel(place.x, place.y))
        part = place.seconds / worst
        sign = signs[0 if part <= 0.1 else 1 if part <= 0.5 else 2]
        if camera.shows(x, y):
            cells.write(x, y + CAPTION_ROWS, sign, StyleRole.ROBOT_ALARM)
    return [tuple((text, StyleRole(role)) for text, role in runs) for runs in cells.all_runs()]


def places_table(
    rows: Sequence[Row], selection: Selection, places: Sequence[BlockedPlace], empty: str
) -> Table:
    """Return the page; with the other floors in its title."""
    floors = list(dict.fromkeys(place.floor for place in places))
    others = [floor for floor in floors if floor != selection.floor]
    said = f" {sanitize(selection.floor)}"
    if others:
        said += tr("; also on {others}: f goes there", others=sanitize(", ".join(others)))
    title = ((tr("Places"), StyleRole.TITLE), (said, StyleRole.DIM))
    return Table(title, rows if places else [], empty)
