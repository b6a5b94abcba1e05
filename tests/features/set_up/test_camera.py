"""The camera of the selected robot: watched while it is open, the newest picture only, its age told."""

import io
from collections.abc import Callable
from typing import Any

from msgspec.structs import replace
from PIL import Image

from fleet_tui.features.set_up.camera import CameraControls, PictureTerminal
from fleet_tui.model.kind import CAMERA
from fleet_tui.model.set_up.streams import CameraImage, Streamed
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.view.camera.cells import PictureCells
from fleet_tui.ui.widgets.camera_view import CameraView
from tests.support.desk import Desk, ready
from tests.support.fleets import T0, of_kinds, tick

KIND = replace(ready().robots["robot_0"].kind, streams=(CAMERA,))


def jpeg(colour: str) -> bytes:
    into = io.BytesIO()
    Image.new("RGB", (64, 48), colour).save(into, "JPEG")
    return into.getvalue()


class KeepingView(CameraView):
    """Keeps what it is asked to show."""

    space = (20, 10)
    heading, note = "", ""
    picture: PictureCells | None = None

    def show(self, heading: Any, note: str, picture: PictureCells | None, rule: str = "─") -> None:
        self.heading, self.note, self.picture = heading[0], note, picture


class Pane:
    """The controller on a desk; its threads' work waits in `pending`."""

    def __init__(self, kind: object = KIND) -> None:
        assert isinstance(kind, type(KIND))
        state = of_kinds(ready(), kind)
        second = replace(state.robots["robot_0"], name="robot_1")
        self.desk = Desk(replace(state, robots={**state.robots, "robot_1": second}))
        self.view = KeepingView()
        self.pending: list[Callable[[], None]] = []
        self.sent = 0
        terminal = PictureTerminal(lambda: self.sent, 60_000.0, lambda: False)
        self.desk.in_background = self._later
        self.controls = CameraControls(self.desk.console(), self.view, terminal)

    def _later(self, work: Callable[[], Any], then: Callable[[Any], None]) -> None:
        self.pending.append(lambda: then(work()))

    def tick(self, at: float) -> None:
        self.desk.store.apply(tick(at))
        self.controls.look()

    def put(self, data: bytes, at: float, unshown: Message = EMPTY) -> None:
        streamed = Streamed(CameraImage(data, None, unshown), at, at)
        self.desk.backend.streams.put("robot_0", CAMERA, streamed)

    def work(self) -> int:
        done, self.pending = self.pending, []
        for one in done:
            one()
        return len(done)


def test_it_is_watched_while_it_is_open() -> None:
    pane = Pane()
    streams = pane.desk.backend.streams
    pane.controls.turn(True)
    assert streams.wants("robot_0", CAMERA) and pane.view.note == "waiting for the first picture"
    pane.controls.turn(False)
    assert not streams.wants("robot_0", CAMERA)


def test_the_newest_picture_alone_is_decoded_one_at_a_time() -> None:
    pane = Pane()
    pane.controls.turn(True)
    pane.put(jpeg("red"), T0 + 1)
    pane.tick(T0 + 1)
    pane.put(jpeg("green"), T0 + 1.2)
    pane.put(jpeg("blue"), T0 + 1.5)
    pane.tick(T0 + 1.5)
    assert pane.work() == 1 and not pane.pending, "the next one waits for its time"
    pane.tick(T0 + 2)
    assert pane.work() == 1
    assert pane.view.heading.startswith("Camera") and pane.view.picture is not None
    assert pane.view.picture.colours is not None and pane.view.picture.colours[2, 5].tolist() == [21, 21]
    assert pane.work() == 0


def test_over_the_budget_the_rate_halves() -> None:
    pane = Pane()
    pane.view.space = (60, 10)
    pane.controls.turn(True)
    for number in range(3):
        pane.put(jpeg("red"), T0 + number)
        pane.tick(T0 + number)
        pane.work()
        pane.sent += 100_000
    assert "0.5 fps (limit 60 kB/s)" in pane.view.heading


def test_an_old_picture_is_marked_and_then_gone() -> None:
    pane = Pane()
    pane.controls.turn(True)
    pane.put(jpeg("red"), T0 + 1)
    pane.tick(T0 + 1)
    pane.work()
    pane.tick(T0 + 12)
    assert pane.view.picture is None and pane.view.note == "no picture for 11 s"


def test_a_picture_that_is_not_shown_is_named() -> None:
    pane = Pane()
    pane.controls.turn(True)
    pane.put(b"", T0 + 1, Message("format rvl is not shown, only JPEG and PNG"))
    pane.tick(T0 + 1)
    assert pane.work() == 0 and pane.view.note == "no picture: format rvl is not shown, only JPEG and PNG"
    pane.put(jpeg("red")[:200], T0 + 2)
    pane.tick(T0 + 2)
    pane.work()
    assert pane.view.note.startswith("no picture: unreadable")


def test_another_robot_has_another_camera() -> None:
    pane = Pane()
    pane.controls.turn(True)
    pane.put(jpeg("red"), T0 + 1)
    pane.tick(T0 + 1)
    pane.desk.navigation.select("robot_1")
    pane.tick(T0 + 1.1)
    assert pane.work() == 1 and pane.view.picture is None, "the picture of the robot before is dropped"
    assert not pane.desk.backend.streams.wants("robot_0", CAMERA)
    assert pane.desk.backend.streams.wants("robot_1", CAMERA)


def test_a_robot_without_a_camera_says_so() -> None:
    pane = Pane(replace(KIND, streams=()))
    assert "camera" in pane.controls.lack
    pane.controls.turn(True)
    assert "no camera" in pane.view.note
