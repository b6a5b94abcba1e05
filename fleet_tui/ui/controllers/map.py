"""Actions on the map: zoom, follow, layers, the mode and its cursor."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from time import monotonic

from fleet_tui.keys.key import key_name
from fleet_tui.model.attention import SeenArea
from fleet_tui.text.language import Message, joined
from fleet_tui.ui.view.map.camera import ZOOM_STEP, seen_area
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.modes.mode import CursorMode, MapMode, ViewMode
from fleet_tui.ui.widgets.map_view import MapView, post_pick

_REPEATS = 0.15  # seconds; presses closer than this are from a held key
_LONGEST = 4


@dataclass(frozen=True, slots=True)
class Stride:
    """The last step of a panning key: its direction, its time (seconds), the duration of the hold."""

    way: tuple[int, int] = (0, 0)
    at: float = 0.0
    repeats: int = 0

    def then(self, way: tuple[int, int], now: float) -> "Stride":
        """Return the step after this one."""
        held = way == self.way and now - self.at < _REPEATS
        return Stride(way, now, self.repeats + 1 if held else 0)

    @property
    def times(self) -> int:
        """Return the number of single steps of this one: it grows up to a limit."""
        return min(1 + self.repeats // 3, _LONGEST)


class MapControls:
    """Changes the view of the map pane. Without a scene only the options change. `say` shows a text to the
    operator, `to_next` are the keys that go to the next vertex, `menu` is for Enter without a cursor."""

    def __init__(
        self,
        view: MapView,
        say: Callable[[Message], None] = lambda _: None,
        to_next: Sequence[str] = (),
        menu: Callable[[], None] = lambda: None,
    ) -> None:
        self._view = view
        self._picture = view.picture
        self._say = say
        self._to_next = to_next
        self._menu = menu
        self._stride = Stride()

    def pan(self, dx: int, dy: int) -> None:
        """Have the mode follow the arrow keys: faster while the key is held."""
        scene, mode = self._picture.scene, self._picture.mode
        if scene is not None:
            self._stride = self._stride.then((dx, dy), monotonic())
            times = self._stride.times
            mode.move(self._picture.viewport, scene, dx * times, dy * times)
            self.enter(mode)

    def zoom_in(self, factor: float = ZOOM_STEP) -> None:
        """Zoom in, with a factor below 1 out, about the robot or the centre."""
        if self._picture.scene is not None:
            self._picture.viewport.zoom(self._picture.scene, factor)
            self._view.draw()

    def zoom_out(self) -> None:
        self.zoom_in(1 / ZOOM_STEP)

    def fit(self) -> None:
        """Show the whole floor."""
        if self._picture.scene is not None:
            self._picture.viewport.fit(self._picture.scene)
            self._view.draw()

    def zoom_about(self) -> None:
        """Zoom about the selected robot, or about the centre of the view."""
        view = self._picture.viewport
        view.zoom_robot = not view.zoom_robot
        self._say(
            Message("zooming keeps the robot in place")
            if view.zoom_robot
            else Message("zooming keeps the centre in place")
        )
        self._view.draw()

    def follow(self) -> None:
        """Follow the selected robot from the middle of the view, or stop following."""
        view, scene = self._picture.viewport, self._picture.scene
        view.follow = not view.follow
        if view.follow and scene is not None:
            view.centre(scene)
            if scene.selected is None:
                self._say(Message("the map follows the robot wherever its position is known"))
        self._view.draw()

    def stop_following(self) -> None:
        """Let the view be brought elsewhere, and say so if it followed a robot."""
        if self._picture.viewport.follow:
            self._picture.viewport.follow = False
            self._say(Message("follow off"))

    def centre(self, at: tuple[float, float] | None = None) -> None:
        """Centre once, on a place in metres of the shown floor, or on the selected robot."""
        if self._picture.scene is not None:
            self._picture.viewport.centre(self._picture.scene, at)
            self._view.draw()

    def reveal(self, at: tuple[float, float] | None = None) -> None:
        """Centre on a place in metres, or on the selected robot, if it is out of view."""
        scene = self._picture.scene
        robot = scene.selected if scene is not None else None
        place = at or ((robot.pose.x, robot.pose.y) if robot is not None else None)
        if scene is None or place is None:
            return
        camera = self._picture.viewport.camera(scene)
        pixel = scene.frame.to_pixel(*place)
        if all(map(math.isfinite, pixel)) and not camera.shows(*camera.to_cell(*pixel)):
            self.centre(at)

    def seen(self) -> SeenArea | None:
        """Return the area that the map shows, None without a scene."""
        scene = self._picture.scene
        return seen_area(self._picture.viewport.camera(scene), scene.frame) if scene is not None else None

    def edges(self) -> None:
        """Show or hide the graph's edges."""
        options, are_shown = self._picture.options, self._picture.look.edges
        self._picture.options = replace(options, edges=not are_shown)
        self._view.draw()

    def labels(self) -> None:
        """Show or hide the labels."""
        options = self._picture.options
        self._picture.options = replace(options, labels=not options.labels)
        self._view.draw()

    def trails(self) -> None:
        """Show or hide the robots' positions of the last minute."""
        options = self._picture.options
        self._picture.options = replace(options, trails=not options.trails)
        self._view.draw()

    def drawing(self) -> None:
        """Go to the next drawing style."""
        options, styles = self._picture.options, list(Drawing)
        following = styles[(styles.index(options.drawing) + 1) % len(styles)]
        self._picture.options = replace(options, drawing=following)
        self._say(Message("drawing: {drawing}", drawing=Message(following.value)))
        self._view.draw()

    def enter(self, mode: MapMode) -> None:
        """Switch the map to this mode, which takes the focus with it: its keys are those of the map."""
        is_new = type(mode) is not type(self._picture.mode)
        self._picture.mode = mode
        if is_new and mode.cursor is not None:
            self._focus()
        self._picture.point()
        self._view.draw()

    def _focus(self) -> None:
        if self._view.size.height and not self._view.has_focus:
            self._view.screen.set_focus(self._view)

    def leave_mode(self) -> None:
        """Go back to the plain view."""
        if not isinstance(self._picture.mode, ViewMode):
            self.enter(ViewMode())

    def cursor(self) -> None:
        """Turn the cursor on, in the middle of the view, or off."""
        picture = self._picture
        if picture.mode.cursor is None and picture.scene is not None:
            self.enter(CursorMode(picture.viewport.middle(picture.scene)))
        else:
            self.enter(ViewMode())

    def next_vertex(self, step: int) -> None:
        """Put the cursor on the next (1) or previous (-1) labelled vertex, brought into the view."""
        picture = self._picture
        cursor = picture.mode.cursor
        place = picture.viewport.next_labelled(picture.scene, cursor, step) if picture.scene else None
        if place:
            self.enter(CursorMode(place))
            self._focus()

    def pick(self) -> None:
        """Pick the object that Enter means in this mode."""
        picture = self._picture
        if isinstance(picture.mode, ViewMode):
            self._menu()
            return
        found = picture.mode.pick(picture.viewport, picture.scene) if picture.scene is not None else None
        post_pick(self._view, found)
        if found is None:
            way = [
                Message("{key_name} goes to the next one", key_name=key_name(key))
                for key in self._to_next[:1]
            ]
            self._say(joined(": ", [Message("no place here"), *way]))
