"""Warnings of the command line before something is lost."""

from fleet_tui.cli.orders.sending import losses, unattended
from fleet_tui.model.geometry import Pose
from fleet_tui.model.request import Request
from fleet_tui.model.set_up.commands import SetPose, Settle
from tests.support.fleets import F0, R0, fleet, place_order


def test_a_pose_needs_a_yes_and_a_refinement_none() -> None:
    state = fleet()
    (found,) = losses(state, Request((SetPose(R0, F0, Pose(1.0, 2.0)),)))
    assert not found.blocks and found.text == "robot_0: set pose (1.00, 2.00) 0° on floor_0?"
    assert list(losses(state, Request((Settle(R0),)))) == []


def test_an_order_of_one_stop_needs_nobody() -> None:
    assert list(unattended(fleet(), Request((place_order(R0, 1, 2),)))) == []
