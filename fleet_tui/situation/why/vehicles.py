"""Reasons to stand still of vehicles of a master control: stopped, faulty, or waiting for it."""

from collections.abc import Callable
from functools import partial

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.reported_motion import action_text, running_action
from fleet_tui.situation.vehicles import FINDERS, REPORTED
from fleet_tui.situation.why.reason import Reason, Rule, Strength, reason_of


def _told(find: Callable[[Robot], Fact | None], state: FleetState, robot: Robot) -> Reason | None:
    fact = find(robot) if state.is_fresh(robot, "vehicle") else None
    if fact is None:
        return None
    return reason_of(fact, Strength.CERTAIN if fact.is_certain else Strength.POSSIBLE)


def acts(state: FleetState, robot: Robot) -> Reason | None:
    """Report the action of its order that it carries out where it stands."""
    action = running_action(state, robot)
    if action is None or robot.vehicle is None:
        return None
    text = action_text(state, action)
    return Reason(text, REPORTED, since=action.since, seen=robot.vehicle.at)


VEHICLE_REASONS: tuple[Rule, ...] = (*(partial(_told, find) for find in FINDERS), acts)
