"""Goals taken, replaced, cancelled, aborted, forgotten. No wire, no clock."""

import math
from collections import Counter
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.move_base.navigation import (
    INVALID,
    NO_CONTROL,
    NO_PLAN,
    PATIENCE,
    REACHED,
    SimMoveBase,
)
from fleet_tui.simulator.ros.actionlib import (
    ABORTED,
    ACTIVE,
    ENDED,
    PENDING,
    PREEMPTED,
    PREEMPTING,
    RECALLING,
    SUCCEEDED,
    TAKEN,
    GoalReport,
)
from tests.support.move_base_navigation import FAR, NEAR, Json, cancelled, finish, goal, results, stand, world

FLAT = {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}


def test_a_goal_is_taken_driven_and_reached() -> None:
    it, navigation = world()
    navigation.receive_goal(goal("a"))
    assert stand(navigation) == {"a": PENDING}
    it.step(0.1)
    assert [one for one in navigation.server.listed() if one.text == TAKEN and one.status == ACTIVE]
    finish(it, navigation)
    assert results(navigation) == [("a", SUCCEEDED, REACHED)]
    assert (navigation.robot.pose.x, navigation.robot.pose.y) == pytest.approx(FAR)


def test_a_goal_that_is_cancelled_before_it_begins_never_drives() -> None:
    it, navigation = world()
    navigation.receive_goal(goal("a"))
    navigation.receive_cancel(cancelled("a"))
    assert stand(navigation) == {"a": RECALLING}
    it.step(0.2)
    assert results(navigation) == [("a", PREEMPTED, "")]
    assert navigation.robot.odom == Pose(0.0, 0.0)


@pytest.mark.parametrize(
    "turn", [FLAT | {"w": 0.0}, FLAT | {"x": 1.0, "w": 0.0}, FLAT | {"z": math.inf}, FLAT | {"w": math.nan}]
)
def test_an_invalid_quaternion_is_aborted(turn: Json) -> None:
    it, navigation = world()
    navigation.receive_goal(goal("a", orientation=turn))
    it.step(0.1)
    assert results(navigation) == [("a", ABORTED, INVALID)] and not navigation.robot.driving


def test_a_quaternion_need_not_have_the_length_1() -> None:
    it, navigation = world()
    navigation.receive_goal(goal("a", orientation=FLAT | {"z": 2.0, "w": 2.0}))
    finish(it, navigation)
    assert results(navigation) == [("a", SUCCEEDED, REACHED)]
    assert navigation.robot.pose.yaw == pytest.approx(math.pi / 2)


def test_a_goal_in_an_unknown_frame_is_tried_for_ever() -> None:
    it, navigation = world()
    navigation.receive_goal(goal("a", frame="/map"))
    it.step(100.0)
    assert stand(navigation) == {"a": ACTIVE} and navigation.robot.odom == Pose(0.0, 0.0)
    assert {pose["header"]["frame_id"] for pose in navigation.begun} == {"/map"}
    numbers = [pose["header"]["seq"] for pose in navigation.begun]
    assert len(numbers) > 1 and numbers == [*range(numbers[0], numbers[-1] + 1)], "it tries again and again"
    navigation.cancel_all()
    it.step(0.1)
    assert results(navigation) == [("a", PREEMPTED, "")]


@pytest.mark.parametrize("spot", [(-99.0, 3.0), (4.0, 3.5), (37.4, 10.0)])
def test_a_goal_without_a_way_is_given_up_after_recoveries(spot: tuple[float, float]) -> None:
    it, navigation = world()
    navigation.receive_goal(goal("a", spot))
    it.step(PATIENCE - 1.0)
    assert stand(navigation) == {"a": ACTIVE}
    finish(it, navigation, 2.0)
    assert results(navigation) == [("a", ABORTED, NO_PLAN)]


def test_who_gets_nowhere_gives_up() -> None:
    it, navigation = world()
    navigation.receive_goal(goal("a"))
    it.step(5.0)
    navigation.robot.block()
    finish(it, navigation, 60.0)
    assert results(navigation) == [("a", ABORTED, NO_CONTROL)]


def test_a_pose_alone_becomes_a_goal_under_the_servers_own_id() -> None:
    it, navigation = world()
    it.step(41.0)
    navigation.give(*NEAR)
    assert list(stand(navigation)) == ["/robot_0/move_base-1-42.0"]
    navigation.give(*FAR)
    assert list(stand(navigation))[1] == "/robot_0/move_base-2-42.0"
    (first, _) = navigation.forwarded
    assert first["goal_id"] == {"stamp": {"secs": 0, "nsecs": 0}, "id": ""}


def test_who_reaches_its_charger_charges() -> None:
    it, navigation = world()
    floor = it.building.floors[0]
    charger = floor.graph.vertices[floor.vertex_of("charger")]
    navigation.give(charger.x, charger.y)
    finish(it, navigation)
    before = navigation.robot.battery
    it.step(5.0)
    assert navigation.robot.docked and navigation.robot.battery > before


def test_a_node_that_restarts_knows_no_goal() -> None:
    it, navigation = world()
    navigation.receive_goal(goal("a"))
    it.step(1.0)
    navigation.server.said.clear()
    navigation.restart()
    assert list(navigation.server.said) == [[]] and not navigation.robot.driving
    navigation.receive_goal(goal("a"))
    finish(it, navigation)
    assert results(navigation) == [("a", SUCCEEDED, REACHED)]


def test_amcl_speaks_after_its_own_distances() -> None:
    _, navigation = world()
    robot = navigation.robot
    at = robot.estimate
    for off, yaw, speaks in ((0.19, 0.5, False), (0.21, 0.0, True), (0.21, 0.53, True)):
        robot.pose = Pose(at.x + off, at.y, at.yaw + yaw)
        assert robot.localise() is speaks


IDS = st.sampled_from(["a", "b", "c", "d", "", "e"])
SPOTS = st.sampled_from([FAR, NEAR, (0.0, 7.0), (17.0, 13.0), (-99.0, 0.0), (4.0, 3.5)])
STAMPS = st.sampled_from([0, 0, 0, 1, 5, 60])
TURNS = st.sampled_from([{}, {}, {"orientation": FLAT | {"w": 0.0}}])
DEEDS = st.lists(
    st.one_of(
        st.tuples(st.just("goal"), IDS, SPOTS, STAMPS, TURNS),
        st.tuples(st.just("cancel"), IDS, STAMPS),
        st.tuples(st.just("wait"), st.floats(0.0, 20.0)),
    ),
    max_size=15,
)


Key = tuple[str, int]
"""Id and stamp: an id that was forgotten may come again."""


class Watcher:
    """Looks at a server after everything that happens to it."""

    def __init__(self, navigation: SimMoveBase) -> None:
        self._navigation = navigation
        self.known, self.ends = set[Key](), Counter[Key]()
        self._newest: dict[Key, int] = {}

    def look(self) -> None:
        server = self._navigation.server
        under_way = [one for one in server.running if one.status in (ACTIVE, PREEMPTING)]
        assert len(under_way) <= 1 and len(server.running) <= 2
        assert not self._navigation.robot.driving or under_way == [server.current]
        self.known.update((goal.id, goal.stamp) for goal in server.running)
        server.said.append(server.listed())  # as again and again
        while server.said:
            said = server.said.popleft()
            if isinstance(said, GoalReport):
                self._end(said)
            else:
                self._list(said)
        assert {(goal.id, goal.stamp) for goal in server.running} <= self._newest.keys()

    def has(self, id_: str) -> bool:
        return any(one[0] == id_ for one in self.known | set(self.ends))

    def _end(self, said: GoalReport) -> None:
        assert said.status in ENDED
        self._newest[said.id, said.stamp] = said.status
        self.ends[said.id, said.stamp] += 1

    def _list(self, said: list[GoalReport]) -> None:
        for one in said:
            before = self._newest.get((one.id, one.stamp))
            # Once a goal has ended it stays as it ended, and the result has told it first.
            assert before == one.status if before in ENDED or one.status in ENDED else True
        self._newest = {(one.id, one.stamp): one.status for one in said}


@given(DEEDS)
def test_whatever_is_asked_one_goal_is_driven_and_each_ends_once(deeds: list[tuple[Any, ...]]) -> None:
    it, navigation = world()
    watcher = Watcher(navigation)
    for deed, *what in deeds:
        if deed == "goal":
            id_, spot, secs, turn = what
            if not id_ or not watcher.has(id_):  # a forgotten id that is given again is another goal
                navigation.receive_goal(goal(id_, spot, secs, **turn))
        elif deed == "cancel":
            navigation.receive_cancel(cancelled(*what))
        else:
            it.step(what[0])
        watcher.look()
    navigation.cancel_all()
    it.step(1.0)
    watcher.look()
    assert not navigation.busy and watcher.known <= set(watcher.ends)
    assert set(watcher.ends.values()) <= {1}
