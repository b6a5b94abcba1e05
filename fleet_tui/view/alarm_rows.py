"""The alarm pane: what needs a person, and what nobody has seen yet."""

from collections.abc import Callable

from fleet_tui.model.alarm import Alarm, Priority
from fleet_tui.model.fleet import FleetState
from fleet_tui.view.roles import Ink
from fleet_tui.view.table import Row, Table, column
from fleet_tui.view.text import fit, visible


def _row(alarm: Alarm, sources: int, clock: Callable[[float], str]) -> Row:
    if not alarm.active:
        sign, word, ink = "▽", "over", Ink.DIM
    elif alarm.acknowledged:
        sign, word, ink = "△", "seen", Ink.TEXT
    else:
        sign, word = "▲", "new "
        ink = Ink.ALARM if alarm.condition.priority is not Priority.LOW else Ink.WARN
    count = f" x{alarm.count}" if alarm.count > 1 else ""
    return Row(
        alarm.key,
        (
            (f"{sign} {word} ", ink),
            (fit(alarm.condition.source, sources) + " ", Ink.TEXT),
            (visible(alarm.text), ink),
            (f" {clock(alarm.first_wall)}{count}", Ink.DIM),
        ),
    )


def alarm_table(state: FleetState, clock: Callable[[float], str]) -> Table:
    """Every alarm that holds or that nobody has seen. `clock` writes Unix seconds as a local time."""
    sources = column((alarm.condition.source for alarm in state.alarms), 7, 14)
    rows = tuple(_row(alarm, sources, clock) for alarm in state.alarms)
    fresh = state.unacknowledged
    note = (f" {fresh} new", Ink.ALARM) if fresh else ("", Ink.DIM)
    return Table((("Alarms", Ink.TITLE), note), rows, "all clear")
