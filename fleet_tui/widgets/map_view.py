"""Operations on the map. Keys are attached by its composer."""

from dataclasses import replace
from time import monotonic
from typing import ClassVar

from fleet_tui.view.map.camera import ZOOM_STEP
from fleet_tui.view.map.drawing import Drawing
from fleet_tui.view.map.modes import CursorMode, MapMode, ViewMode
from fleet_tui.view.map.stride import Stride
from fleet_tui.widgets.bindings import bindings
from fleet_tui.widgets.map_picture import MapPicture


class MapView(MapPicture, can_focus=True):
    """The map pane: `show` it a Scene at every tick."""

    BINDINGS = bindings("map")
    DEFAULT_CSS: ClassVar[str] = "MapView { width: 1fr; height: 1fr; }"
    _stride = Stride()

    def action_pan_map(self, dx: int, dy: int) -> None:
        """Have the mode follow the arrow keys: faster while the key is held."""
        if self.scene is None:
            return
        self._stride = self._stride.then((dx, dy), monotonic())
        times = self._stride.times
        self.mode.move(self.viewport, self.scene, dx * times, dy * times)
        self.enter(self.mode)

    def action_zoom_in(self) -> None:
        """Nearer, about the robot or the centre."""
        self._zoom(ZOOM_STEP)

    def action_zoom_out(self) -> None:
        """Further away."""
        self._zoom(1 / ZOOM_STEP)

    def _zoom(self, factor: float) -> None:
        if self.scene is not None:
            self.viewport.zoom(self.scene, factor)
            self.draw()

    def action_fit(self) -> None:
        """Show the whole floor."""
        if self.scene is not None:
            self.viewport.fit(self.scene)
            self.draw()

    def action_zoom_about(self) -> None:
        """Zoom about the selected robot, or about the centre of the view."""
        self.viewport.zoom_robot = not self.viewport.zoom_robot
        self.draw()

    def action_follow(self) -> None:
        """Follow the selected robot, or let it go."""
        self.viewport.follow = not self.viewport.follow
        self.draw()

    def action_centre(self) -> None:
        """Centre on the selected robot, once."""
        if self.scene is not None:
            self.viewport.centre(self.scene)
            self.draw()

    def centre_on(self, x: float, y: float) -> None:
        """Centre on a place in metres of the shown floor."""
        if self.scene is not None:
            self.viewport.centre(self.scene, (x, y))
            self.draw()

    def action_edges(self) -> None:
        """Show or hide the graph's edges."""
        self.look = replace(self.look, edges=not self.look.edges)
        self.draw()

    def action_labels(self) -> None:
        """Show or hide the labels."""
        self.look = replace(self.look, labels=not self.look.labels)
        self.draw()

    def action_trails(self) -> None:
        """Show or hide where the robots were in the last minute."""
        self.look = replace(self.look, trails=not self.look.trails)
        self.draw()

    def action_drawing(self) -> None:
        """The next drawing mode."""
        modes = list(Drawing)
        following = modes[(modes.index(self.look.drawing) + 1) % len(modes)]
        self.look = replace(self.look, drawing=following)
        self.draw()

    def enter(self, mode: MapMode) -> None:
        """Work on the map in this mode from now on."""
        self.mode = mode
        self.look = replace(self.look, cursor=mode.cursor)
        self.draw()

    def action_cursor(self) -> None:
        """The cursor on, in the middle of the view, or off."""
        if self.mode.cursor is None and self.scene is not None:
            self.enter(CursorMode(self.viewport.middle(self.scene)))
        else:
            self.enter(ViewMode())

    def action_next_vertex(self, step: int) -> None:
        """The cursor to the next (1) or previous (-1) labelled vertex, brought into the view."""
        place = self.viewport.next_labelled(self.scene, self.mode.cursor, step) if self.scene else None
        if place:
            self.enter(CursorMode(place))

    def action_pick(self) -> None:
        """Tell what Enter means in this mode."""
        if self.scene is not None:
            self._tell(self.mode.pick(self.viewport, self.scene))
