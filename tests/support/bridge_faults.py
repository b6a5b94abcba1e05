"""States that tests of faulty bridges wait for."""

from fleet_tui.model.fleet import FleetState
from tests.support.proxied_link import Holds


def raised(kind: str) -> Holds:
    """Tell whether an alarm of this kind is active."""
    return lambda state: any(alarm.condition.kind == kind and alarm.holds for alarm in state.alarms)


def all_online(state: FleetState) -> bool:
    """No robot counts as offline."""
    return all(map(state.is_online, state.robots.values()))
