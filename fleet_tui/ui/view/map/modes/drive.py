"""The map mode of driving by hand: its banner, and the keys that it takes before all others."""

from collections.abc import Callable

from fleet_tui.commands.driving.clearance import FAR
from fleet_tui.commands.driving.speed import SLOW_WITHIN, Caps
from fleet_tui.model.set_up.driving import DrivePhase, DriveState
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import fit, sanitize
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.layer_stack import Layer
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.modes.mode import PlainMode
from fleet_tui.ui.view.map.scene import Scene
from fleet_tui.ui.view.map.viewport import Viewport
from fleet_tui.ui.view.roles import StyleRole

BAR = 8
"""Cells of the speed bar."""


class DriveMode(PlainMode):
    """Shows a drive. `share` of the caps is what a held key reaches; `passes` are Textual's names of the keys
    that have a meaning while it lasts: any other calls `stop`. `left` is called once the map loses the
    focus."""

    points = False

    def __init__(
        self,
        robot: str,
        floor: str,
        caps: Caps,
        passes: frozenset[str],
        stop: Callable[[], None],
        left: Callable[[], None],
    ) -> None:
        self.robot = robot
        self.floor = floor
        self.caps = caps
        self.passes = passes
        self.stop = stop
        self.left = left
        self.state = DriveState()
        self.share = 0.0
        self.layers: tuple[Layer, ...] = (self._draw,)
        self.clearance: float | None = None
        """Metres ahead, None while it does not drive ahead or the floor has no map."""

    def banner(self, shown: str) -> str:
        """Return robot and speed."""
        if self.state.phase is DrivePhase.STARTING:
            return tr("DRIVE {robot}: starting", robot=sanitize(self.robot))
        if self.state.phase is DrivePhase.ENDED:
            return tr("DRIVE {robot} ended: let go of the key", robot=sanitize(self.robot))
        return tr(
            "DRIVE {robot} {linear} m/s", robot=sanitize(self.robot), linear=f"{self.state.sent.linear:.2f}"
        )

    @property
    def gauges(self) -> str:
        """Return the speed bar, the clearance, the turn and the round trip."""
        turning, trip, free = self.state.sent.turning, self.state.round_trip, self.clearance
        parts = [self._bar]
        if free is not None:
            more = tr("over ") if free >= FAR else tr("SLOW ") if free < SLOW_WITHIN else ""
            parts.append(tr("{more}{free} m free", more=more, free=f"{free:.1f}"))
        if turning:
            parts.append(f"{tr('left') if turning > 0 else tr('right')} {abs(turning):.2f} rad/s")
        if trip is not None:
            parts.append(tr("{trip} ms", trip=f"{trip * 1000:.0f}"))
        return "  ".join(parts)

    def move(self, view: Viewport, scene: Scene, dx: int, dy: int) -> None:
        """Do nothing: arrows stop the robot."""

    def pick(self, view: Viewport, scene: Scene) -> None:
        """Pick nothing."""

    def _draw(self, cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
        """Write the gauges into the first row of the map, where the caption has no space."""
        if scene.floor == self.floor and self.state.phase not in (DrivePhase.STARTING, DrivePhase.ENDED):
            slow = self.clearance is not None and self.clearance < SLOW_WITHIN
            text = fit(f" {self.gauges} ", camera.width)
            cells.write(0, 0, text, StyleRole.WARN if slow else StyleRole.TEXT)

    @property
    def _bar(self) -> str:
        """Return the speed, and the speed that a held key reaches, as shares of the cap."""
        driven = self.state.sent.linear / self.caps.linear
        now, most = (round(min(share, 1.0) * BAR) for share in (driven, self.share))
        return f"[{'#' * now}{'-' * max(most - now, 0)}{' ' * (BAR - max(now, most))}]"
