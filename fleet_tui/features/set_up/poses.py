"""Poses and goals that are chosen on the map."""

from fleet_tui.commands.language.set_up import floor_of, to_pose
from fleet_tui.commands.set_up.checks import driving
from fleet_tui.model.geometry import Pose
from fleet_tui.model.kind import GOAL, POSE, SCAN
from fleet_tui.model.problem import Right
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import Localise, SetPose, heading_text
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message, message_of
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.comparison import ScanComparison
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.map import MapControls
from fleet_tui.ui.view.map.map_picture import MapPicture
from fleet_tui.ui.view.map.modes.place import PlaceMode

SET_POSE = Message("POSE")
GO_TO = Message("GOAL")


class PoseRequests:
    """Opens the mode of the map in which a place is chosen, and sends it after a question."""

    def __init__(
        self, console: Console, controls: MapControls, picture: MapPicture, comparison: ScanComparison
    ) -> None:
        self._store = console.store
        self._dispatch = console.dispatch
        self._navigation = console.navigation
        self._notices = console.notices
        self._ask = console.ask
        self._controls = controls
        self._picture = picture
        self._comparison = comparison

    @property
    def mode(self) -> PlaceMode | None:
        """Return the mode while a place is chosen."""
        mode = self._picture.mode
        return mode if isinstance(mode, PlaceMode) else None

    def pose(self) -> None:
        """Choose a pose for the selected robot."""
        self._start(SET_POSE, POSE)

    def goal(self) -> None:
        """Choose a goal for the selected robot."""
        self._start(GO_TO, GOAL)

    def _start(self, title: Message, ability: str) -> None:
        robot = self._store.state.robots[self._navigation.robot]
        refusal = self._dispatch.set_up_refusal(Right.SETUP if ability == POSE else Right.DISPATCH)
        if refusal or not robot.kind.can(ability):
            self._notices.say(refusal or robot.kind.lack(ability))
            return
        floor, scene = self._floor(robot), self._picture.scene
        if floor != self._navigation.floor:
            self._navigation.find_floor(floor)
            scene = self._picture.scene
        if scene is None or scene.floor != floor:
            self._notices.say(Message("{floor} is not shown yet: press again", floor=sanitize(floor)))
            return
        here = robot.pose.value if robot.pose is not None and robot.floor == floor else None
        start = here or Pose(*self._picture.viewport.middle(scene))
        moves_scan = title == SET_POSE and SCAN in robot.kind.streams
        self._controls.enter(PlaceMode(title, robot.name, floor, start, moves_scan))
        # Before anybody places it: Enter would refuse that.
        moving = driving(self._store.state, robot, Localise(robot.name)) if ability == POSE else ()
        for problem in moving:
            self._notices.say(problem.text)

    def _floor(self, robot: Robot) -> str:
        """Return the floor that a robot is on, else the shown one."""
        try:
            return floor_of(robot)
        except CommandError:
            return self._navigation.floor

    def turn(self, degrees: int) -> None:
        """Turn the heading counter-clockwise."""
        if (mode := self.mode) is not None:
            mode.turn(degrees)
            self._controls.enter(mode)

    def leave(self) -> None:
        """Leave without sending."""
        self._controls.leave_mode()

    def send(self) -> None:
        """Ask, then send."""
        mode = self.mode
        if mode is None:
            return
        if mode.floor != self._navigation.floor:
            self._notices.say(
                Message("the place is on {floor}: go to that floor first", floor=sanitize(mode.floor))
            )
            return
        if mode.title == SET_POSE:
            doubt = self._comparison.doubt(mode.robot, mode.floor, mode.pose)
            self._give(Request((SetPose(mode.robot, mode.floor, mode.pose),), doubt=doubt))
            return
        pose = mode.pose
        if self._goal(mode, pose) is not None:
            question = Message(
                "{robot}: go to {heading_text} on {floor}?",
                robot=mode.robot,
                heading_text=heading_text(pose),
                floor=mode.floor,
            )
            self._ask(lambda: sanitize(question), lambda: self._give_goal(mode, pose))

    def _give_goal(self, mode: PlaceMode, pose: Pose) -> None:
        """Send a goal after the yes: the robot may have changed floors since the question."""
        if (request := self._goal(mode, pose)) is not None:
            self._give(request)

    def _goal(self, mode: PlaceMode, pose: Pose) -> Request | None:
        """Return the request of a goal, None if the robot is not on its floor; say so."""
        robot = self._store.state.robots[mode.robot]
        try:
            if (floor := floor_of(robot)) != mode.floor:
                self._notices.say(
                    sanitize(
                        Message(
                            "not sent: {name} is on {floor}, the goal on {goal_floor}",
                            name=robot.name,
                            floor=floor,
                            goal_floor=mode.floor,
                        )
                    )
                )
                return None
            return Request((to_pose(robot, pose),), alone=True)
        except CommandError as problem:
            self._notices.say(sanitize(message_of(problem)))
            return None

    def _give(self, request: Request) -> None:
        if problem := self._dispatch.give(request, self._sent):
            self._notices.say(problem)

    def _sent(self) -> None:
        mode = self.mode
        if mode is not None and mode.moves_scan:
            self._comparison.begin(mode.robot, mode.floor)
        self.leave()
