"""The contents of a report, as values."""

from collections.abc import Mapping, Sequence

from msgspec import Struct

from fleet_tui.features.history.report.axis import LocalTime
from fleet_tui.features.history.report.heat import FloorHeat
from fleet_tui.model.history.facts import Note
from fleet_tui.model.history.lives import AlarmLife, PastCommand, PastOrder
from fleet_tui.model.history.totals import ChargeTotal
from fleet_tui.records.history.division import Division
from fleet_tui.records.history.shift import AlarmCause, OrderCounts, RobotShift
from fleet_tui.records.history.timeline import Shares, Timeline


class Claim(Struct, frozen=True):
    """A robot that an operator has claimed at the desk, at a console of `host`."""

    robot: str
    operator: str
    host: str


class Handover(Struct, frozen=True):
    """What goes on and is the next shift's: open orders and alarms, claimed robots. `claims_unknown`: why the
    desk told none, empty if it did, or there is none."""

    orders: Sequence[PastOrder]
    alarms: Sequence[AlarmLife]
    claims: Sequence[Claim]
    claims_unknown: str = ""


class ReportContent(Struct, frozen=True):
    """A time of a site in Unix seconds. `begun` is when a robot was first observed, None if that was
    before it, or never; `unwatched` says since when nobody observed it, empty if somebody does; `losses`
    are its orders that were lost, failed or left the queue, `refusals` its commands that failed; `outages`
    has for each link how often it was lost, and the seconds; `timeline` is for a shift, `shares` for days,
    one of them is empty. `battery_low` is the limit in per cent."""

    site: str
    since: float
    until: float
    made_by: str
    begun: float | None
    unwatched: str
    notes: Sequence[Note]
    robots: Sequence[RobotShift]
    routes: Mapping[str, OrderCounts]
    handover: Handover
    causes: Sequence[AlarmCause]
    outages: Mapping[str, tuple[int, float]]
    losses: Sequence[PastOrder]
    refusals: Sequence[PastCommand]
    time: Division
    timeline: Timeline
    shares: Shares
    charges: Mapping[str, Sequence[ChargeTotal]]
    floors: Sequence[FloorHeat]
    battery_low: float
    local: LocalTime
