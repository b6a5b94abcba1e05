"""The alarms of a fleet by their keys, and fleets that can have some."""

from math import inf

from msgspec.structs import replace

from fleet_tui.model.alarm import Alarm
from fleet_tui.model.fleet import FleetState
from tests.support.fleets import R0, T0, battery, fleet, link_up, of_kinds, reduced, tick


def alarms(state: FleetState) -> dict[tuple[str, str], Alarm]:
    return {alarm.key: alarm for alarm in state.alarms}


def alarm(state: FleetState, kind: str, source: str = R0) -> Alarm:
    return alarms(state)[source, kind]


def up(robots: int = 1) -> FleetState:
    """A link that is up for long, and robots that just spoke, of a kind that need not report a pose."""
    spoke = (battery(T0, robot=f"robot_{n}") for n in range(robots))
    return reduced(without_poses(fleet(robots)), link_up(T0 - 100), *spoke, tick(T0))


def without_poses(state: FleetState) -> FleetState:
    """The same fleet, of a kind that need not report a pose: its absence is no alarm."""
    kinds = (robot.kind for robot in state.robots.values())
    calm = [replace(kind, silence={**kind.silence, "pose": inf}) for kind in kinds]
    return of_kinds(state, *calm)
