"""Driving by hand: from the key to the robot, and every reason to end it."""

import time
from collections.abc import Callable

from fleet_tui.commands.driving.entry import drive_refusal
from fleet_tui.commands.driving.hold import Hand
from fleet_tui.commands.driving.speed import FIRST, Caps, faster, slowed, wanted
from fleet_tui.commands.set_up.checks import map_of
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.driving import STILL, DrivePhase, HandDrive, Speeds, Steering
from fleet_tui.robots.profile import DriveConfig
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.files import ConsoleFiles
from fleet_tui.ui.controllers.map import MapControls
from fleet_tui.ui.view.map.map_picture import MapPicture
from fleet_tui.ui.view.map.modes.drive import DriveMode
from fleet_tui.ui.view.map.scene import Scene

EVERY = 0.1
"""Seconds between two looks at the map in the same direction."""


class ClearanceAhead:
    """Keeps the newest clearance in metres."""

    def __init__(self) -> None:
        self._at = 0.0
        self._ways = (0.0, 0.0)
        self._metres = 0.0
        self._known = False

    def of(self, state: FleetState, robot: Robot, speeds: Speeds, now: float) -> float | None:
        """Return the clearance at a monotonic second, None if it does not drive ahead or has no map."""
        # With numpy, whose import takes longer than the first picture.
        from fleet_tui.commands.driving.clearance import USUAL_SIZE, clearance

        ways = speeds.ahead, speeds.sideways
        grid = map_of(state, robot, robot.floor) if robot.floor is not None else None
        if grid is None or robot.pose is None or ways == (0.0, 0.0):
            self._known = False
            return None
        if not self._known or ways != self._ways or now - self._at >= EVERY:
            found = clearance(grid, robot.pose.value, robot.size or USUAL_SIZE, speeds)
            self._known = found is not None
            self._metres = found or 0.0
            self._at = now
            self._ways = ways
        return self._metres if self._known else None


class DriveJournal:
    """Writes the begin and the end of each drive."""

    def __init__(self, files: ConsoleFiles) -> None:
        self._files = files
        self._robot = ""
        self._began = 0.0
        self._linear = 0.0
        self._angular = 0.0

    def begin(self, robot: str, at: float) -> None:
        """Note that a drive begins at a monotonic second."""
        self._robot = robot
        self._began = at
        self._linear = 0.0
        self._angular = 0.0
        self._files.log("drive begun", robot)

    def sent(self, speeds: Speeds) -> None:
        """Take the speeds of the newest frame."""
        self._linear = max(self._linear, speeds.linear)
        self._angular = max(self._angular, abs(speeds.turning))

    def end(self, reason: Message, at: float) -> None:
        """Note the end of the drive."""
        most = Message(
            "at most {linear} m/s and {angular} rad/s",
            linear=f"{self._linear:.2f}",
            angular=f"{self._angular:.2f}",
        )
        self._files.log(
            "drive ended",
            Message(
                "{robot}: {reason}, after {age}, {most}",
                robot=self._robot,
                reason=reason,
                age=age(at - self._began),
                most=most,
            ),
        )


SIDEWAYS = ("q", "e")
LATEST = 1.5
"""Seconds between two pictures after which a drive ends: the screen does not show where the robot is."""
LET_GO = 1.0
"""Seconds without a direction's key after which none is taken as held. A drive that ended keeps its keys
until then: a held `a` would acknowledge an alarm."""


class DriveControls:
    """The mode of the map in which the selected robot is driven. `limits` by robot; `focus` gives the map
    the focus, `is_shown` tells whether it is in view; `passes` are the keys that have a meaning in it,
    `tell_releases` asks the terminal for the releases of keys."""

    def __init__(
        self,
        console: Console,
        *,
        controls: MapControls,
        picture: MapPicture,
        focus: Callable[[], None],
        is_shown: Callable[[], bool],
        passes: frozenset[str],
        tell_releases: Callable[[bool], None],
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._console = console
        self._backend = console.backend
        self._by_robot = console.settings.drive
        self._controls = controls
        self._picture = picture
        self._journal = DriveJournal(console.files)
        self._ask = console.ask
        self._focus = focus
        self._is_shown = is_shown
        self._passes = passes
        self._clock = clock
        self._tell_releases = tell_releases
        self.drive: HandDrive | None = None
        self._hand = Hand()
        self._share = FIRST
        self._steered = False
        self._looked = 0.0
        self._pressed = 0.0
        self._followed = False
        self._clearance = ClearanceAhead()

    @property
    def mode(self) -> DriveMode | None:
        """Return the mode while a robot is driven."""
        mode = self._picture.mode
        return mode if isinstance(mode, DriveMode) else None

    @property
    def _state(self) -> FleetState:
        return self._console.store.state

    @property
    def _robot(self) -> Robot:
        name = self.mode.robot if self.mode is not None else self._console.navigation.robot
        return self._console.store.state.robots[name]

    @property
    def _limits(self) -> DriveConfig:
        return self._by_robot[self._robot.name]

    @property
    def _caps(self) -> Caps:
        return Caps(self._limits.max_linear, self._limits.max_angular)

    def _refusal(self) -> Message:
        if not self._is_shown():
            return Message("no map in view: close the camera (V), or enlarge the terminal")
        return self._console.dispatch.set_up_refusal() or drive_refusal(self._state, self._robot)

    def start(self) -> None:
        """Drive the selected robot, after a question if it may not stop by itself."""
        name = self._console.navigation.robot
        if refusal := self._refusal():
            self._console.notices.say(sanitize(refusal))
        elif self._limits.robot_timeout is None:
            question = Message(
                "{name} may not stop by itself when the link is cut: drive all the same?", name=name
            )
            self._ask(lambda: sanitize(question), lambda: self._begin(name))
        else:
            self._begin(name)

    def _begin(self, name: str) -> None:
        """Begin, checked again: much may have changed during the question."""
        try:
            if self._console.navigation.robot != name:
                raise CommandError(Message("another robot is selected"))
            if refusal := self._refusal():
                raise CommandError(refusal)
            self.drive = self._backend.drive(name)
        except CommandError as problem:
            self._console.notices.say(sanitize(Message("not driven: {problem}", problem=problem)))
            return
        self._hand, self._share, self._steered, self._looked = Hand(), FIRST, False, self._clock()
        self._journal.begin(name, self._clock())
        self._console.navigation.find_robot(name)
        floor, view = self._console.navigation.floor, self._picture.viewport
        self._followed = view.follow
        view.follow = True
        mode = DriveMode(
            name,
            floor,
            self._caps,
            self._passes,
            self.stop,
            lambda: self.end(Message("the map lost the focus")),
        )
        self._controls.enter(mode)
        self._tell_releases(True)
        self._focus()
        # In the place of why the last drive ended.
        self._console.notices.say(
            sanitize(Message("{name} drives while a key is held; this is not an emergency stop", name=name))
        )

    def press(self, key: str) -> None:
        """Take a press of a direction; nothing is kept for a drive that has not begun."""
        self._pressed = self._clock()
        if self.drive is None or self.drive.state.phase is not DrivePhase.READY:
            return
        if key in SIDEWAYS and not self._limits.holonomic:
            self.stop()
            self._console.notices.say(
                sanitize(Message("no sideways: holonomic is false for {name}", name=self._robot.name))
            )
            return
        self._hand = self._hand.pressed(key, self._clock())
        self._steer()

    def release(self, key: str) -> None:
        """Take the release of a direction, where the terminal tells it."""
        if self.drive is None:
            self._leave_mode()
        self._hand = self._hand.released(key)
        self._steer()

    def change_speed(self, step: int) -> None:
        """Drive faster or slower from now on."""
        self._share = faster(self._share, step)
        self._steer()

    def stop(self) -> None:
        """Stop the robot, and go on driving."""
        if self.drive is None:
            self._leave_mode()
        self._hand = Hand()
        self._steer()

    def leave(self) -> None:
        self.end(Message("left by key"))

    def end(self, reason: Message) -> None:
        """Stop and leave for a reason; do nothing if no robot is driven."""
        self._end_drive(reason)
        self._leave_mode()

    def _end_drive(self, reason: Message) -> None:
        mode = self.mode
        if self.drive is None or mode is None:
            return
        drive, self.drive = self.drive, None
        drive.end(reason)
        mode.state = drive.state
        self._journal.end(drive.state.reason, self._clock())
        self._console.notices.note(
            sanitize(
                Message(
                    "{robot} is not driven any more: {reason}", robot=mode.robot, reason=drive.state.reason
                )
            )
        )

    def _leave_mode(self) -> None:
        if self.mode is not None:
            self._picture.viewport.follow = self._followed
            self._controls.leave_mode()
            self._tell_releases(False)

    def look(self, scene: Scene) -> None:
        """Follow the hand and look for reasons to end, with every picture."""
        mode, drive, now = self.mode, self.drive, self._clock()
        if mode is None:
            return
        late, self._looked = now - self._looked > LATEST, now
        if drive is not None:
            ended = drive.state.reason if drive.state.phase is DrivePhase.ENDED else EMPTY
            if reason := self._reason_to_end(mode, scene) or (
                Message("the screen was late") if late else ended
            ):
                self._end_drive(reason)
                self._pressed = now
            else:
                self._steer()
                mode.state = drive.state
                self._journal.sent(drive.state.sent)
        if self.drive is None and now - self._pressed > LET_GO:
            self._leave_mode()

    def _reason_to_end(self, mode: DriveMode, scene: Scene) -> Message:
        if self._console.navigation.robot != mode.robot:
            return Message("another robot")
        if scene.floor != mode.floor:
            return Message("another floor")
        return self._refusal()

    def _steer(self) -> None:
        """Send what the hand asks for, slower before a wall."""
        mode, drive, now = self.mode, self.drive, self._clock()
        if mode is None or drive is None:
            return
        mode.share = self._share
        asked = wanted(self._hand, now, self._share, self._caps)
        state = self._console.store.state
        mode.clearance = self._clearance.of(state, state.robots[mode.robot], asked, now)
        speeds = asked if mode.clearance is None else slowed(asked, mode.clearance)
        if self._steered or speeds != STILL:
            drive.steer(Steering(speeds, self._hand.until))
        self._steered = speeds != STILL
