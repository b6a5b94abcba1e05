"""The viewport: the camera of each floor, following, zooming, picking."""

import math
from dataclasses import dataclass, field, replace
from typing import NamedTuple, TypeVar

from fleet_tui.model.geometry import MapFrame
from fleet_tui.ui.view.map.camera import Area, Camera
from fleet_tui.ui.view.map.places import Place, seen_robots, seen_vertices
from fleet_tui.ui.view.map.scene import Scene, SceneRobot, SceneVertex

Thing = TypeVar("Thing")
Point = tuple[float, float]
"""x, y in metres."""

LEAST_USED = 0.5
"""Share of the view's length or height that a growing floor takes at least."""
ROOM = 0.2
"""Room on each side for more of it, as a share of its size."""
_NEAR = 1.0  # tolerance of a click: this many rows, or twice as many columns


class _Fitted(NamedTuple):
    """The camera that showed a whole floor, and whether its map has grown."""

    camera: Camera
    frame: MapFrame
    grows: bool

    def over_more_of(self, scene: Scene, exact: Camera) -> Camera:
        """Return this camera while it shows the whole floor large enough, else one with room for more."""
        held = self.camera.reframed(self.frame, scene.frame)
        left, top, right, bottom = _area(scene)
        if shows_all(scene, held) and held.scale * LEAST_USED <= exact.scale:
            return held
        across, down = (right - left) * ROOM, (bottom - top) * ROOM
        roomy = left - across, top - down, right + across, bottom + down
        return Camera.fit(exact.extent, exact.width, exact.height, roomy)


@dataclass(slots=True)
class Viewport:
    """The cameras over the floors. width, height: the view in cells.

    A floor whose camera was never moved is shown as a whole, also after its extent changes.
    """

    width: int = 1
    height: int = 1
    follow: bool = False
    zoom_robot: bool = False
    holds: bool = False
    """While something about the picture covers a part of it: the rest keeps its scale."""
    _moved: dict[str, tuple[Camera, MapFrame]] = field(default_factory=dict)
    _fitted: "dict[str, _Fitted]" = field(default_factory=dict)
    _part: Camera | None = None
    _followed: str = ""
    """The floor on which a robot was followed last."""

    def camera(self, scene: Scene) -> Camera:
        """Return the camera for the scene's floor, after following the selected robot."""
        camera = self._camera(scene)
        target = self._robot_pixel(scene) if self.follow else None
        if target is None:
            self._followed = self._followed if self.follow else ""
            return camera
        if self._followed != scene.floor and self._followed in self._moved:
            camera = self._keep(scene, camera.at_scale_of(*self._moved[self._followed], scene.frame))
        self._followed = scene.floor
        followed = camera.followed(*target, _area(scene))
        if followed.origin != camera.origin:
            self._keep(scene, followed)
        return followed

    def _camera(self, scene: Scene) -> Camera:
        frame = scene.frame
        kept = self._moved.get(scene.floor)
        if kept is None:
            return self._fit(scene)
        camera, made_for = kept
        if self.holds and made_for == frame and self._is_part_of(camera):
            return self._part_of(scene, camera)
        camera = camera.resized(self.width, self.height)
        if made_for == frame:
            return camera
        return self._keep(scene, camera.reframed(made_for, frame))

    def _fit(self, scene: Scene) -> Camera:
        """Return the camera that shows the whole floor. Over a map that grows it holds still in the world
        until the floor does not fit any more; then there is room for more of it."""
        before = self._fitted.get(scene.floor)
        whole = before.camera if before is not None and before.frame == scene.frame else None
        if self.holds and whole is not None and self._is_part_of(whole):
            return self._part_of(scene, whole)
        camera = Camera.fit((scene.frame.width, scene.frame.height), self.width, self.height, scene.area)
        grows = before is not None and (before.grows or before.frame != scene.frame)
        if before and grows and (before.camera.width, before.camera.height) == (self.width, self.height):
            camera = before.over_more_of(scene, camera)
        if scene.grid is not None:
            self._fitted[scene.floor] = _Fitted(camera, scene.frame, grows)
        return camera

    def _is_part_of(self, whole: Camera) -> bool:
        return whole.width == self.width and whole.height > self.height

    def _part_of(self, scene: Scene, whole: Camera) -> Camera:
        """Return the camera of the uncovered part of a view, moved only if the selected robot or the picked
        vertex would be out of it; without space for both the vertex is in it."""
        part, whole = self._part, replace(whole, height=self.height)
        if part is None or replace(part, column=whole.column, row=whole.row) != whole:
            part = whole
        points = [at for at in (self._robot_pixel(scene), _picked_pixel(scene)) if at is not None]
        if not all(_shows(part, at) for at in points):
            middle = [sum(ends) / len(ends) for ends in zip(*points, strict=True)]
            part = part.centred_within(middle[0], middle[1], _area(scene))
            if not _shows(part, points[-1]):
                part = part.centred_within(*points[-1], _area(scene))
        self._part = part
        return part

    def _keep(self, scene: Scene, camera: Camera) -> Camera:
        self._moved[scene.floor] = (camera, scene.frame)
        return camera

    def pan(self, scene: Scene, right: int, down: int) -> None:
        """Move the view by cells; this ends following."""
        self.follow = False
        self._keep(scene, self._camera(scene).panned(right, down))

    def zoom(self, scene: Scene, factor: float, cell: tuple[int, int] | None = None) -> None:
        """Zoom about a cell (the pointer), else about the robot or the centre, as chosen."""
        camera = self._camera(scene)
        if cell:
            about: tuple[float, float] | None = camera.to_pixel(*cell)
        else:
            about = self._robot_pixel(scene) if self.zoom_robot or self.follow else None
        zoomed = camera.zoomed(factor, about)
        robot = self._robot_pixel(scene)
        if about is None and robot and _shows(camera, robot) and not _shows(zoomed, robot):
            # The selected robot is what one looks at: it stays where it is.
            zoomed = camera.zoomed(factor, robot)
            zoomed = zoomed if _shows(zoomed, robot) else zoomed.centred(*robot)
        whole = Camera.fit(camera.extent, self.width, self.height, scene.area).scale
        if camera.scale < whole <= zoomed.scale and not self.follow:
            self.fit(scene)  # so far out all of it is shown, not a shifted half
            return
        self._keep(scene, zoomed)

    def fit(self, scene: Scene) -> None:
        """Show the whole floor, until it is moved by hand again."""
        self.follow = False
        self._moved.pop(scene.floor, None)
        self._fitted.pop(scene.floor, None)

    def centre(self, scene: Scene, at: tuple[float, float] | None = None) -> None:
        """Centre on world metres `at`, or on the selected robot."""
        pixel = scene.frame.to_pixel(*at) if at else self._robot_pixel(scene)
        camera = self._camera(scene)
        centred = camera.centred_within(*pixel, _area(scene)) if pixel else camera
        # A fitted view shows all: it stays fitted, also at another size.
        if centred.origin != camera.origin:
            self._keep(scene, centred)

    def middle(self, scene: Scene) -> Point:
        """Return the place in the middle of the view."""
        camera = self._camera(scene)
        return scene.frame.to_world(*camera.to_pixel(camera.width // 2, camera.height // 2))

    def stepped(self, scene: Scene, cursor: Point, dx: int, dy: int) -> Point:
        """Return the place dx, dy cells from `cursor`; at the view's edge the view moves along.

        A cursor outside the view starts again from its middle.
        """
        camera = self._camera(scene)
        x, y = camera.to_cell(*scene.frame.to_pixel(*cursor))
        if not camera.shows(x, y):
            return self.middle(scene)
        if not camera.shows(x + dx, y + dy):
            self.pan(scene, dx, dy)
        return scene.frame.to_world(*camera.to_pixel(x + dx, y + dy))

    def next_labelled(self, scene: Scene, cursor: Point | None, step: int) -> Point | None:
        """Return the place of the labelled vertex `step` after the one under `cursor`, brought into view.

        In the order of the labels; None if no vertex has one.
        """
        labelled = sorted((vertex for vertex in scene.vertices if vertex.label), key=lambda v: v.label)
        places = [(v.x, v.y) for v in labelled if math.isfinite(v.x) and math.isfinite(v.y)]
        if not places:
            return None
        start = places.index(cursor) if cursor in places else (-1 if step > 0 else 0)
        place = places[(start + step) % len(places)]
        camera, pixel = self._camera(scene), scene.frame.to_pixel(*place)
        if not camera.shows(*camera.to_cell(*pixel)):
            self.follow = False
            self._keep(scene, camera.centred_within(*pixel, _area(scene)))
        return place

    def _robot_pixel(self, scene: Scene) -> tuple[float, float] | None:
        robot = scene.selected
        if robot is None:
            return None
        pixel = scene.frame.to_pixel(robot.pose.x, robot.pose.y)
        return pixel if all(map(math.isfinite, pixel)) else None


def pointed(scene: Scene, camera: Camera, cursor: Point | None) -> str | None:
    """Return the id of the vertex under the map's cursor."""
    if cursor is None:
        return None
    at = camera.to_cell(*scene.frame.to_pixel(*cursor))
    return next((vertex.id for vertex, place in seen_vertices(scene, camera) if place == at), None)


def shows_all(scene: Scene, camera: Camera) -> bool:
    """Tell whether all of the floor that is worth seeing is in view: then the view follows nobody."""
    return _shows(camera, _area(scene)[:2]) and _shows(camera, _area(scene)[2:])


def _picked_pixel(scene: Scene) -> tuple[float, float] | None:
    """Return the place of the vertex that an order being typed would go to."""
    found = next((vertex for vertex in scene.vertices if scene.picked and vertex.id == scene.picked), None)
    pixel = scene.frame.to_pixel(found.x, found.y) if found is not None else (math.nan, math.nan)
    return pixel if all(map(math.isfinite, pixel)) else None


def _shows(camera: Camera, pixel: tuple[float, float]) -> bool:
    return camera.shows(*camera.to_cell(*pixel))


def _area(scene: Scene) -> Area:
    """Return the pixels of the floor that are worth seeing."""
    return scene.area or (0.0, 0.0, float(scene.frame.width), float(scene.frame.height))


def pick(
    scene: Scene, camera: Camera, x: int, y: int, label_of: Place | None = None
) -> SceneRobot | SceneVertex | None:
    """Return the object at cell (x, y): the nearest robot, else the vertex in the cell `label_of` whose label
    is there, else the nearest labelled vertex, else vertex."""
    found = _nearest(seen_robots(scene, camera), x, y)
    if found:
        return found
    vertices = seen_vertices(scene, camera)
    labelled = [at for at in vertices if at[0].label]
    if label_of is not None:
        x, y = label_of
    return _nearest(labelled, x, y) or _nearest(vertices, x, y)


def _nearest(places: list[tuple[Thing, tuple[int, int]]], x: int, y: int) -> Thing | None:
    # A cell is twice as high as wide.
    near = [(max(abs(at_x - x) / 2, abs(at_y - y)), thing) for thing, (at_x, at_y) in places]
    near = [at for at in near if at[0] <= _NEAR]
    return min(near, key=lambda at: at[0])[1] if near else None
