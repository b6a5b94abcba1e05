"""The map's picture on the screen, and the mouse on it."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from rich.style import Style
from textual import events

from fleet_tui.view.map.camera import ZOOM_STEP, Camera
from fleet_tui.view.map.caption import Caption, caption_row
from fleet_tui.view.map.cells import Cells
from fleet_tui.view.map.layers import MapOptions, Tags
from fleet_tui.view.map.modes import MapMode, ViewMode
from fleet_tui.view.map.picture import backdrop, picture
from fleet_tui.view.map.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.view.map.trails import Trails
from fleet_tui.view.map.viewport import Viewport, pick, pointed
from fleet_tui.view.roles import StyleRole
from fleet_tui.widgets.cells_view import CellsView
from fleet_tui.widgets.messages import RobotPicked, VertexPicked

CAPTION_ROWS = 1


class MapPicture(CellsView, can_focus=True):
    """Shows a Scene below a caption; wheel zooms, drag pans, click picks."""

    def __init__(self, inks: Mapping[StyleRole, Style] | None = None, *, id: str | None = None) -> None:
        super().__init__(inks, id=id)
        self.look = MapOptions()
        self.mode: MapMode = ViewMode()
        self.viewport = Viewport()
        self.scene: Scene | None = None
        self._trails = Trails()
        self._tags: Tags = {}
        self._tags_of: tuple[Camera, MapOptions] | None = None
        self._behind: Cells | None = None
        self._behind_of: tuple[Scene, Camera, MapOptions] | None = None
        self._drag: tuple[int, int] | None = None
        self._dragged = False

    def show(self, scene: Scene) -> None:
        """Show the newest scene. Cheap where little changed: call it at every tick."""
        self.scene = scene
        self._trails.note(scene)
        self.draw()

    def forget(self) -> None:
        """Another time is shown from now on: where the robots were is not where they came from."""
        self._trails = Trails()

    def draw(self) -> None:
        """Paint the scene as it is seen now."""
        scene, view, (width, height) = self.scene, self.viewport, self.size
        if scene is None or width < 1 or height <= CAPTION_ROWS:
            return
        view.width, view.height = width, height - CAPTION_ROWS
        camera = view.camera(scene)
        if self.look.trails:
            scene = replace(scene, trail=self._trails.of(scene))
        head = caption_row(self._caption(scene, camera))
        if self._tags_of != (camera, self.look):
            self._tags, self._tags_of = {}, (camera, self.look)
        body = picture(self._backdrop(scene, camera), scene, camera, self.look, self._tags, self.mode.layers)
        self.paint(Cells(np.vstack((head.codes, body.codes)), np.vstack((head.inks, body.inks))))

    def _caption(self, scene: Scene, camera: Camera) -> Caption:
        return Caption(
            floor=scene.floor,
            note=scene.note,
            frame=scene.frame,
            camera=camera,
            drawing=self.look.drawing,
            follow=self.viewport.follow,
            zoom_robot=self.viewport.zoom_robot,
            focused=self.has_focus,
            banner=self.mode.banner,
        )

    def _backdrop(self, scene: Scene, camera: Camera) -> Cells:
        """Return what stands behind the robots, made again only when something in it changed."""
        under = pointed(scene, camera, self.look.cursor)
        key = (scene, camera, replace(self.look, cursor=None, trails=False, pointed=under))
        if self._behind is None or self._behind_of is None or not _same(self._behind_of, key):
            self._behind = backdrop(*key)
            self._behind_of = key
        return self._behind

    def on_resize(self) -> None:
        """Draw for the new size; the centre stays."""
        self.draw()

    def watch_has_focus(self, _has_focus: bool) -> None:
        """Brighten the caption of the focused map."""
        super().watch_has_focus(_has_focus)
        self.draw()

    def pick_at(self, x: int, y: int) -> None:
        """Tell what is shown at cell (x, y) of the map, if anything is."""
        if self.scene is None:
            return
        self._tell(pick(self.scene, self.viewport.camera(self.scene), x, y))

    def _tell(self, found: SceneRobot | SceneVertex | None) -> None:
        if isinstance(found, SceneRobot):
            self.post_message(RobotPicked(found.name))
        elif found is not None:
            self.post_message(VertexPicked(found.id))

    def _zoom_at(self, event: events.MouseEvent, factor: float) -> None:
        event.stop()
        if self.scene is not None and event.y >= CAPTION_ROWS:
            self.viewport.zoom(self.scene, factor, (event.x, event.y - CAPTION_ROWS))
            self.draw()

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        """Zoom in at the pointer."""
        self._zoom_at(event, ZOOM_STEP)

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        """Zoom out at the pointer."""
        self._zoom_at(event, 1 / ZOOM_STEP)

    def on_mouse_down(self, event: events.MouseDown) -> None:
        """Start what becomes a drag or a click."""
        self.capture_mouse()
        self._drag, self._dragged = (event.x, event.y), False

    def on_mouse_move(self, event: events.MouseMove) -> None:
        """Drag the map along."""
        if self._drag is None or self.scene is None or (event.x, event.y) == self._drag:
            return
        self.viewport.pan(self.scene, self._drag[0] - event.x, self._drag[1] - event.y)
        self._drag, self._dragged = (event.x, event.y), True
        self.draw()

    def on_mouse_up(self, event: events.MouseUp) -> None:
        """Pick, unless it was a drag."""
        self.release_mouse()
        if self._drag is not None and not self._dragged and event.y >= CAPTION_ROWS:
            self.pick_at(event.x, event.y - CAPTION_ROWS)
        self._drag = None


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
    """The mission without where it begins, which moves with the robot."""
    mission = scene.mission
    return (mission.current, mission.following) if mission else ((), ())
