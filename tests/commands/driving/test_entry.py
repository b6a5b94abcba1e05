"""The conditions of a drive, each with the remedy in its words."""

from msgspec.structs import replace

from fleet_tui.commands.driving.entry import drive_refusal
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import DRIVE
from tests.support.fleets import R0, fleet, link_lost, link_up, of_kinds, pose, queue, reduced, tick

T0 = 100.0
PLAIN = fleet(1).robots[R0].kind
DRIVEN = replace(PLAIN, accepts=(*PLAIN.accepts, DRIVE))


def standing() -> FleetState:
    return of_kinds(reduced(fleet(1), link_up(T0), pose(T0), tick(T0 + 0.5)), DRIVEN)


def refused(state: FleetState) -> str:
    return drive_refusal(state, state.robots[R0])


def test_a_robot_that_stands_in_sight_may_be_driven() -> None:
    assert refused(standing()) == ""


def test_a_kind_without_the_topic_names_the_key() -> None:
    state = of_kinds(standing(), replace(PLAIN, unset={DRIVE: "profile.topics.drive"}))
    assert refused(state) == "profile.topics.drive is empty: no driving by hand"


def test_without_a_link_or_a_new_pose_it_is_not_driven() -> None:
    assert refused(reduced(standing(), link_lost(T0 + 1))) == f"no link to {R0}: wait for it"
    assert refused(reduced(standing(), tick(T0 + 1.2))).startswith(f"no pose of {R0} within 1 s")
    assert refused(of_kinds(fleet(1), DRIVEN)).startswith("no link")


def test_a_robot_with_an_order_is_not_driven() -> None:
    for letter in "WQ":
        state = reduced(standing(), queue(T0 + 0.6, (1, 1, 2, letter)))
        assert refused(state) == f"{R0} has 1 order: cancel or clear first"
