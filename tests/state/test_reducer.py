"""The picture of the world after each kind of fact."""

import pytest

from fleet_tui.model import events
from fleet_tui.model.desk import events as desk_events
from fleet_tui.model.fleet import CONTACT
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import Edge, RouteGraph, Vertex
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.model.occupancy import grid_from_ros
from fleet_tui.situation.robots import obstacle
from fleet_tui.text.language import Message
from tests.support.alarms import alarms
from tests.support.fleets import (
    F0,
    LINK,
    R0,
    T0,
    WALL,
    battery,
    fleet,
    graph,
    labels,
    link_lost,
    link_up,
    pose,
    queue,
    reduced,
    tick,
)

FRAME = MapFrame(0.05, 2, 1, Pose(-1.0, -2.0))
GRID = grid_from_ros(FRAME, b"\x00\x64")


def test_live_maps_of_many_robots_do_not_add_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("fleet_tui.state.reducer.LIVE_CELLS_KEPT", 4)
    names = ["robot_0", "robot_1", "robot_2"]
    state = reduced(fleet(3, 2), *(events.GridReceived(name, F0, GRID) for name in names[:2]))
    held = [name for name in names if state.robots[name].maps[F0].grid]
    assert held == ["robot_0", "robot_1"]
    state = reduced(state, events.GridReceived("robot_1", "floor_1", GRID))
    kept = {
        (name, floor)
        for name in names
        for floor, robot_map in state.robots[name].maps.items()
        if robot_map.grid
    }
    assert kept == {("robot_1", "floor_1")}


def test_every_value_lands_in_its_place_with_its_time() -> None:
    state = reduced(
        fleet(),
        pose(T0 + 1, 3.0, 4.0),
        battery(T0 + 2, 55.0),
        events.CargoReported(R0, T0 + 3, True),
        events.ObstacleReported(R0, T0 + 4, 2.5),
        queue(T0 + 5, (1, 10, 11, "W"), current=1),
        events.PausedReported(R0, T0 + 6, True),
    )
    robot = state.robots[R0]
    readings = (robot.pose, robot.battery, robot.cargo, robot.obstacle, robot.queue, robot.paused)
    assert [reading and reading.at for reading in readings] == [T0 + n for n in range(1, 7)]
    assert robot.pose is not None and robot.pose.value == Pose(3.0, 4.0)
    assert (robot.battery and robot.battery.value, robot.obstacle and robot.obstacle.value) == (55.0, 2.5)
    assert robot.has_cargo and robot.orders.current is not None and robot.orders.current.id == "1"
    assert robot.last_received == T0 + 6


def test_what_is_latched_is_kept_but_is_no_sign_of_life() -> None:
    """A bridge delivers latched maps again: a dead robot must not look alive."""
    maps = (graph(1), labels({1: "Base"}), events.FrameReceived(R0, F0, FRAME))
    state = reduced(
        fleet(), *maps, events.GridReceived(R0, F0, GRID), events.MessageRejected(R0, Message("bad"))
    )
    robot_map = state.robots[R0].maps[F0]
    assert robot_map.frame == FRAME and robot_map.grid is GRID
    assert robot_map.graph is not None and robot_map.name_of("1") == "Base"
    assert state.robots[R0].last_received is None
    assert not reduced(state, tick(T0 + 0.1)).is_online(state.robots[R0])


def test_bad_data_is_counted_on_its_robot_or_its_link() -> None:
    state = reduced(
        fleet(2),
        events.MessageRejected(R0, Message("pose: x")),
        events.FrameRejected(LINK, "frame of 3 bytes"),
    )
    assert [(robot.faults, robot.last_fault) for robot in state.robots.values()] == [(1, "pose: x"), (0, "")]
    assert (state.links[LINK].faults, state.links[LINK].last_fault) == (1, "frame of 3 bytes")


def test_what_an_unknown_robot_says_changes_nothing() -> None:
    state = fleet()
    assert reduced(state, pose(T0, robot="stranger"), graph(1, robot="stranger")) is state


def test_a_floors_map_file_or_what_is_wrong_with_it() -> None:
    state = reduced(fleet(1, 2), events.FloorMapLoaded(F0, GRID, tied=False))
    assert (state.floors[F0].grid, state.floors[F0].tied, state.floors[F0].frame_id) == (GRID, False, F0)
    state = reduced(state, events.FloorMapLoaded("floor_1", None, Message("map a.png: no image a.png")))
    assert (state.floors["floor_1"].grid, state.floors["floor_1"].problem) == (
        None,
        "map a.png: no image a.png",
    )
    assert list(state.floors) == [F0, "floor_1"]


def test_online_is_a_message_within_the_limit() -> None:
    state = reduced(fleet(), battery(T0))
    assert reduced(state, tick(T0 + 5.0)).is_online(state.robots[R0])
    assert not reduced(state, tick(T0 + 5.01)).is_online(state.robots[R0])


def test_no_robot_is_online_once_its_link_is_lost() -> None:
    state = reduced(fleet(), link_up(T0), battery(T0 + 1), link_lost(T0 + 2, "it closed"), tick(T0 + 2))
    assert not state.is_online(state.robots[R0])
    state = reduced(state, link_up(T0 + 3), tick(T0 + 3))
    assert state.is_online(state.robots[R0])


def test_since_stays_the_moment_of_the_loss_while_it_is_tried_again() -> None:
    state = reduced(fleet(), link_up(T0 + 1), link_lost(T0 + 10, "it closed", T0 + 11))
    for n in range(5):
        trying = events.LinkChanged(LINK, T0 + 11 + n, Phase.CONNECTING)
        state = reduced(state, trying)
        assert (state.links[LINK].since, bool(state.links[LINK].reason)) == (T0 + 10, True)
        state = reduced(state, link_lost(T0 + 11.5 + n, "connection refused", T0 + 13 + n))
        assert (state.links[LINK].since, state.links[LINK].next_try) == (T0 + 10, T0 + 13 + n)
    state = reduced(state, link_up(T0 + 30))
    link = state.links[LINK]
    assert (link.phase, link.since, link.reason, link.next_try) == (Phase.UP, T0 + 30, "", None)
    assert reduced(state, link_up(T0 + 40)).links[LINK].since == T0 + 30


def test_a_link_that_is_heard_and_commands_that_are_dead() -> None:
    state = reduced(fleet(), link_up(T0), events.MessageArrived(LINK, T0 + 3.0))
    assert state.links[LINK].last_received == T0 + 3.0
    state = reduced(
        state, events.CommandPathChanged(LINK, CommandPath.DEAD, Message("no ROS master")), tick(T0 + 4)
    )
    assert alarms(state)[LINK, "commands"].text == "commands dead: no ROS master"
    state = reduced(state, events.CommandPathChanged(LINK, CommandPath.ALIVE), tick(T0 + 5))
    assert alarms(state)[LINK, "commands"].text == "command path restored"


def test_no_link_is_one_alarm_with_its_reason_after_the_delay() -> None:
    state = reduced(fleet(3), link_up(T0), link_lost(T0 + 10), tick(T0 + 11.9))
    assert alarms(state) == {}
    state = reduced(state, tick(T0 + 60))
    assert list(alarms(state)) == [(LINK, "link")]
    assert alarms(state)[LINK, "link"].text == "no link: connection refused"
    state = reduced(state, link_up(T0 + 61), tick(T0 + 61.1))
    assert alarms(state)[LINK, "link"].text == "link restored"


def test_offline_is_an_alarm_only_while_the_link_is_up_and_had_time() -> None:
    state = reduced(fleet(2), link_up(T0), battery(T0), tick(T0 + 5.0))
    assert alarms(state) == {}
    state = reduced(state, tick(T0 + 12.0))
    assert alarms(state)[R0, "offline"].text == "offline 12 s"
    assert alarms(state)["robot_1", "offline"].text == "never seen"
    state = reduced(state, battery(T0 + 13.0), tick(T0 + 13.0))
    assert alarms(state)[R0, "offline"].text == "back online"


def test_a_new_link_gives_the_robots_time_to_speak() -> None:
    state = reduced(fleet(), link_up(T0), battery(T0), link_lost(T0 + 1), tick(T0 + 100), link_up(T0 + 100))
    assert (R0, "offline") not in alarms(reduced(state, tick(T0 + 104.9)))
    assert (R0, "offline") in alarms(reduced(state, tick(T0 + 105.1)))


@pytest.mark.parametrize(("seconds", "alarmed"), [(0.0, False), (30.0, False), (30.1, True), (1e6, True)])
def test_obstacle_above_the_limit(seconds: float, alarmed: bool) -> None:
    state = reduced(fleet(), link_up(T0), events.ObstacleReported(R0, T0, seconds), tick(T0))
    assert ((R0, "obstacle") in alarms(state)) is alarmed
    assert (obstacle(state, state.robots[R0]) is not None) is (seconds > CONTACT)
    free = reduced(state, events.ObstacleReported(R0, T0 + 1, 0.0), tick(T0 + 1))
    assert [alarm.text for alarm in free.alarms] == ["cleared: obstacle"] * alarmed


@pytest.mark.parametrize(
    ("percent", "priority"), [(20.0, None), (19.9, "LOW"), (10.0, "LOW"), (9.9, "MEDIUM"), (0.0, "MEDIUM")]
)
def test_battery_below_the_limit(percent: float, priority: str | None) -> None:
    state = reduced(fleet(), battery(T0, percent), tick(T0))
    found = [alarm.condition.priority.name for alarm in state.alarms]
    assert found == ([priority] if priority else [])


def test_seen_alarms_are_not_counted_as_new() -> None:
    state = reduced(fleet(2), battery(T0, 5.0), battery(T0, 5.0, "robot_1"), tick(T0))
    assert state.unacknowledged == 2
    state = reduced(state, desk_events.AlarmAcknowledged(R0, "battery"))
    assert (state.unacknowledged, len(state.alarms)) == (1, 2)
    assert reduced(state, desk_events.AlarmAcknowledged()).unacknowledged == 0


def test_alarms_carry_wall_time() -> None:
    assert reduced(fleet(), battery(T0, 5.0), tick(T0 + 7)).alarms[0].first_wall == WALL + T0 + 7


def test_robots_that_know_the_same_graph_share_one() -> None:
    def routes(x: float) -> RouteGraph:
        return RouteGraph({"1": Vertex("1", x, 0.0), "2": Vertex("2", 4.0, 0.0)}, (Edge("7", "1", "2"),))

    told_again = events.GraphReceived(R0, F0, routes(2.0))
    state = reduced(
        fleet(3), *(events.GraphReceived(f"robot_{n}", F0, routes(float(n // 2))) for n in range(3))
    )
    first, second, other = (robot.maps[F0].graph for robot in state.robots.values())
    assert first is second and first == routes(0.0)
    assert other is not first and other == routes(1.0)
    changed = reduced(state, told_again)
    assert changed.robots[R0].maps[F0].graph == routes(2.0)
    assert changed.robots["robot_1"].maps[F0].graph is second


def test_a_map_that_all_robots_share_is_their_floors(monkeypatch: pytest.MonkeyPatch) -> None:
    grid = grid_from_ros(MapFrame(1.0, 2, 1), b"\0d")
    state = reduced(fleet(2, 2), events.GridReceived("", F0, grid))
    assert state.floors[F0].live is grid and state.robots[R0].maps[F0].grid is None
    other = grid_from_ros(MapFrame(1.0, 1, 1), b"\0")
    state = reduced(state, events.GridReceived("", "floor_1", other), events.GridReceived("", "attic", grid))
    assert (state.floors[F0].live, state.floors["floor_1"].live) == (grid, other)
    monkeypatch.setattr("fleet_tui.state.reducer.LIVE_CELLS_KEPT", 1)
    state = reduced(state, events.GridReceived("", "floor_1", other))
    assert (state.floors[F0].live, state.floors["floor_1"].live) == (None, other), "too large together"
