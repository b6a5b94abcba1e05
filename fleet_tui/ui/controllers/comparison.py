"""The scan's word on a pose that was set: how well it fits the map, before and after."""

from fleet_tui.model.commands import CommandRecord
from fleet_tui.model.geometry import Pose
from fleet_tui.model.kind import SCAN
from fleet_tui.model.set_up.commands import SetPose
from fleet_tui.situation.pose_checks.match import DOUBTFUL, FEWEST, Match
from fleet_tui.state.store import Store
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import percent
from fleet_tui.ui.backend import Backend
from fleet_tui.ui.controllers.notices import Notices
from fleet_tui.ui.view.set_up.scan_match import scan_match

GIVEN_UP = 5.0
"""Seconds from the outcome after which no scan is waited for any more."""


class ScanComparison:
    """Compares the scans of one robot around the newest pose that was set."""

    def __init__(self, store: Store, backend: Backend, notices: Notices) -> None:
        self._store = store
        self._backend = backend
        self._notices = notices
        self.robot = ""
        """The robot whose scan is wanted, empty if none is."""
        self._floor = ""
        self._began = 0.0
        self._before: Match | None = None

    def begin(self, robot: str, floor: str) -> None:
        """Remember how the scan fits at the present pose. Called when a pose is sent."""
        state = self._store.state
        self.robot = robot
        self._floor = floor
        self._began = state.now
        self._before = scan_match(state, state.robots[robot], floor, self._backend.streams)

    def doubt(self, robot: str, floor: str, pose: Pose) -> Message:
        """Return what its newest scan has against a pose, empty for nothing or without one."""
        state = self._store.state
        fit = scan_match(state, state.robots[robot], floor, self._backend.streams, pose)
        if fit is None or fit.beams < FEWEST or fit.share >= DOUBTFUL:
            return EMPTY
        return Message("Only {percent} of the scan fits here. Send it anyway?", percent=percent(fit.share))

    def look(self) -> None:
        """Say how it fits once a scan was taken after the outcome."""
        state = self._store.state
        record = self._record() if self.robot else None
        if record is None or not record.is_decided:
            return
        streamed = self._backend.streams.get(self.robot, SCAN)
        if streamed is not None and streamed.taken_at > record.steps[-1].at:
            after = scan_match(state, state.robots[self.robot], self._floor, self._backend.streams)
            if after is not None:
                self._notices.note(
                    Message(
                        "{robot}: {compared}",
                        robot=sanitize(self.robot),
                        compared=_compared(self._before, after),
                    )
                )
                self.robot = ""
        if state.now - record.steps[-1].at > GIVEN_UP:
            self.robot = ""

    def _record(self) -> CommandRecord | None:
        for record in reversed(self._store.state.commands):
            if isinstance(record.command, SetPose) and record.command.robot == self.robot:
                return record if record.issued_at >= self._began else None
        return None


def _compared(before: Match | None, after: Match) -> str:
    text: str = Message("{percent} of the scan fits the map", percent=percent(after.share))
    if before is not None:
        text += Message(", {percent} before", percent=percent(before.share))
    if before is not None and after.share < before.share:
        return Message("worse, look at the scan (u): {text}", text=text)
    return text if after.share >= DOUBTFUL else Message("doubtful, look at the scan (u): {text}", text=text)
