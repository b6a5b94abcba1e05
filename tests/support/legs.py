"""A robot with move_base, and its goals one after the other."""

from msgspec.structs import replace

from fleet_tui.model.commands import CommandRecord, PlaceOrder, Stage
from fleet_tui.model.events import CommandAdvanced, CommandIssued
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation import Goal
from fleet_tui.model.navigation_events import Alive, GoalsReported, LocalisationReported, OdometryReported
from fleet_tui.model.order import OrderState, at_vertices
from fleet_tui.robots.adapter import Site
from fleet_tui.robots.move_base.adapter import MoveBase
from fleet_tui.robots.profile import Profile
from fleet_tui.text.language import Message
from tests.support.fleets import R0, T0, fleet, graph, link_up, reduced, tick

KIND = MoveBase(Profile(kind="move_base"), Site()).kind


ON, DONE, FAILED, OFF, REFUSED = (
    OrderState.IN_PROCESS,
    OrderState.DONE,
    OrderState.FAILED,
    OrderState.CANCELLED,
    OrderState.REFUSED,
)


A_B = PlaceOrder(R0, at_vertices("1", "2"))


def site() -> FleetState:
    """A robot with move_base that stands still, at T0."""
    state = fleet()
    state = replace(state, robots={R0: replace(state.robots[R0], kind=KIND)})
    poses = [OdometryReported(R0, at, Pose(0.0, 0.0), at) for at in (T0 - 0.1, T0)]
    placed = LocalisationReported(R0, T0, Pose(0.0, 0.0), "map", T0, 0.01)
    return reduced(state, link_up(T0), graph(1, 2, 3), *poses, placed, goals(T0), tick(T0))


def goal(name: str, state: OrderState = ON, said: str = "") -> Goal:
    return Goal(name[-8:], name, "move_base", state, state.value, said=said)


def goals(at: float, *listed: Goal) -> GoalsReported:
    return GoalsReported(R0, at, "move_base", listed)


def sent(state: FleetState, at: float, name: str, command: PlaceOrder = A_B, id_: int = 7) -> FleetState:
    known = any(one.id == id_ for one in state.commands)
    issued = () if known else (CommandIssued(id_, command, at, at),)
    return reduced(state, *issued, CommandAdvanced(id_, Stage.SENT, at, Message(""), name))


def lived(state: FleetState, at: float, *listed: Goal) -> FleetState:
    return reduced(state, goals(at, *listed), Alive(R0, at), tick(at))


def record(state: FleetState, id_: int = 7) -> CommandRecord:
    return next(one for one in state.commands if one.id == id_)
