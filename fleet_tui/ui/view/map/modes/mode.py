"""Map modes: the effect of arrows and Enter on the map, extra layers, and the caption."""

from typing import Protocol

from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.map.layer_stack import Layer
from fleet_tui.ui.view.map.layers import draw_cursor
from fleet_tui.ui.view.map.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.ui.view.map.viewport import Viewport, pick

# cells of one press: about as far in both directions
COLUMNS = 4
ROWS = 2
Point = tuple[float, float]
"""x, y in metres."""


def place_text(title: str, floor: str, shown: str, place: Point) -> str:
    """Return a mode's title with its cursor's place in metres, and its floor if another one is shown."""
    # Adding 0 turns -0.0 into 0.0.
    x, y = (round(metres, 2) + 0.0 for metres in place)
    return f"{title} {'' if floor == shown else sanitize(floor) + ' '}{x:.2f}, {y:.2f} m"


class MapMode(Protocol):
    """One way to work on the map; the map has one at a time."""

    layers: tuple[Layer, ...]
    """Drawn over everything else."""
    points: bool
    """The label of the vertex under its cursor precedes others."""

    @property
    def cursor(self) -> Point | None:
        """Return the place of the map's cursor, None if the mode has none."""

    def banner(self, shown: str) -> str:
        """Return text for the caption of the shown floor, empty for none."""

    def adjusted(self, scene: Scene) -> Scene:
        """Return the scene as this mode shows it."""

    def move(self, view: Viewport, scene: Scene, dx: int, dy: int) -> None:
        """Follow the arrow keys by steps to the right and down."""

    def pick(self, view: Viewport, scene: Scene) -> SceneRobot | SceneVertex | None:
        """Return the result of Enter."""

    def press(self, view: Viewport, scene: Scene, at: Point) -> bool | None:
        """Take a press of the mouse: True if `drag` follows, False if the map moves then; None if a click
        picks what it always does."""

    def drag(self, at: Point) -> None:
        """Follow the mouse."""


class PlainMode:
    """The map as it is: the mouse pans, and picks what is there."""

    layers: tuple[Layer, ...] = ()
    points = True
    cursor: Point | None = None

    def banner(self, shown: str) -> str:
        """Return no text."""
        return ""

    def adjusted(self, scene: Scene) -> Scene:
        """Change nothing."""
        return scene

    def press(self, view: Viewport, scene: Scene, at: Point) -> bool | None:
        """Leave it to the map."""
        return None

    def drag(self, at: Point) -> None:
        """Do nothing."""


class ViewMode(PlainMode):
    """Arrows move the view; Enter picks nothing."""

    def move(self, view: Viewport, scene: Scene, dx: int, dy: int) -> None:
        """Pan, about as far in both directions."""
        view.pan(scene, dx * COLUMNS, dy * ROWS)

    def pick(self, view: Viewport, scene: Scene) -> None:
        """Pick nothing."""


class CursorMode(PlainMode):
    """Arrows move a cursor by cells; Enter picks the object under it."""

    layers: tuple[Layer, ...] = (draw_cursor,)

    def __init__(self, cursor: Point) -> None:
        self.cursor: Point = cursor

    def banner(self, shown: str) -> str:
        """Return the cursor's place."""
        # Adding 0 turns -0.0 into 0.0.
        x, y = (round(metres, 1) + 0.0 for metres in self.cursor)
        return f"x {x:.1f} y {y:.1f} m"

    def move(self, view: Viewport, scene: Scene, dx: int, dy: int) -> None:
        """Move the cursor; at the edge the view moves with it."""
        self.cursor = view.stepped(scene, self.cursor, dx, dy)

    def pick(self, view: Viewport, scene: Scene) -> SceneRobot | SceneVertex | None:
        """Return the vertex that the cursor was set on, even below a robot, else the nearest object."""
        on = [vertex for vertex in scene.vertices if (vertex.x, vertex.y) == self.cursor]
        camera = view.camera(scene)
        return on[0] if on else pick(scene, camera, *camera.to_cell(*scene.frame.to_pixel(*self.cursor)))
