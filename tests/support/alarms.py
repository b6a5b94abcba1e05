"""The alarms of a fleet by their keys, and fleets that can have some."""

from fleet_tui.model.alarm import Alarm
from fleet_tui.model.fleet import FleetState
from tests.support.fleets import (
    R0,
    T0,
    battery,
    fleet,
    link_up,
    reduced,
    tick,
)


def alarms(state: FleetState) -> dict[tuple[str, str], Alarm]:
    return {alarm.key: alarm for alarm in state.alarms}


def alarm(state: FleetState, kind: str, source: str = R0) -> Alarm:
    return alarms(state)[source, kind]


def up(robots: int = 1) -> FleetState:
    """A link that is up for long, and robots that just spoke."""
    spoke = (battery(T0, robot=f"robot_{n}") for n in range(robots))
    return reduced(fleet(robots), link_up(T0 - 100), *spoke, tick(T0))
