"""Opens and closes the camera, above the map or in its place."""

from collections.abc import Callable

from textual.widget import Widget

from fleet_tui.features.set_up.camera import CameraControls
from fleet_tui.text.language import Message
from fleet_tui.ui.widgets.camera_view import CameraView
from fleet_tui.ui.widgets.panes import Panes


class CameraSwitch:
    """`view` is in the pane of the map."""

    def __init__(
        self,
        panes: Panes,
        map_view: Widget,
        view: CameraView,
        controls: CameraControls,
        say: Callable[[Message], None],
    ) -> None:
        self._panes = panes
        self._map = map_view
        self.view = view
        self._controls = controls
        self._say = say

    def turn(self) -> None:
        """Show or hide the camera of the selected robot."""
        on, screen = not self._controls.is_open, self._panes.screen
        if on and (reason := self._controls.lack):
            self._say(reason)
            return
        if on and (screen.has_class("-tiny") or screen.has_class("-flat")):
            self._say(Message("no space for a picture: 60 columns and 16 lines at least"))
            return
        self.view.display = on
        self._panes.set_class(on, "-camera")
        if on and not (screen.has_class("-wide") and screen.has_class("-tall")):
            screen.set_focus(self.view)
        elif not on and self.view.has_focus:
            screen.set_focus(self._map)
        self._controls.turn(on)
