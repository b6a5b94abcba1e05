"""The controller of drives: entry, steering, and the reasons to end."""

from collections.abc import Callable

import pytest
from msgspec.structs import replace

from fleet_tui.commands.driving.hold import TAP
from fleet_tui.features.drive.controls import LATEST, LET_GO, DriveControls
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import DRIVE
from fleet_tui.model.problem import Permissions
from fleet_tui.model.set_up.driving import STILL, DrivePhase, DriveState
from fleet_tui.robots.profile import DriveConfig
from fleet_tui.text.language import Message
from fleet_tui.ui.controllers.map import MapControls
from fleet_tui.ui.view.map.viewport import Viewport
from fleet_tui.ui.widgets.map_view import MapView
from tests.support.desk import Desk, StubDrive
from tests.support.fleets import R0, fleet, link_up, of_kinds, pose, queue, reduced, tick
from tests.support.map_pane import SCENE

T0 = 100.0
PLAIN = fleet(1).robots[R0].kind
DRIVEN = replace(PLAIN, accepts=(*PLAIN.accepts, DRIVE))
DECLARED = DriveConfig(robot_timeout=0.5)


def standing() -> FleetState:
    return of_kinds(reduced(fleet(1), link_up(T0), pose(T0), tick(T0 + 0.5)), DRIVEN)


class Bench:
    """The controller on a desk, with a clock to set."""

    def __init__(
        self, limits: DriveConfig = DECLARED, state: FleetState | None = None, may: Permissions | None = None
    ) -> None:
        self.desk = Desk(state or standing(), may)
        self.view, self.now, self.focused = MapView(), T0, 0
        self.told = list[bool]()
        self.view.picture.show(SCENE)
        desk = self.desk
        self.drives = DriveControls(
            desk.console(drive={R0: limits}),
            controls=MapControls(self.view),
            picture=self.view.picture,
            focus=self._focus,
            is_shown=lambda: True,
            passes=frozenset(),
            tell_releases=self.told.append,
            clock=lambda: self.now,
        )

    def _focus(self) -> None:
        self.focused += 1

    @property
    def drive(self) -> StubDrive:
        return self.desk.backend.drives[-1]

    def began(self) -> "Bench":
        self.drives.start()
        self.drive.state = DriveState(DrivePhase.READY)
        return self

    def look(self, seconds: float = 0.1) -> None:
        self.now += seconds
        self.drives.look(SCENE)


def test_a_declared_timeout_needs_no_question_and_the_map_follows_the_robot() -> None:
    it = Bench().began()
    assert it.drives.mode is not None and it.focused == 1 and it.desk.answers == []
    assert it.view.picture.viewport.follow
    it.drives.leave()
    assert it.drives.mode is None
    assert it.drive.state.reason == "left by key" and it.view.picture.viewport.follow is Viewport().follow


def test_the_end_of_the_last_drive_is_not_told_in_the_next() -> None:
    it = Bench().began()
    it.drives.end(Message("someone else drives"))
    assert "is not driven any more" in it.desk.notices.text
    it.began()
    assert it.desk.notices.text == "robot_0 drives while a key is held; this is not an emergency stop"


def test_without_one_only_a_yes_begins_it() -> None:
    it = Bench(DriveConfig())
    it.drives.start()
    assert it.desk.backend.drives == [] and it.drives.mode is None
    it.desk.say_yes()
    assert len(it.desk.backend.drives) == 1 and it.drives.mode is not None


def test_what_changed_during_the_question_is_looked_at_again() -> None:
    it = Bench(DriveConfig())
    it.drives.start()
    it.desk.store.put(reduced(standing(), queue(T0 + 0.6, (1, 1, 2, "W"))))
    it.desk.say_yes()
    assert it.desk.backend.drives == []
    assert it.desk.notices.text == f"not driven: {R0} has 1 order: cancel or clear first"


@pytest.mark.parametrize("may", [Permissions(armed=False), Permissions(read_only=True)])
def test_a_console_without_permission_drives_nothing(may: Permissions) -> None:
    it = Bench(may=may)
    it.drives.start()
    assert it.desk.backend.drives == [] and it.desk.notices.text


def test_a_press_steers_until_it_is_over_and_a_release_is_sent_once() -> None:
    it = Bench().began()
    it.drives.press("w")
    (first,) = it.drive.steered
    assert first.speeds.ahead == pytest.approx(0.1) and first.until == pytest.approx(T0 + TAP)
    it.look(TAP + 0.05)
    assert it.drive.steered[-1].speeds == STILL
    it.look()
    assert len(it.drive.steered) == 2


def test_nothing_is_kept_for_a_drive_that_has_not_begun() -> None:
    it = Bench()
    it.drives.start()
    it.drives.press("w")
    it.drive.state = DriveState(DrivePhase.READY)
    it.look()
    assert it.drive.steered == []


def test_speeds_change_by_steps_and_any_other_key_stops() -> None:
    it = Bench().began()
    it.drives.press("w")
    it.drives.change_speed(1)
    assert it.drive.steered[-1].speeds.ahead == pytest.approx(0.15)
    it.drives.stop()
    assert it.drive.steered[-1].speeds == STILL and it.drives.mode is not None


def test_sideways_needs_a_robot_that_can() -> None:
    it = Bench().began()
    it.drives.press("q")
    assert it.drive.steered == [] and "holonomic" in it.desk.notices.text
    it = Bench(DriveConfig(robot_timeout=0.5, holonomic=True)).began()
    it.drives.press("q")
    assert it.drive.steered[-1].speeds.sideways > 0.0


def ended(it: Bench) -> None:
    it.drive.state = DriveState(DrivePhase.ENDED, reason=Message("someone else drives"))


def ordered(it: Bench) -> None:
    it.desk.store.put(reduced(standing(), queue(T0 + 0.6, (1, 1, 2, "W"))))


def disarmed(it: Bench) -> None:
    it.desk.dispatch.arm()


def elsewhere(it: Bench) -> None:
    it.view.picture.mode.floor = "floor_9"  # type: ignore[attr-defined]  # it is a DriveMode


def frozen(it: Bench) -> None:
    it.now += LATEST


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (ended, "someone else drives"),
        (ordered, f"{R0} has 1 order"),
        (disarmed, "not sent: this console is not armed"),
        (elsewhere, "another floor"),
        (frozen, "the screen was late"),
    ],
)
def test_it_ends_with_the_reason_in_words(change: Callable[[Bench], None], reason: str) -> None:
    it = Bench().began()
    it.drives.press("w")
    change(it)
    it.look()
    assert it.drive.state.phase is DrivePhase.ENDED
    assert it.drive.state.reason.startswith(reason)
    assert it.desk.notices.text.startswith(f"{R0} is not driven any more: {reason}")
    it.drives.press("w")
    it.look(LET_GO - 0.1)
    assert it.drives.mode is not None and len(it.drive.steered) == 1, "a key may still be held"
    it.look()
    it.look()
    assert it.drives.mode is None


@pytest.mark.parametrize("end", [DriveControls.stop, DriveControls.leave, lambda drives: drives.release("w")])
def test_a_hand_that_lets_go_has_its_keys_back(end: Callable[[DriveControls], None]) -> None:
    it = Bench().began()
    it.drives.press("w")
    ended(it)
    it.look()
    assert it.drives.mode is not None
    end(it.drives)
    assert it.drives.mode is None


def test_a_release_that_the_terminal_tells_stops_at_once() -> None:
    it = Bench().began()
    it.drives.press("w")
    it.drives.release("s")
    assert it.drive.steered[-1].speeds != STILL
    it.drives.release("w")
    assert it.drive.steered[-1].speeds == STILL
    it.drives.leave()
    it.drives.release("w")
    assert it.told == [True, False]
