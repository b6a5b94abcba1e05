"""Alarm rules for vehicles of a master control: what they report about themselves."""

from collections.abc import Callable
from functools import partial

from fleet_tui.model.alarm import Condition
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.situation.alarms.floods import ActiveConditions, was_active
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.vehicles import FINDERS


def _raise(
    find: Callable[[Robot], Fact | None], state: FleetState, robot: Robot, active: ActiveConditions
) -> Condition | None:
    """Raise by a fresh report; an alarm that it began goes on when the vehicle is gone."""
    fact = find(robot)
    if fact is None or fact.kind.alarm is None:
        return None
    was_raised = was_active(active, robot.name, robot.link, fact.kind.name)
    return fact.condition() if was_raised or state.is_fresh(robot, "vehicle") else None


Rule = Callable[[FleetState, Robot, ActiveConditions], Condition | None]
VEHICLE_RULES: tuple[Rule, ...] = tuple(partial(_raise, find) for find in FINDERS)
