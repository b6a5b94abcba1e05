"""The record of drives in the audit log: who was driven, for how long, how fast, and why it ended."""

from fleet_tui.controllers.files import ConsoleFiles
from fleet_tui.model.set_up.driving import Speeds
from fleet_tui.text.durations import age


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

    def end(self, reason: str, at: float) -> None:
        """Note the end of the drive."""
        most = f"at most {self._linear:.2f} m/s and {self._angular:.2f} rad/s"
        self._files.log("drive ended", f"{self._robot}: {reason}, after {age(at - self._began)}, {most}")
