"""The picture of a floor with the operator's view, and its cached parts."""

import math
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from fleet_tui.model.geometry import MapFrame
from fleet_tui.text.language import Message, tr, translate
from fleet_tui.text.sanitize import cell_width, fit_words, sanitize
from fleet_tui.ui.view.map.camera import Camera, scale_bar
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.layer_stack import backdrop, picture
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.modes.mode import CursorMode, MapMode, ViewMode
from fleet_tui.ui.view.map.places import Place, seen_robots
from fleet_tui.ui.view.map.placing.labels import Backdrop
from fleet_tui.ui.view.map.robots import Arrangement
from fleet_tui.ui.view.map.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.ui.view.map.trails import Trails
from fleet_tui.ui.view.map.viewport import Point, Viewport, pick, pointed, shows_all
from fleet_tui.ui.view.roles import StyleRole

CAPTION_ROWS = 1


Piece = tuple[str, StyleRole]
LEAST = 8  # cells that a note must have
_BAR = 14  # cells that the scale bar may take
_BANNER = 34  # cells of a banner that are worth more than the floor


@dataclass(frozen=True, slots=True)
class Caption:
    """The content of the first row. `waits`: the note only says what has not arrived yet; `banner` is that of
    the map's mode, `pixel` the map's cell under its cursor; `hint` names the key of help, `elsewhere`
    robots in trouble out of view and on other floors, after a `!` those with an alarm; `whole`: all of the
    floor is in view."""

    floor: str
    note: str
    frame: MapFrame
    camera: Camera
    drawing: Drawing
    follow: bool
    zoom_robot: bool
    focused: bool
    waits: bool = False
    banner: str = ""
    hint: str = ""
    elsewhere: tuple[str, ...] = ()
    pixel: str = ""
    whole: bool = False


@lru_cache(maxsize=8)
def caption_row(facts: Caption) -> Cells:
    """Return one row of cells, not to be drawn on; if it is narrow, a note is cut and less important parts
    are dropped."""
    row = Cells.blank(facts.camera.width, 1, StyleRole.ACCENT if facts.focused else StyleRole.RULE)
    row.codes[:] = ord("-" if facts.drawing is Drawing.ASCII else "─")
    x = 1
    for piece, role in _pieces(facts):
        space = facts.camera.width - x - 2
        # Of these the beginning is worth more than the rest of the row.
        is_first = piece in (*map(sanitize, (facts.note, *facts.elsewhere)), facts.banner)
        if is_first and space > LEAST:
            piece = _within(piece, space)
        text = f" {piece} "
        if x + cell_width(text) <= facts.camera.width:
            row.write(x, 0, text, role)
            x += cell_width(text) + 2
    return row


def _within(text: str, cells: int) -> str:
    """Return the parts of a text, at its commas, that are whole in so many cells, else its beginning."""
    while cell_width(text) > cells and ", " in text:
        text = text.rpartition(", ")[0]
    return text if cell_width(text) <= cells else fit_words(text, cells).rstrip()


def _pieces(facts: Caption) -> list[Piece]:
    """Return the pieces from left to right, which is also the order of their importance."""
    pieces, floor = list[Piece](), sanitize(facts.floor)
    # The mode's banner begins with the cursor's place, which is seen nowhere else.
    banner = min(cell_width(facts.banner), _BANNER)
    if not banner or cell_width(floor) + banner + 7 <= facts.camera.width:
        pieces.append((floor, StyleRole.TITLE_FOCUSED if facts.focused else StyleRole.TITLE))
    if facts.banner:
        pieces.append((facts.banner, StyleRole.TEXT))
    for told in facts.elsewhere:
        pieces.append((sanitize(told), StyleRole.ALARM if told.startswith("!") else StyleRole.WARN))
    if facts.note:
        pieces.append((sanitize(facts.note), StyleRole.DIM if facts.waits else StyleRole.WARN))
    return [
        *pieces,
        *([(facts.pixel, StyleRole.TEXT)] if facts.pixel else []),
        *_following(facts),
        (_bar(facts), StyleRole.DIM),
        *_turn(facts),
        *([(tr("zoom robot"), StyleRole.DIM)] if facts.zoom_robot else []),
        *([(tr("{hint} Tab Tab legend", hint=facts.hint), StyleRole.DIM)] if facts.hint else []),
    ]


def _following(facts: Caption) -> list[Piece]:
    """Return that the view follows a robot, and why it does not move."""
    text = tr("follow on, all in view") if facts.whole else tr("follow on")
    return [(text, StyleRole.TEXT)] if facts.follow else []


def _turn(facts: Caption) -> list[Piece]:
    """Return the rotation of the picture in the world, if any."""
    yaw = facts.frame.origin.yaw
    degrees = round(math.degrees(yaw)) if math.isfinite(yaw) else 0
    unit = Message(" deg") if facts.drawing is Drawing.ASCII else Message("°")
    return (
        [(tr("yaw {degrees}{unit}", degrees=degrees, unit=translate(unit)), StyleRole.DIM)] if degrees else []
    )


def _bar(facts: Caption) -> str:
    metres, cells = scale_bar(facts.camera, facts.frame, _BAR)
    left, line, right = "|-|" if facts.drawing is Drawing.ASCII else "├─┤"
    # Its ends are in the middle of their cells.
    return f"{metres} {left}{line * (cells - 1)}{right}" if cells > 1 else metres


class MapPicture:
    """Camera, options and mode over the newest scene, as cells below a caption."""

    def __init__(self) -> None:
        self.options = MapOptions()
        self.mode: MapMode = ViewMode()
        self.viewport = Viewport()
        self.scene: Scene | None = None
        self.hint = ""
        """The key of help, for the way to its legend."""
        self.trails = Trails()
        self._arrangement = Arrangement()
        self._arrangement_of: tuple[str, Camera, MapOptions] | None = None
        self.backdrop: Backdrop | None = None
        self._backdrop_of: tuple[Scene, Camera, MapOptions] | None = None

    def hatch(self, hatched: bool) -> None:
        """Mark unknown ground, or leave it to its colour."""
        self.options = replace(self.options, hatched=hatched)

    @property
    def look(self) -> MapOptions:
        """The options for the newest scene: without a map the edges are all there is to see of its ground."""
        edges = self.options.edges
        if edges is None:
            edges = self.scene is not None and self.scene.grid is None
        return replace(self.options, edges=edges)

    def show(self, scene: Scene) -> None:
        """Take the newest scene."""
        self.scene = scene
        self.trails.note(scene)

    def clear_trails(self) -> None:
        """Restart the trails: another time is shown from now on."""
        self.trails = Trails()

    def cells(self, width: int, height: int, focused: bool) -> Cells | None:
        """Return the picture in this many cells, None without a scene or space."""
        scene, view = self.scene, self.viewport
        if scene is None or width < 1 or height <= CAPTION_ROWS:
            return None
        scene = self.mode.adjusted(scene)
        view.width = width
        view.height = height - CAPTION_ROWS
        camera = view.camera(scene)
        if self.options.trails:
            scene = replace(scene, trail=self.trails.of(scene))
        head = caption_row(self._caption(scene, camera, focused))
        shown = scene.floor, camera, self.look
        if self._arrangement_of != shown:
            self._arrangement = Arrangement()
            self._arrangement_of = shown
        behind = self._still(scene, camera)
        body = picture(behind, scene, camera, self.look, self._arrangement, self.mode.layers)
        return Cells(np.vstack((head.codes, body.codes)), np.vstack((head.roles, body.roles)))

    def lines_of_floor(self, width: int) -> int:
        """Return the lines that the whole floor takes in `width` cells, with the caption: 0 without one."""
        if self.scene is None or width < 1:
            return 0
        frame = self.scene.frame
        return CAPTION_ROWS + Camera.lines_of((frame.width, frame.height), width, self.scene.area)

    def pick(self, x: int, y: int) -> SceneRobot | SceneVertex | None:
        """Return the object at cell (x, y) of the whole picture, if any. A label is its vertex."""
        if self.scene is None or y < CAPTION_ROWS:
            return None
        return pick(self.scene, self.viewport.camera(self.scene), x, y - CAPTION_ROWS, self._labelled(x, y))

    def _labelled(self, x: int, y: int) -> Place | None:
        """Return the cell of the vertex whose label covers a cell of the whole picture, None for none."""
        aside = self._arrangement.labels.aside
        for label in self.backdrop.labels if self.backdrop is not None else ():
            left, row = aside.get(label.at, label.at)
            if row == y - CAPTION_ROWS and left <= x < left + cell_width(label.text):
                return label.vertex
        return None

    def place_of(self, x: int, y: int) -> Point:
        """Return the place in metres of cell (x, y) of the whole picture, of which there must be a scene."""
        assert self.scene is not None
        camera = self.viewport.camera(self.scene)
        return self.scene.frame.to_world(*camera.to_pixel(x, y - CAPTION_ROWS))

    def point(self) -> None:
        """Show the mode's cursor where it is now."""
        self.options = replace(self.options, cursor=self.mode.cursor)

    def _caption(self, scene: Scene, camera: Camera, focused: bool) -> Caption:
        outside = _out_of_view(scene, camera)
        return Caption(
            floor=scene.floor,
            note=scene.note or outside,
            frame=scene.frame,
            camera=camera,
            drawing=self.options.drawing,
            follow=self.viewport.follow,
            zoom_robot=self.viewport.zoom_robot,
            focused=focused,
            waits=scene.waits if scene.note else not (scene.selected and scene.selected.misplaced),
            banner=self._banner(scene, camera),
            hint=self.hint,
            elsewhere=tuple(filter(None, (_trouble_out_of_view(scene, camera), scene.elsewhere))),
            pixel=self._pixel(scene),
            whole=shows_all(scene, camera),
        )

    def _banner(self, scene: Scene, camera: Camera) -> str:
        """Return the mode's text, after the name of the place on which a plain cursor stands."""
        text = self.mode.banner(scene.floor)
        under = pointed(scene, camera, self.mode.cursor) if isinstance(self.mode, CursorMode) else None
        name = next((vertex.label for vertex in scene.vertices if vertex.id == under), "")
        return f"{sanitize(name)}, {text}" if name else text

    def _pixel(self, scene: Scene) -> str:
        """Return the map's cell under the mode's cursor, as `map show --part` counts, empty for none."""
        if self.mode.cursor is None or scene.grid is None:
            return ""
        column, row = map(math.floor, scene.frame.to_pixel(*self.mode.cursor))
        return tr("cell {column}, {row}", column=column, row=row)

    def _still(self, scene: Scene, camera: Camera) -> Backdrop:
        """Return the backdrop of the robots, redrawn only on a change."""
        under = pointed(scene, camera, self.options.cursor) if self.mode.points else None
        key = (scene, camera, replace(self.look, cursor=None, trails=False, pointed=under))
        if self.backdrop is None or self._backdrop_of is None or not _same(self._backdrop_of, key):
            self.backdrop = backdrop(*key)
            self._backdrop_of = key
        return self.backdrop


def _trouble_out_of_view(scene: Scene, camera: Camera) -> str:
    """Return who has an alarm on the floor and is not in the view, empty if nobody."""
    alarmed = tuple(robot for robot in scene.robots if robot.alarmed)
    seen = {robot.name for robot, _ in seen_robots(replace(scene, robots=alarmed), camera)} if alarmed else ()
    hidden = [robot.name for robot in alarmed if robot.name not in seen]
    if len(hidden) > 1:
        return tr("! {hidden} out of view", hidden=len(hidden))
    return tr("! {hidden} out of view", hidden=hidden[0]) if hidden else ""


def _out_of_view(scene: Scene, camera: Camera) -> str:
    """Return a note if the selected robot is on the floor and not in the view."""
    selected = tuple(robot for robot in scene.robots if robot.selected and not robot.alarmed)
    is_outside = selected and not seen_robots(replace(scene, robots=selected), camera)
    return tr("{name} is out of view", name=selected[0].name) if is_outside else ""


def _same(before: tuple[Scene, Camera, MapOptions], now: tuple[Scene, Camera, MapOptions]) -> bool:
    """Tell whether the same backdrop serves both; the large parts are compared by identity."""
    old, new = before[0], now[0]
    same_parts = old.grid is new.grid and old.vertices is new.vertices and old.edges is new.edges
    return (
        same_parts
        and before[1:] == now[1:]
        and old.frame == new.frame
        and old.target_vertices == new.target_vertices
        and _lines(old) == _lines(new)
    )


def _lines(scene: Scene) -> tuple[object, ...]:
    """Return the mission without its start, which moves with the robot."""
    mission = scene.mission
    return (mission.current, mission.following) if mission else ((), ())
