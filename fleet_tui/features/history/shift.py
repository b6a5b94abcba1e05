"""The contents of a page of the history."""

from collections.abc import Mapping, Sequence

from msgspec import Struct

from fleet_tui.features.history.events import PastEvent
from fleet_tui.model.history.lives import AlarmLife
from fleet_tui.model.history.totals import BlockedPlace, ChargeTotal
from fleet_tui.records.history.division import Division
from fleet_tui.records.history.timeline import Timeline
from fleet_tui.situation.battery.forecast import BatteryForecast
from fleet_tui.text.language import EMPTY, Message


class ShownShift(Struct, frozen=True):
    """The contents of one page; those of the others are empty. `time` is divided into the cells of a picture;
    `begun` is when the history begins, None while it is empty; `problem` is the reason that there is
    nothing."""

    time: Division
    events: Sequence[PastEvent] = ()
    timeline: Timeline = {}
    charges: Mapping[str, Sequence[ChargeTotal]] = {}
    forecasts: Mapping[str, BatteryForecast] = {}
    alarms: Sequence[AlarmLife] = ()
    places: Sequence[BlockedPlace] = ()
    begun: float | None = None
    problem: Message = EMPTY
