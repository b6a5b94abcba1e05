"""Reads the contents of a page of the history; in a thread."""

import sqlite3
from collections.abc import Callable, Mapping
from pathlib import Path

from msgspec.structs import replace

from fleet_tui.history.database import is_empty, opened_to_read
from fleet_tui.history.reading import History
from fleet_tui.history.totals import Totals
from fleet_tui.model.history.totals import ChargeTotal
from fleet_tui.model.order import natural
from fleet_tui.rules.battery.forecast import WINDOW, BatteryForecast, forecast
from fleet_tui.rules.battery.history import BatterySample
from fleet_tui.rules.history.division import Division
from fleet_tui.rules.history.timeline import main_activities
from fleet_tui.view.history.events import past_events
from fleet_tui.view.history.shift import ShownShift

MOST = 2000
"""Events of each kind at most, the newest."""


def read_page(path: Path, name: str, time: Division, battery_low: float) -> ShownShift:
    """Return what the page of this name shows of a time; `battery_low` is the limit in per cent."""
    shown = ShownShift(time)
    try:
        with opened_to_read(path) as database:
            if is_empty(database):
                return replace(shown, problem="nothing is written yet")
            history = History(database, MOST)
            shown = replace(shown, begun=history.begun())
            return PAGES[name](history, Totals(database), shown, battery_low)
    except sqlite3.Error as problem:
        return replace(shown, problem=f"the history can't be read: {problem}")


def _events(history: History, _totals: Totals, shown: ShownShift, _low: float) -> ShownShift:
    time = shown.time.since, shown.time.until
    events = past_events(
        history.orders(*time),
        history.alarms(*time),
        history.commands(*time),
        history.links(*time),
        history.notes(*time),
    )
    return replace(shown, events=events)


def _robots(_history: History, totals: Totals, shown: ShownShift, _low: float) -> ShownShift:
    activities = totals.activities(shown.time)
    names = sorted({one.robot for one in activities}, key=natural)
    return replace(shown, timeline=main_activities(names, shown.time, activities))


def _batteries(history: History, totals: Totals, shown: ShownShift, low: float) -> ShownShift:
    import fleet_tui.view.robot.chart  # noqa: F401  # takes a tenth of a second

    charges: dict[str, list[ChargeTotal]] = {}
    for one in totals.charges(shown.time):
        charges.setdefault(one.robot, []).append(one)
    found = {name: charges[name] for name in sorted(charges, key=natural)}
    return replace(shown, charges=found, forecasts=_forecasts(history, found, shown.time.until, low))


def _forecasts(
    history: History, robots: Mapping[str, object], until: float, low: float
) -> Mapping[str, BatteryForecast]:
    found = {}
    for robot in robots:
        charges = history.charges(robot, until - WINDOW, until)
        guess = forecast([BatterySample(one.at, one.percent, True) for one in charges], low, until)
        if guess is not None:
            found[robot] = guess
    return found


def _alarms(history: History, _totals: Totals, shown: ShownShift, _low: float) -> ShownShift:
    return replace(shown, alarms=history.alarms(shown.time.since, shown.time.until))


def _places(_history: History, totals: Totals, shown: ShownShift, _low: float) -> ShownShift:
    return replace(shown, places=totals.blocked(shown.time.since, shown.time.until))


PAGES: Mapping[str, Callable[[History, Totals, ShownShift, float], ShownShift]] = {
    "Events": _events,
    "Robots": _robots,
    "Batteries": _batteries,
    "Alarms": _alarms,
    "Places": _places,
}
