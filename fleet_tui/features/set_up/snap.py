"""The chosen pose put where the newest scan fits the map best, nearby."""

import math
from functools import partial

from fleet_tui.commands.set_up.checks import map_of
from fleet_tui.model.geometry import Pose
from fleet_tui.situation.pose_checks.match import DOUBTFUL, FEWEST, Match
from fleet_tui.situation.pose_checks.nearby import REACH, best_near
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import percent
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.map import MapControls
from fleet_tui.ui.view.map.map_picture import MapPicture
from fleet_tui.ui.view.map.modes.place import PlaceMode
from fleet_tui.ui.view.set_up.scan_match import newest_beams

SNAP = "place_snap"
"""The id of its key."""


class PoseSnap:
    """Searches off the loop, one search at a time from a pose. Nothing is sent."""

    def __init__(self, console: Console, controls: MapControls, picture: MapPicture) -> None:
        self._store = console.store
        self._notices = console.notices
        self._streams = console.backend.streams
        self._controls = controls
        self._picture = picture
        self._in_background = console.in_background
        self._searched: tuple[PlaceMode, Pose] | None = None

    @property
    def idle_keys(self) -> set[str]:
        """Return the ids of keys without a use now: a goal has no scan to fit."""
        mode = self._picture.mode
        return {SNAP} if isinstance(mode, PlaceMode) and not mode.moves_scan else set()

    def snap(self) -> None:
        """Search for the best fit around the chosen pose."""
        mode = self._picture.mode
        if not isinstance(mode, PlaceMode) or self._searched == (mode, mode.pose):
            return
        if not mode.moves_scan:
            self._notices.say(Message("only a pose of a robot with a laser scan can be fitted to the map"))
            return
        state = self._store.state
        robot = state.robots[mode.robot]
        beams, grid = newest_beams(state, robot, self._streams), map_of(state, robot, mode.floor)
        if grid is None:
            self._notices.say(
                Message("no map of {floor} to compare the scan with", floor=sanitize(mode.floor))
            )
        elif beams is None or beams.is_sought or len(beams.points) < FEWEST:
            self._notices.say(Message("no scan to compare: press again when it has come"))
        else:
            self._searched = mode, mode.pose
            self._notices.say(Message("searching for the best fit nearby"))
            work = partial(best_near, grid, beams.points, mode.pose)
            self._in_background(work, partial(self._take, mode, mode.pose))

    def _take(self, mode: PlaceMode, start: Pose, found: tuple[Pose, Match] | None) -> None:
        """Go to the best fit, unless the mode was left or its pose changed meanwhile."""
        if self._searched == (mode, start):
            self._searched = None
        if self._picture.mode is not mode:
            return
        if mode.pose != start:
            self._notices.say(Message("the cursor was moved during the search: press again"))
        elif found is None:
            self._notices.say(Message("no better fit within {metres} m of the cursor", metres=f"{REACH:g}"))
        else:
            mode.put(found[0])
            self._controls.enter(mode)
            self._controls.reveal(mode.cursor)
            self._notices.say(_found(start, *found))


def _found(start: Pose, pose: Pose, matched: Match) -> Message:
    metres = math.dist((start.x, start.y), (pose.x, pose.y))
    degrees = abs(math.degrees(math.remainder(pose.yaw - start.yaw, math.tau)))
    doubt = Message(": doubtful, search again or elsewhere") if matched.share < DOUBTFUL else EMPTY
    return Message(
        "{percent} fit, {metres} m and {degrees} degrees from the cursor{doubt}",
        percent=percent(matched.share),
        metres=f"{metres:.1f}",
        degrees=f"{degrees:.0f}",
        doubt=doubt,
    )
