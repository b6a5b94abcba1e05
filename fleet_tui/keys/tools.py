"""Keys of the console's tools: diagnostics, logs, programs, routines, files."""

from fleet_tui.actions import Actions
from fleet_tui.keys.key import Key

TOOLS: tuple[Key[Actions], ...] = (
    Key(
        "diagnostics",
        ("d",),
        lambda do: do.view.diagnostics(),
        "Open diagnostics: links, topics, raw messages, logs",
        helps="leaves",
    ),
    Key("record", (), lambda do: do.files.record(), "Record: start or stop a recording"),
    Key(
        "audit",
        ("L",),
        lambda do: do.view.audit(),
        "Open the audit log: all commands and alarms with their outcome",
    ),
    Key(
        "history",
        ("H",),
        lambda do: do.view.history(),
        "History of the shift: events, robots, batteries, alarms, places",
        only_live=True,
    ),
    Key(
        "programs",
        ("J",),
        lambda do: do.view.programs(),
        "Programs of the robot servers: state, start, stop, restart, log",
        only_live=True,
    ),
    Key(
        "routines",
        ("B",),
        lambda do: do.view.routines(),
        "Routines: list, start, pause, resume, stop, progress",
        only_live=True,
    ),
    Key("desk", (), lambda do: do.view.desk(), "Desk: who is there, claims, closed edges", only_live=True),
    Key(
        "facilities",
        ("K",),
        lambda do: do.view.facilities(),
        "Facilities: lifts, doors, dispensers, closed lanes",
    ),
    Key(
        "bundle",
        ("b",),
        lambda do: do.files.bundle(),
        "Write an incident bundle: recording, log and doctor report",
    ),
    Key("save", (), lambda do: do.files.save(), "Save: write the configuration of this console to a file"),
)
