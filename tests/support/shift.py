"""The history of a shift, written as a console would."""

import time
from contextlib import closing
from pathlib import Path

from fleet_tui.config.load import load
from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.history.facts import Activity, Charge, LinkChange, Note, OrderChange, Span
from fleet_tui.records.history.database import history_path, open_to_write, transaction
from fleet_tui.records.history.observing import Fact
from fleet_tui.records.history.tables import write
from tests.support.records import ANA

HOSTILE = "<script>document.title='run'</script>\x1b[2J&\"'"


def shift(began: float, robot: str = "robot_0") -> list[Fact | Note | AuditRecord]:
    """Half an hour: an order driven, one lost, an alarm, a command, a link, a note."""
    alarm = {"kind": "alarm", "what": "stuck", "robot": robot, "priority": "high", "words": "stuck for 60 s"}
    command = {"kind": "command", "what": "pause", "robot": robot, "id": 7}
    return [
        LinkChange("rosbridge", began, True),
        OrderChange(robot, "1", "Base -> Store", began + 10, "queued", "floor_0"),
        OrderChange(robot, "1", "Base -> Store", began + 20, "begun", "floor_0"),
        OrderChange(robot, "1", "Base -> Store", began + 80, "done", "floor_0"),
        OrderChange(robot, "2", "Store -> Base", began + 90, "queued", "floor_0"),
        OrderChange(robot, "2", "Store -> Base", began + 95, "begun", "floor_0"),
        OrderChange(robot, "2", "Store -> Base", began + 400, "lost", "floor_0", "left the queue"),
        Span(robot, Activity.DRIVING, began + 20, began + 80, "floor_0", 1.0, 2.0),
        Span(robot, Activity.BLOCKED, began + 80, began + 380, "floor_0", 3.0, 4.0),
        Span(robot, Activity.IDLE, began + 380, began + 1800, "floor_0", 3.0, 4.0),
        Charge(robot, began, 80.0),
        Charge(robot, began + 1800, 60.0),
        ANA.record(began + 140, change="raised", **alarm),
        ANA.record(began + 200, change="acknowledged", **alarm),
        ANA.record(began + 380, change="returned, cleared", **alarm),
        ANA.record(began + 150, change="confirmed", **command),
        LinkChange("rosbridge", began + 1000, False, "connection refused"),
        LinkChange("rosbridge", began + 1060, True),
        Note(began + 1200, "ana", HOSTILE),
    ]


def written(folder: Path, facts: list[Fact | Note | AuditRecord]) -> Path:
    """Write facts into the history of the configuration in a folder, as XDG_STATE_HOME; return its file."""
    path = history_path(folder / "fleet-tui", load(folder / "config.toml"))
    database, _ = open_to_write(path)
    with closing(database), transaction(database):
        for fact in facts:
            write(database, fact, "run1", "ana")
    return path


def an_hour_ago() -> float:
    """The beginning of a shift that is over."""
    return time.time() - 3600.0
