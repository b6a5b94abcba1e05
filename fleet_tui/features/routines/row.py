"""A routine as it is listed: its file, and its last or present run."""

from collections.abc import Mapping

from msgspec import Struct

from fleet_tui.features.routines.blocks import LanePlan
from fleet_tui.features.routines.lane import Lane
from fleet_tui.text.language import EMPTY, Message


class RoutineRow(Struct, frozen=True):
    """`times`: of its starts, as typed; `plans` by robot; `lanes`: of the last run, empty for none, and
    `at` the Unix second of its last change; `owner`: who leads the robots now, empty for nobody; `problem`:
    the reason that it can't start, as far as the file alone shows it."""

    name: str
    times: tuple[str, ...] = ()
    plans: Mapping[str, LanePlan] = {}
    lanes: tuple[Lane, ...] = ()
    at: float = 0.0
    owner: Message = EMPTY
    problem: Message = EMPTY

    @property
    def is_left(self) -> bool:
        """Tell whether its process ended before it: a person may resume it."""
        return not self.owner and any(not lane.is_over for lane in self.lanes)
