"""Reports of navigating robots: their place, what holds them back, how far they are."""

import math

import pytest
from msgspec.structs import replace

from fleet_tui.model.events import Event
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation import Blocked, Progress
from fleet_tui.model.navigation_events import (
    BlockedReported,
    ErrorReported,
    LocalisationReported,
    OdometryReported,
    OriginReported,
    ProgressReported,
    Unmeasured,
)
from fleet_tui.model.robot import Logged, Reading
from fleet_tui.text.language import Message
from tests.support.fleets import F0, R0, T0, reduced, tick
from tests.support.nav2_goals import WAYPOINTS, goal, goals, localised, nav2, odometry, robot, unheard


def origin(at: float, x: float) -> OriginReported:
    """The transform from the map to the odometry."""
    return OriginReported(R0, at, Pose(x, 0.0), "map")


def fused_odometry(at: float, x: float) -> OdometryReported:
    """The odometry of the transforms."""
    return replace(odometry(at, x), is_transform=True)


class TestPlacing:
    """Odometry, placed on the map by the localisation."""

    def place(self, *facts: Event) -> Pose | None:
        pose = robot(reduced(unheard(), *facts)).pose
        return pose.value if pose else None

    def test_without_a_localisation_it_lives_but_nobody_knows_where(self) -> None:
        state = reduced(nav2(), odometry(T0 + 1, 3.0), tick(T0 + 1))
        assert robot(state).pose is None and state.is_online(robot(state))

    def test_it_goes_on_by_its_wheels_from_where_it_was_found(self) -> None:
        turned = math.pi / 2
        facts = odometry(T0 + 1, 5.0), localised(T0 + 1, 10.0, 10.0, turned), odometry(T0 + 2, 7.0)
        found = self.place(*facts)
        assert found is not None
        assert (found.x, found.y, found.yaw) == pytest.approx((10.0, 12.0, turned))

    def test_a_localisation_that_comes_first_waits_for_the_wheels(self) -> None:
        assert self.place(localised(T0, 10.0), odometry(T0 + 1, 5.0)) == Pose(10.0, 0.0)

    def test_drift_is_taken_back(self) -> None:
        facts = odometry(T0, 0.0), localised(T0, 0.0), odometry(T0 + 9, 10.3), localised(T0 + 9, 10.0)
        assert self.place(*facts) == Pose(10.0, 0.0)
        assert self.place(*facts, odometry(T0 + 10, 11.3)) == pytest.approx(Pose(11.0, 0.0))

    def test_transforms_place_it_by_their_own_odometry_until_its_localisation_has_a_topic(self) -> None:
        wheels = odometry(T0, 100.0), origin(T0, 10.0), odometry(T0 + 1, 101.0)
        assert self.place(*wheels) is None  # another odometry: its own transform is yet to come
        fused = *wheels, fused_odometry(T0 + 1, 5.0)
        assert self.place(*fused) == self.place(*fused, odometry(T0 + 2, 102.0)) == Pose(15.0, 0.0)
        localised_too = *fused, localised(T0 + 2, 7.0), odometry(T0 + 2.1, 110.0)
        assert self.place(*localised_too) == Pose(7.0, 0.0)
        assert self.place(*localised_too, origin(T0 + 3, 90.0), odometry(T0 + 3, 111.0)) == Pose(8.0, 0.0)

    def test_feedback_places_it_only_while_nothing_else_does(self) -> None:
        told = LocalisationReported(R0, T0 + 1, Pose(3.0, 0.0), "map", None, None, is_feedback=True)
        assert self.place(told) == Pose(3.0, 0.0)
        assert self.place(localised(T0, 7.0), told) == Pose(7.0, 0.0)
        assert self.place(told, origin(T0 + 2, 10.0), fused_odometry(T0 + 2, 1.0)) == Pose(11.0, 0.0)

    def test_wheels_that_start_anew_take_it_nowhere(self) -> None:
        before = odometry(T0, 0.0), localised(T0, 0.0), odometry(T0 + 9, 20.0)
        anew = localised(T0 + 30, 20.0), odometry(T0 + 30.1, 0.0)
        assert self.place(*before, *anew) == self.place(*before, *reversed(anew)) == Pose(20.0, 0.0)
        assert self.place(*before, *anew, odometry(T0 + 31, 0.5)) == Pose(20.5, 0.0)

    def test_it_is_no_sign_of_life(self) -> None:
        state = reduced(nav2(), localised(T0 + 60, 1.0), tick(T0 + 60))
        assert not state.is_online(robot(state))

    def test_without_odometry_it_is_where_it_was_found(self) -> None:
        state = reduced(unheard(), localised(T0 + 1, 4.0), tick(T0 + 1))
        pose = robot(state).pose
        assert pose is not None and pose.value == Pose(4.0, 0.0) and robot(state).floor == F0


class TestHeldBack:
    def test_the_same_action_goes_on_since_it_began_and_another_one_begins(self) -> None:
        facts = [BlockedReported(R0, T0 + n, "stop", "front") for n in range(3)]
        state = reduced(nav2(), *facts)
        assert robot(state).blocked == Reading(Blocked("stop", "front", T0), T0 + 2)
        state = reduced(state, BlockedReported(R0, T0 + 3, "slowdown", "side"))
        assert robot(state).blocked == Reading(Blocked("slowdown", "side", T0 + 3), T0 + 3)


class TestProgress:
    def test_a_stop_is_kept_beside_the_distance_on_its_leg(self) -> None:
        tour = replace(goal("t"), is_leg=False)
        state = reduced(nav2(), goals(T0, tour, action=WAYPOINTS), goals(T0, goal("l")))
        for progress in (Progress("l", metres=4.0), Progress("t", stop=2), Progress("l", metres=3.0)):
            state = reduced(state, ProgressReported(R0, T0, progress))
        found = robot(state).progress
        assert found is not None and found.value == Progress("t", metres=3.0, stop=2)

    def test_another_goals_progress_is_its_own(self) -> None:
        first, second = Progress("a", metres=4.0, stop=1), Progress("b", metres=9.0)
        state = reduced(nav2(), *(ProgressReported(R0, T0, one) for one in (first, second)))
        found = robot(state).progress
        assert found is not None and found.value == second


def test_what_is_not_measured_is_listed_once_and_is_a_sign_of_life() -> None:
    state = reduced(unheard(), *(Unmeasured(R0, T0 + n, value) for n, value in enumerate("bcb")))
    assert (robot(state).unmeasured, robot(state).last_received) == (("b", "c"), T0 + 2)


def test_an_error_is_as_old_as_its_stamp_and_no_sign_of_life() -> None:
    drives = reduced(nav2(), odometry(T0, 1.0))
    state = reduced(drives, ErrorReported(R0, T0 + 60, "old", stamp=T0 - 10))
    found, last = robot(state).logged, robot(state).last_received
    assert found == (Logged(Message("old"), T0 - 10),) and last == T0
    state = reduced(state, ErrorReported(R0, T0 + 61, "part: broken", is_diagnosed=True))
    assert robot(state).diagnosed == Reading("part: broken", T0 + 61)
    assert robot(state).logged == found
