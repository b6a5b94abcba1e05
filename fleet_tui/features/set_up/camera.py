"""The camera of the selected robot, watched while its picture is open."""

from collections.abc import Callable
from typing import NamedTuple

from fleet_tui.model.kind import CAMERA
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.streams import CameraImage, Streamed
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.camera.decoding import Decoded, decode
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.view.camera.caption import CameraFacts, PictureRate, caption, note
from fleet_tui.ui.view.camera.cells import PictureCells, half_blocks, ramp
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.widgets.camera_view import CameraView


class PictureTerminal(NamedTuple):
    """The terminal of a picture: the bytes ever `sent`, the `limit` of bytes a second, and whether it is
    drawn with characters alone."""

    sent: Callable[[], int]
    limit: float
    is_plain: Callable[[], bool]


class PictureRequest(NamedTuple):
    """A picture to be made: of a message, in a size, plain or coloured."""

    streamed: Streamed
    space: tuple[int, int]
    is_plain: bool


class CameraControls:
    """Opens and closes the picture, and decodes the newest message in a thread: never two at once, and none
    is queued."""

    def __init__(self, console: Console, view: CameraView, terminal: PictureTerminal) -> None:
        self._store = console.store
        self._backend = console.backend
        self._navigation = console.navigation
        self._view = view
        self._in_background = console.in_background
        self._terminal = terminal
        self._rate = PictureRate(terminal.limit)
        self.is_open = False
        self._robot = ""
        self._made: PictureRequest | None = None
        self._is_decoding = False
        self._decoded = Decoded(None)
        self._picture: PictureCells | None = None

    @property
    def lack(self) -> Message:
        """Return the reason that the selected robot has no camera, empty if it has one."""
        kind = self._store.state.robots[self._navigation.robot].kind
        return EMPTY if CAMERA in kind.streams else kind.lack(CAMERA)

    def turn(self, on: bool) -> None:
        """Begin or end to show the camera of the selected robot."""
        self.is_open = on
        self.look()

    def look(self) -> None:
        """Show the newest picture and its age. Call it at every tick."""
        robot = self._store.state.robots[self._navigation.robot]
        self._watch(robot.name if self.is_open and CAMERA in robot.kind.streams else "")
        if not self.is_open:
            return
        streamed = self._backend.streams.get(robot.name, CAMERA)
        if streamed is not None:
            self._decode(PictureRequest(streamed, self._view.space, self._terminal.is_plain()))
        facts = self._facts(robot, streamed)
        (text, warns), missing = caption(facts, self._view.space[0] - 4), note(facts)
        role = StyleRole.WARN if warns else StyleRole.TITLE
        waits = "" if self._picture is not None else note(CameraFacts(robot.name))
        rule = "-" if self._terminal.is_plain() else "─"
        self._view.show((text, role), missing or waits, None if missing else self._picture, rule)

    def _facts(self, robot: Robot, streamed: Streamed | None) -> CameraFacts:
        if CAMERA not in robot.kind.streams:
            return CameraFacts(robot.name, problem=robot.kind.lack(CAMERA))
        if streamed is None or not isinstance(streamed.value, CameraImage):
            return CameraFacts(robot.name)
        if streamed.value.unshown:  # whatever came was no picture: it has no age
            return CameraFacts(robot.name, problem=streamed.value.unshown)
        seconds = self._store.state.now - streamed.taken_at
        return CameraFacts(robot.name, self._decoded.size, seconds, self._rate.text, self._decoded.reason)

    def _watch(self, robot: str) -> None:
        if robot == self._robot:
            return
        if self._robot:
            self._backend.unwatch(self._robot, CAMERA)
        if robot:
            self._backend.watch(robot, CAMERA)
        self._robot = robot
        self._made = None
        self._decoded = Decoded(None)
        self._picture = None
        self._rate.restart()

    def _decode(self, wanted: PictureRequest) -> None:
        image, before = wanted.streamed.value, self._made
        is_resized = before is not None and before[1:] != wanted[1:]
        is_due = is_resized or self._rate.is_due(self._store.state.now)
        if self._is_decoding or wanted == before or not is_due or min(wanted.space) < 1:
            return
        if not isinstance(image, CameraImage) or not image.data:
            return
        self._is_decoding = True
        robot = self._robot
        self._in_background(lambda: _made(image.data, wanted), lambda made: self._take(robot, wanted, *made))

    def _take(
        self, robot: str, wanted: PictureRequest, decoded: Decoded, picture: PictureCells | None
    ) -> None:
        """Take a picture that was decoded; the robot may have been left meanwhile."""
        self._is_decoding = False
        if robot == self._robot:
            self._made = wanted
            self._decoded = decoded
            self._picture = picture
            self._rate.take(self._store.state.now, self._terminal.sent())
            self.look()


def _made(data: bytes, wanted: PictureRequest) -> tuple[Decoded, PictureCells | None]:
    width, height = wanted.space
    decoded = decode(data, width, height)
    if decoded.pixels is None:
        return decoded, None
    return decoded, (ramp if wanted.is_plain else half_blocks)(decoded.pixels)
