"""Reasons of navigating robots to stand still: blocked, lost, recovering, held."""

import pytest
from msgspec.structs import replace

from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import Kind
from fleet_tui.model.navigation import Blocked, Progress
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.situation.causes import HELD_FAST
from fleet_tui.situation.localisation import LOST_ABOVE
from fleet_tui.situation.why.navigation import blocked, held, not_sure_where, recovering, silent
from fleet_tui.situation.why.reason import Strength
from tests.support.fleets import (
    R0,
    T0,
    commanded,
    fleet,
    link_up,
    of_kinds,
    place_order,
    pose,
    queue,
    reduced,
    tick,
)

KEEPS = Kind("keeps", keeps_goals=True)


def known(state: FleetState | None = None, **values: object) -> tuple[FleetState, Robot]:
    state = state or reduced(fleet(), tick(T0))
    return state, replace(state.robots[R0], **values)


@pytest.mark.parametrize(
    ("action", "age", "strength"),
    [
        ("stop", 0.0, Strength.CERTAIN),
        ("stop", 60.0, Strength.POSSIBLE),
        ("slowdown", 0.0, Strength.POSSIBLE),
    ],
)
def test_a_fresh_stop_of_the_collision_monitor_is_certain(
    action: str, age: float, strength: Strength
) -> None:
    report = Reading(Blocked(action, "front", T0 - age - 3), T0 - age)
    found = blocked(*known(blocked=report, last_received=T0))
    assert found is not None and found.strength is strength
    assert (found.since, found.seen) == (T0 - age - 3, T0 - age)
    assert found.evidence == "collision monitor triggered in front: clear the path at the robot"


def test_a_collision_monitor_that_holds_nothing_back_is_no_reason() -> None:
    assert blocked(*known(blocked=Reading(Blocked("", "front", T0), T0))) is None


def test_an_uncertain_localisation_is_given_in_metres() -> None:
    found = not_sure_where(*known(variance=Reading(2.25, T0)))
    assert found is not None and "within 3.0 m" in found.evidence
    assert not_sure_where(*known(variance=Reading(LOST_ABOVE, T0))) is None


def test_recoveries_are_counted_while_an_order_is_driven() -> None:
    driving = reduced(fleet(), queue(T0, (7, 1, 2, "W"), current=7))
    for count, detail in ((1, "1 recovery during order 7"), (3, "3 recoveries during order 7")):
        found = recovering(*known(driving, progress=Reading(Progress("7", recoveries=count), T0)))
        assert found is not None and found.evidence.startswith(detail)
        assert found.remedy == HELD_FAST
    assert recovering(*known(progress=Reading(Progress("7", recoveries=1), T0))) is None
    assert recovering(*known(driving, progress=Reading(Progress("7"), T0))) is None


def test_orders_held_here_are_released_by_resume() -> None:
    state = reduced(of_kinds(fleet(), KEEPS), *commanded(1, place_order(R0, 1), Stage.WAITING))
    found = held(*known(state, held="floor changed"))
    assert found is not None and (found.name, found.keys) == ("held: floor changed", ("resume",))
    assert found.evidence == "1 order waiting here: resume to continue"
    assert held(*known(state)) is None and held(*known(held="floor changed")) is None


def test_navigation_that_ceased_to_report_is_the_reason_with_its_remedy() -> None:
    before = reduced(fleet(), link_up(T0), queue(T0, (7, 1, 2, "W"), current=7), pose(T0 + 40), tick(T0 + 40))
    found = silent(*known(before, progress=Reading(Progress("7"), T0 + 2)))
    assert found is not None and (found.name, found.since) == ("navigation silent", T0 + 2)
    assert "probably crashed" in found.evidence and "Restart the robot's navigation" in found.remedy
    assert silent(*known(before)) is None
