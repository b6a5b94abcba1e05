"""The map pane: the picture of a floor on the screen, and the mouse on it."""

from collections.abc import Mapping
from typing import ClassVar

from rich.style import Style
from textual import events, on

from fleet_tui.keys import Pane
from fleet_tui.ui.view.map.camera import ZOOM_STEP
from fleet_tui.ui.view.map.map_picture import CAPTION_ROWS, MapPicture
from fleet_tui.ui.view.map.modes.drive import DriveMode
from fleet_tui.ui.view.map.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.widgets.bindings import bindings
from fleet_tui.ui.widgets.cells_view import CellsView
from fleet_tui.ui.widgets.messages import PlacePicked, RobotPicked, VertexPicked


class MapView(CellsView, can_focus=True):
    """Shows a Scene at every tick; wheel zooms, drag pans, click picks."""

    BINDINGS = [*bindings(Pane.DRIVE), *bindings(Pane.PLACE), *bindings(Pane.EDIT), *bindings(Pane.MAP)]  # noqa: RUF012  # as Textual declares it
    DEFAULT_CSS: ClassVar[str] = "MapView { width: 1fr; height: 1fr; }"

    def __init__(self, styles: Mapping[StyleRole, Style] | None = None, *, id: str | None = None) -> None:
        super().__init__(styles, id=id)
        self.picture = MapPicture()
        self._drag: tuple[int, int] | None = None
        self._dragged = False
        self._pressed: bool | None = None

    def show(self, scene: Scene) -> None:
        """Show the newest scene. Cheap if little changed: call it at every tick."""
        self.picture.show(scene)
        self.draw()

    def draw(self) -> None:
        """Paint the scene with the current view."""
        cells = self.picture.cells(*self.size, self.has_focus)
        if cells is not None:
            self.paint(cells)

    def on_resize(self) -> None:
        """Draw for the new size; the centre stays."""
        self.draw()

    def watch_has_focus(self, _has_focus: bool) -> None:
        """Brighten the caption of the focused map."""
        super().watch_has_focus(_has_focus)
        self.draw()
        if not _has_focus and isinstance(self.picture.mode, DriveMode):
            self.picture.mode.left()

    def on_key(self, event: events.Key) -> None:
        """Take the keys that mean nothing in a drive: each of them stops the robot."""
        mode = self.picture.mode
        if isinstance(mode, DriveMode) and event.key not in mode.passes:
            event.stop()
            mode.stop()

    @on(events.MouseScrollUp)
    @on(events.MouseScrollDown)
    def zoom_at_pointer(self, event: events.MouseScrollUp | events.MouseScrollDown) -> None:
        event.stop()
        factor = ZOOM_STEP if isinstance(event, events.MouseScrollUp) else 1 / ZOOM_STEP
        if self.picture.scene is not None and event.y >= CAPTION_ROWS:
            self.picture.viewport.zoom(self.picture.scene, factor, (event.x, event.y - CAPTION_ROWS))
            self.draw()

    def on_mouse_down(self, event: events.MouseDown) -> None:
        """Start a drag or a click."""
        self.capture_mouse()
        self._drag = (event.x, event.y)
        self._dragged = False
        self._pressed, picture = None, self.picture
        if picture.scene is not None and event.y >= CAPTION_ROWS:
            at = picture.place_of(event.x, event.y)
            self._pressed = picture.mode.press(picture.viewport, picture.scene, at)

    def on_mouse_move(self, event: events.MouseMove) -> None:
        """Drag the map along."""
        scene = self.picture.scene
        if self._drag is None or scene is None or (event.x, event.y) == self._drag:
            return
        if self._pressed:
            self.picture.mode.drag(self.picture.place_of(event.x, event.y))
            self.picture.point()
        else:
            self.picture.viewport.pan(scene, self._drag[0] - event.x, self._drag[1] - event.y)
        self._drag = (event.x, event.y)
        self._dragged = True
        self.draw()

    def on_mouse_up(self, event: events.MouseUp) -> None:
        """Pick, unless it was a drag."""
        self.release_mouse()
        if self._drag is not None and (self._pressed or not self._dragged):
            if self._pressed is None:
                post_pick(self, self.picture.pick(event.x, event.y))
            else:
                self.post_message(PlacePicked(self._dragged))
        self._drag = None


def post_pick(view: MapView, found: SceneRobot | SceneVertex | None) -> None:
    """Report the operator's pick on a map, if any."""
    if isinstance(found, SceneRobot):
        view.post_message(RobotPicked(found.name))
    elif found is not None:
        view.post_message(VertexPicked(found.id))
