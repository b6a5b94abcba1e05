"""The laser scan and the planned path of the selected robot, watched while they are shown."""

from collections.abc import Callable
from dataclasses import replace

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import PATH, SCAN
from fleet_tui.model.set_up.streams import Beams, PlannedPath, Points
from fleet_tui.situation.pose_checks.match import Match
from fleet_tui.state.store import Store
from fleet_tui.text.language import EMPTY, Message, translate
from fleet_tui.text.units import percent
from fleet_tui.ui.backend import Backend
from fleet_tui.ui.controllers.comparison import ScanComparison
from fleet_tui.ui.controllers.navigation import Navigation
from fleet_tui.ui.controllers.notices import Notices
from fleet_tui.ui.view.map.map_picture import MapPicture
from fleet_tui.ui.view.map.modes.place import PlaceMode
from fleet_tui.ui.view.map.scene import Scene
from fleet_tui.ui.view.set_up.scan_match import is_old, newest_beams, scan_match, scan_pose

PATH_GONE = 10.0
"""Seconds after which a path is not drawn any more."""


class ShownStreams:
    """Watches the streams that are shown, of the robot that is selected, and no others: a scan costs the
    bridge some kilobytes each time. While `explains`, also its scan: that this does not fit is a reason."""

    def __init__(
        self, store: Store, backend: Backend, navigation: Navigation, notices: Notices, picture: MapPicture
    ) -> None:
        self._store = store
        self._backend = backend
        self._navigation = navigation
        self._notices = notices
        self._picture = picture
        self.explains: Callable[[], bool] = lambda: False
        self._shown = set[str]()
        self._watched = set[tuple[str, str]]()
        self._told = ""
        self.comparison = ScanComparison(store, backend, notices)

    def laser(self) -> None:
        """Show or hide the laser scan."""
        self._turn(SCAN, Message("laser scan"))

    def path(self) -> None:
        """Show or hide the planned path."""
        self._turn(PATH, Message("planned path"))

    def _turn(self, key: str, name: Message) -> None:
        kind = self._store.state.robots[self._navigation.robot].kind
        if key in self._shown:
            self._shown.remove(key)
            self._notices.say(Message("{name} hidden", name=translate(name)))
        elif key not in kind.streams:
            self._notices.say(kind.lack(key))
        else:
            self._shown.add(key)
            self._notices.say(
                Message(
                    "{name} of {robot}: waiting for it", name=translate(name), robot=self._navigation.robot
                )
            )

    def on(self, scene: Scene) -> Scene:
        """Return the scene with the shown streams; watch those of the robot that is selected now."""
        state, mode = self._store.state, self._picture.mode
        # While a pose is chosen it is its robot's scan that counts.
        robot = state.robots[mode.robot if isinstance(mode, PlaceMode) else self._navigation.robot]
        placing = {SCAN} if isinstance(mode, PlaceMode) and mode.moves_scan else set()
        drawn = self._shown | placing
        explained = {SCAN} if self.explains() else set()
        wanted = {(robot.name, key) for key in drawn | explained if key in robot.kind.streams}
        compared = {(self.comparison.robot, SCAN)} if self.comparison.robot else set[tuple[str, str]]()
        self._watch(wanted | compared)
        self.comparison.look()
        if not self._watched:
            return scene
        streams = self._backend.streams
        is_placed_here = isinstance(mode, PlaceMode) and bool(placing) and mode.floor == scene.floor
        if robot.floor == scene.floor or is_placed_here:
            beams = newest_beams(state, robot, streams) if SCAN in drawn else None
            if beams is not None:
                self._tell(robot.name, beams)
                at = scan_pose(robot, streams)
                here = robot.pose.value if robot.pose is not None else None
                old = is_old(state, robot, streams) or (at is None and not is_placed_here)
                scene = replace(scene, beams=beams.points, beams_at=at or here, beams_are_old=old)
            scene = replace(scene, path=self._path(state, robot.name))
        if isinstance(mode, PlaceMode):
            mode.note = _text(scan_match(state, robot, mode.floor, streams, mode.pose))
        return scene

    def _path(self, state: FleetState, robot: str) -> Points | None:
        streamed = self._backend.streams.get(robot, PATH)
        if streamed is None or not isinstance(streamed.value, PlannedPath):
            return None
        return streamed.value.points if state.now - streamed.at <= PATH_GONE else None

    def match(self) -> Match | None:
        """Return the match of the selected robot's watched scan with the map, None without one."""
        state, robot = self._store.state, self._store.state.robots[self._navigation.robot]
        if (robot.name, SCAN) not in self._watched or robot.floor is None:
            return None
        return scan_match(state, robot, robot.floor, self._backend.streams)

    def _watch(self, wanted: set[tuple[str, str]]) -> None:
        for robot, key in self._watched - wanted:
            self._backend.unwatch(robot, key)
        for robot, key in wanted - self._watched:
            self._backend.watch(robot, key)
        self._watched = wanted

    def _tell(self, robot: str, beams: Beams) -> None:
        """Say once for each robot where its laser is assumed to be, as soon as that is known."""
        if self._told != robot and not beams.is_sought:
            self._told = robot
            place = (
                EMPTY
                if beams.is_mounted
                else Message(", laser offset unknown: set laser = [x, y, yaw] of the robot")
            )
            self._notices.note(
                Message(
                    "laser scan of {robot}: {points} of {sent} beams{place}",
                    robot=robot,
                    points=len(beams.points),
                    sent=beams.sent,
                    place=place,
                )
            )


def _text(match: Match | None) -> Message:
    return (
        Message("no scan to compare")
        if match is None
        else Message("{percent} fit, {median} m", percent=percent(match.share), median=f"{match.median:.2f}")
    )
