"""The record of a drive in the audit log."""

from fleet_tui.features.drive.controls import DriveJournal
from fleet_tui.model.set_up.driving import Speeds
from fleet_tui.text.language import Message
from fleet_tui.ui.controllers.files import ConsoleFiles


class Written:
    """An audit log that keeps what it is told."""

    def __init__(self) -> None:
        self.lines: list[tuple[str, str]] = []

    def log_console(self, change: str, words: str = "") -> None:
        self.lines.append((change, words))


def test_a_drive_is_written_with_its_reason_its_seconds_and_its_most_speed() -> None:
    files, written = ConsoleFiles(), Written()
    files.audit = written  # type: ignore[assignment]  # the one method that is used
    journal = DriveJournal(files)
    journal.begin("robot_0", 10.0)
    for speeds in (Speeds(0.1), Speeds(-0.2, 0.0, -0.5), Speeds()):
        journal.sent(speeds)
    journal.end(Message("lag"), 22.0)
    assert written.lines == [
        ("drive begun", "robot_0"),
        ("drive ended", "robot_0: lag, after 12 s, at most 0.20 m/s and 0.50 rad/s"),
    ]


def test_without_an_audit_log_nothing_fails() -> None:
    journal = DriveJournal(ConsoleFiles())
    journal.begin("robot_0", 0.0)
    journal.end(Message("left"), 1.0)
