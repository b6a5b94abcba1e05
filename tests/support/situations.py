"""A simulated robot with an order and a fault, and the reasons that are found for what it does."""

import math

from fleet_tui.model.commands import Command
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.robot import SimOrder
from fleet_tui.situation.why.reason import Reason
from fleet_tui.situation.why.why import reasons
from tests.support.fleets import R0, place_order
from tests.support.planted_fleet import Planted

BASE, CONSUMIDORES = 0, 19


AWAY = place_order(R0, CONSUMIDORES, BASE)
"""robot_0 waits at Base: this one it has to drive for."""


def driving(
    faults: str = "", command: Command = AWAY, then: str = "", quiet: bool = True, tells_pause: bool = True
) -> Planted:
    """Three seconds into an order, and what happens then."""
    planted = Planted(faults, quiet=quiet, tells_pause=tells_pause).run(1).command(command).run(3)
    planted.plant(then)
    return planted


def flat(planted: Planted, percent: float) -> Planted:
    planted.world.robots[R0].battery = percent
    return planted


def behind_another(percent: float = 80.0) -> Planted:
    """robot_1 stands paused on the edge that robot_0 has to take: the site's traffic control holds it."""
    planted = flat(Planted("paused:robot_1").run(1), percent)
    one, other = planted.world.robots[R0], planted.world.robots["robot_1"]
    planted.command(AWAY).run(4)
    ahead = math.copysign(2.5, math.cos(one.pose.yaw)), math.copysign(2.5, math.sin(one.pose.yaw))
    turned_to_x = abs(math.cos(one.pose.yaw)) > 0.7
    other.pose = Pose(
        one.pose.x + (ahead[0] if turned_to_x else 0.0), one.pose.y + (0.0 if turned_to_x else ahead[1])
    )
    one.stuck = True
    return planted


def face_to_face() -> Planted:
    """robot_1 stands on the edge that robot_0 has to take, with cargo for where that one comes from."""
    planted = behind_another()
    other = planted.world.robots["robot_1"]
    other.paused, other.stuck = False, True
    other.cargo, other.orders = True, [SimOrder(9, CONSUMIDORES, BASE, status="W")]
    return planted


def first(planted: Planted) -> Reason:
    return reasons(planted.state, planted.robot)[0]


def names(state: FleetState) -> list[str]:
    return [reason.name for reason in reasons(state, state.robots[R0])]
