"""Robots in trouble: with an alarm that still counts, wherever they are."""

import pytest
from msgspec.structs import replace

from fleet_tui.model.commands import CancelOrder, Stage
from fleet_tui.model.desk.events import AlarmAcknowledged, AlarmShelved
from fleet_tui.model.events import Event, PausedReported
from fleet_tui.model.fleet import MANY, FleetState, with_robot
from fleet_tui.model.order import Order
from fleet_tui.model.order_life import GoneOrder
from fleet_tui.situation.alarms.trouble import (
    LONG_STILL,
    acknowledged,
    by_urgency,
    in_trouble,
    may_need_person,
    next_in_trouble,
    shelved,
    to_look_at,
    trouble_elsewhere,
)
from fleet_tui.text.language import Message
from tests.support.fleets import (
    F0,
    LINK,
    R0,
    T0,
    battery,
    commanded,
    fleet,
    link_lost,
    link_up,
    pose,
    queue,
    reduced,
    tick,
)
from tests.support.vda_fleet import AGV, VehicleSite
from tests.support.vda_messages import state

F1 = F0.replace("0", "1")


def low(*robots: str) -> FleetState:
    """Two robots on two floors; the batteries of some are low."""
    places = (pose(T0), pose(T0, robot="robot_1", frame=F1))
    return reduced(
        fleet(2, 2), link_up(T0 - 9), *places, *(battery(T0, 5.0, robot=name) for name in robots), tick(T0)
    )


def test_a_shelved_alarm_is_no_trouble() -> None:
    state = low(R0, "robot_1")
    assert in_trouble(state) == {R0, "robot_1"}
    after = reduced(state, AlarmShelved(R0, "battery", T0 + 60))
    assert in_trouble(after) == {"robot_1"}


def test_who_is_in_trouble_is_named_where_the_floor_is_not_shown() -> None:
    state = low(R0, "robot_1")
    assert trouble_elsewhere(state, "floor_0") == "! robot_1 on floor_1"
    assert trouble_elsewhere(state, "floor_2") == "! 2 on other floors"
    assert trouble_elsewhere(low(R0), "floor_0") == ""


def test_who_is_to_be_looked_at_is_named_where_the_floor_is_not_shown_after_those_with_alarms() -> None:
    state = reduced(low(), PausedReported("robot_1", T0, True), tick(T0))
    assert trouble_elsewhere(state, "floor_0") == "look at robot_1 on floor_1"
    assert trouble_elsewhere(state, "floor_1") == ""
    alarmed = reduced(state, battery(T0, 5.0), tick(T0 + 1))
    assert trouble_elsewhere(alarmed, "floor_1") == "! robot_0 on floor_0"


def test_the_next_one_in_trouble_is_the_next_row_of_the_alarms() -> None:
    state = low("robot_1", R0)
    assert next_in_trouble(state, R0) == "robot_1" and next_in_trouble(state, "robot_1") == R0
    first = reduced(state, AlarmAcknowledged(R0, "battery"))
    assert next_in_trouble(first, "robot_2") == "robot_1", "who needs a person is first"


def test_without_an_alarm_the_next_one_is_a_robot_that_waits() -> None:
    standing = [pose(T0 + n, robot="robot_1") for n in range(int(LONG_STILL) + 1)]
    state = reduced(
        fleet(2),
        link_up(T0),
        queue(T0, (1, 1, 2, "W"), current=1, robot="robot_1"),
        *standing,
        pose(T0 + LONG_STILL, 5.0),
        queue(T0 + LONG_STILL, (1, 1, 2, "W"), current=1, robot="robot_1"),
        tick(T0 + LONG_STILL),
    )
    assert next_in_trouble(state, R0) == "robot_1"
    assert next_in_trouble(reduced(state, pose(T0 + LONG_STILL, 9.0, robot="robot_1")), R0) == ""


def test_the_marked_alarm_is_the_next_one_until_its_robot_is_selected() -> None:
    state = reduced(
        fleet(4),
        link_up(T0),
        *(battery(T0, 15.0, robot=f"robot_{number}") for number in (0, 1, 2)),
        battery(T0, 5.0, robot="robot_3"),
        tick(T0),
    )
    assert by_urgency(state) == ["robot_3", R0, "robot_1", "robot_2"]
    assert next_in_trouble(state, R0, marked=("robot_2", "battery")) == "robot_2"
    assert next_in_trouble(state, "robot_2", marked=("robot_2", "battery")) == "robot_3"
    assert next_in_trouble(state, R0, marked=(LINK, "link")) == "robot_1"


def test_what_is_acknowledged_waits_until_nobody_needs_a_person() -> None:
    state = reduced(low(R0, "robot_1"), AlarmAcknowledged(R0, "battery"))
    assert next_in_trouble(state, "robot_1") == "robot_1"
    assert next_in_trouble(reduced(state, AlarmAcknowledged()), "robot_1") == R0


def test_trouble_whose_alarm_is_shelved_is_known_until_it_ends() -> None:
    state = reduced(low(R0), AlarmShelved(R0, "battery", T0 + 600), tick(T0))
    assert shelved(state) == {R0} and not in_trouble(state)
    assert shelved(reduced(state, battery(T0 + 1, 90.0), tick(T0 + 1))) == frozenset()
    assert shelved(low(R0)) == frozenset()


def test_a_robot_is_acknowledged_once_all_its_alarms_are() -> None:
    state = low(R0, "robot_1")
    assert acknowledged(state) == frozenset()
    assert acknowledged(reduced(state, AlarmAcknowledged(R0, "battery"))) == {R0}
    assert acknowledged(reduced(state, AlarmAcknowledged())) == {R0, "robot_1"}


def test_the_acknowledged_alarm_of_a_link_counts_for_its_robots() -> None:
    lost = reduced(low(), link_lost(T0 + 1), tick(T0 + 9))
    assert acknowledged(lost) == frozenset()
    assert acknowledged(reduced(lost, AlarmAcknowledged())) == {R0, "robot_1"}


def test_a_vehicle_in_a_mode_without_orders_may_need_a_person() -> None:
    site = VehicleSite()
    site.read("state", state())
    assert not may_need_person(site.state, site.state.robots[AGV])
    assert next_in_trouble(site.state, "") == ""
    site.read("state", state(operatingMode="MANUAL"))
    assert may_need_person(site.state, site.state.robots[AGV])
    assert next_in_trouble(site.state, "") == AGV


def jumping(robot: str = R0, until: float = T0 + 4) -> list[Event]:
    """Poses that jump by 20 m each second up to a time."""
    return [pose(until - 4 + n, 20.0 * (n % 2), robot=robot) for n in range(5)]


def test_a_robot_whose_pose_jumps_may_need_a_person_while_it_does() -> None:
    state = reduced(fleet(2), link_up(T0 - 9), *jumping(), pose(T0 + 4, robot="robot_1"), tick(T0 + 4))
    assert may_need_person(state, state.robots[R0]) and not in_trouble(state)
    assert next_in_trouble(state, "robot_1") == R0
    later = reduced(state, *(pose(T0 + n) for n in range(5, 20)), tick(T0 + 19))
    assert not may_need_person(later, later.robots[R0])


def test_after_the_alarms_come_those_that_may_need_a_person_and_then_the_alarms_again() -> None:
    state = reduced(
        fleet(4),
        link_up(T0 - 9),
        *jumping("robot_1"),
        *jumping("robot_3"),
        pose(T0 + 4),
        battery(T0 + 4, 5.0, robot="robot_2"),
        pose(T0 + 4, robot="robot_2"),
        tick(T0 + 4),
    )
    marked, went = ("robot_2", "battery"), [R0]
    for _ in range(4):
        went.append(next_in_trouble(state, went[-1], marked))
    assert went == [R0, "robot_2", "robot_1", "robot_3", "robot_2"]


def test_a_pause_from_elsewhere_is_unexpected() -> None:
    state = reduced(fleet(2), link_up(T0), pose(T0), pose(T0, robot="robot_1"), tick(T0))
    assert next_in_trouble(state, R0) == ""
    assert next_in_trouble(reduced(state, PausedReported("robot_1", T0, True)), R0) == "robot_1"


@pytest.mark.parametrize(("robots", "at_once"), [(MANY, False), (MANY - 1, True)])
def test_who_of_a_crowd_is_to_be_looked_at_is_told_within_half_a_second(robots: int, at_once: bool) -> None:
    poses = [pose(T0, robot=f"robot_{n}") for n in range(robots)]
    state = reduced(fleet(robots), link_up(T0), *poses, tick(T0))
    assert to_look_at(state) == ()
    odd = reduced(state, PausedReported(R0, T0, True), tick(T0 + 0.1))
    assert to_look_at(odd) == ((R0,) if at_once else ())
    assert to_look_at(reduced(odd, tick(T0 + 0.6))) == (R0,)


def test_an_alarm_changes_at_once_who_of_a_crowd_is_to_be_looked_at() -> None:
    poses = [pose(T0, robot=f"robot_{n}") for n in range(MANY)]
    state = reduced(fleet(MANY), link_up(T0), *poses, PausedReported(R0, T0, True), tick(T0))
    assert to_look_at(state) == (R0,)
    alarmed = reduced(state, battery(T0, 5.0), tick(T0 + 0.1))
    assert alarmed.alarms and to_look_at(alarmed) == ()


def test_an_order_that_was_cancelled_here_is_not_lost() -> None:
    lost = GoneOrder(Order("7", (), None, "", 1), T0 + 3, Stage.LOST, Message("not listed any more"))
    state = low()
    gone = with_robot(state, replace(state.robots["robot_1"], gone=(lost,)))
    assert to_look_at(reduced(gone, tick(T0 + 4))) == ("robot_1",)
    cancelled = commanded(1, CancelOrder("robot_1", "7"), Stage.SENT, Stage.ACCEPTED, at=T0 + 1)
    assert to_look_at(reduced(gone, *cancelled, tick(T0 + 4))) == ()


def test_a_robot_that_has_just_lost_its_order_is_found_until_it_drives_another() -> None:
    state = low()
    assert next_in_trouble(state, R0) == ""
    lost = GoneOrder(Order("7", (), None, "", 1), T0 - 2, Stage.LOST, Message("not listed any more"))
    robot = replace(state.robots["robot_1"], gone=(lost,))
    assert next_in_trouble(with_robot(state, robot), R0) == "robot_1"
    assert (
        next_in_trouble(with_robot(state, replace(robot, gone=(replace(lost, stage=Stage.DONE),))), R0) == ""
    )
