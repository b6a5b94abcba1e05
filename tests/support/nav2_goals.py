"""A robot with Nav2 without a wire: its goals, its odometry and its localisation."""

from msgspec.structs import replace

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation import Goal
from fleet_tui.model.navigation_events import GoalsReported, LocalisationReported, OdometryReported
from fleet_tui.model.order import OrderState
from fleet_tui.model.robot import Robot
from fleet_tui.robots.adapter import Site
from fleet_tui.robots.nav2.adapter import Nav2
from fleet_tui.robots.profile import Profile
from fleet_tui.text.language import Message
from tests.support.fleets import R0, T0, fleet, graph, link_up, reduced, tick

NAV2 = Nav2(Profile(kind="nav2"), Site()).kind
TO_POSE, WAYPOINTS = "navigate_to_pose", "follow_waypoints"
ON, DONE, FAILED, OFF = (OrderState.IN_PROCESS, OrderState.DONE, OrderState.FAILED, OrderState.CANCELLED)


def unheard() -> FleetState:
    """A robot with Nav2 of which nothing has come."""
    state = fleet()
    return reduced(replace(state, robots={R0: replace(state.robots[R0], kind=NAV2)}), link_up(T0))


def nav2() -> FleetState:
    """A robot with Nav2 in the middle of its life, at T0."""
    return reduced(unheard(), graph(1, 2, 3), odometry(T0), tick(T0))


def odometry(at: float, x: float = 0.0, y: float = 0.0, yaw: float = 0.0) -> OdometryReported:
    return OdometryReported(R0, at, Pose(x, y, yaw), at)


def localised(at: float, x: float, y: float = 0.0, yaw: float = 0.0) -> LocalisationReported:
    return LocalisationReported(R0, at, Pose(x, y, yaw), "map", at, 0.01)


def goal(id_: str, state: OrderState | None = ON, stamp: float | None = None) -> Goal:
    return Goal(id_, f"uuid of {id_}", "", state, state.value if state else "?", stamp)


def goals(at: float, *listed: Goal, action: str = TO_POSE, fault: str = "") -> GoalsReported:
    return GoalsReported(
        R0,
        at,
        action,
        tuple(replace(one, action=action, leads=action == WAYPOINTS) for one in listed),
        Message(fault),
    )


def robot(state: FleetState) -> Robot:
    return state.robots[R0]
