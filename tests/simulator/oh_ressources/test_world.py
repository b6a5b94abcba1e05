"""The simulated fleet: orders are driven, robots stay on the road, and a seed repeats itself."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.robot import SimRobot
from tests.support.sim_world import Values, call, off_road, order, run_until_idle


def carry(world: World, end: int) -> Values:
    return call(world, "Execute_order_with_cargo", request_id=6, agent="robot_0", end_point=end)


def statuses(robot: SimRobot) -> list[tuple[int, str]]:
    return [(order.id, order.status) for order in robot.orders]


def state(world: World) -> list[object]:
    return [
        (r.pose, r.vertex, r.bound, r.battery, r.cargo, r.paused, r.obstacle, r.silence, statuses(r))
        for r in world.robots.values()
    ]


def test_robots_of_several_worlds_can_be_numbered_on() -> None:
    assert [*World(2, 1, first=5).robots] == ["robot_5", "robot_6"]


def test_a_quiet_robot_does_nothing_on_its_own(world: World, robot: SimRobot) -> None:
    before = robot.pose
    world.step(600.0)
    assert (robot.pose, robot.orders, robot.obstacle, robot.silence) == (before, [], 0.0, 0.0)


def test_orders_are_queued_worked_on_and_gone(world: World, robot: SimRobot) -> None:
    assert order(world, 2, 5) == {"request_id": 5, "status": "ACCEPTED"}
    order(world, 5, 0)
    assert (statuses(robot), robot.current_order_id) == ([(1, "Q"), (2, "Q")], -1)
    world.step(0.1)
    assert (statuses(robot), robot.current_order_id) == ([(1, "W"), (2, "Q")], 1)
    while robot.current_order_id == 1:
        world.step(0.1)
    assert robot.vertex == 5
    assert statuses(robot) == [(2, "W")]
    run_until_idle(world, robot)
    assert (robot.vertex, robot.cargo, robot.last_order_id, robot.current_order_id) == (0, False, 2, -1)


def test_another_floor_is_reached_by_the_elevator(world: World, robot: SimRobot) -> None:
    order(world, 0, 110)
    stood = longest = 0.0
    while robot.floor.name == "floor_0":
        before = robot.pose
        world.step(0.05)
        stood = stood + 0.05 if robot.pose == before else 0.0
        longest = max(longest, stood)
    assert 4.0 < longest < 10.0  # loading takes 3 s
    assert robot.vertex == world.building.floors[1].vertex_of("elevator")
    assert (robot.pose.x, robot.pose.y) == (before.x, before.y)
    run_until_idle(world, robot)
    assert (robot.vertex, robot.floor.name) == (110, "floor_1")


@pytest.mark.parametrize(
    ("start", "end", "missing"), [(0, 77, 77), (77, 0, 77), (0, 9999, 9999), (-1, 0, -1)]
)
def test_an_unknown_vertex_is_refused_in_text(
    world: World, robot: SimRobot, start: int, end: int, missing: int
) -> None:
    assert order(world, start, end) == {"request_id": 5, "status": f"REJECTED: no vertex {missing}"}
    assert (robot.orders, robot.last_order_id) == ([], 0)


def test_an_order_to_where_it_starts_is_accepted_as_on_the_real_bridge(world: World, robot: SimRobot) -> None:
    assert order(world, 0, 0)["status"] == "ACCEPTED"
    run_until_idle(world, robot)
    assert robot.vertex == 0


def test_with_cargo_needs_cargo_and_drives_straight_to_the_end(world: World, robot: SimRobot) -> None:
    assert carry(world, 12)["status"] == "REJECTED: no cargo on board"
    order(world, 2, 5)
    while not robot.cargo:
        world.step(0.1)
    assert call(world, "Cancel_order", robot="robot_0", ind=1) == {"success": True, "status": "cancelled 1"}
    assert robot.cargo
    assert carry(world, 9999)["status"] == "REJECTED: no vertex 9999"
    assert carry(world, 12)["status"] == "ACCEPTED"
    run_until_idle(world, robot)
    assert (robot.vertex, robot.cargo) == (12, False)


@pytest.mark.parametrize("ind", [0, -1])
def test_cancelling_zero_means_all(world: World, robot: SimRobot, ind: int) -> None:
    for end in (1, 2, 3):
        order(world, 0, end)
    assert call(world, "Cancel_order", robot="robot_0", ind=ind)["success"]
    assert robot.orders == []


def test_cancelling_and_clearing(world: World, robot: SimRobot) -> None:
    for end in (1, 2, 3):
        order(world, 0, end)
    assert call(world, "Cancel_order", robot="robot_0", ind=2)["status"] == "cancelled 2"
    assert call(world, "Cancel_order", robot="robot_0", ind=2)["success"] is False
    assert statuses(robot) == [(1, "Q"), (3, "Q")]
    assert call(world, "Clear_orders", robot="robot_0", ind=0) == {"success": True, "status": "cleared 2"}
    order(world, 0, 1)
    assert robot.last_order_id == 4


def test_the_default_fleet_works_from_the_first_second() -> None:
    world = World(3, 2, seed=0)
    world.step(0.1)
    robots = list(world.robots.values())
    assert [robot.current_order_id for robot in robots] == [1, 1, 1]
    assert {robot.floor.name for robot in robots} == {"floor_0", "floor_1"}
    assert sorted(robot.battery for robot in robots)[0] < 35.0 < sorted(robot.battery for robot in robots)[1]


def test_an_hour_of_the_default_fleet_shows_everything() -> None:
    world = World(3, 2, seed=4)
    robots = list(world.robots.values())
    longest, silent, charged, floors = 0.0, set[float](), 0.0, set[tuple[str, str]]()
    while world.time < 3600.0:
        before = [robot.battery for robot in robots]
        world.step(0.5)
        longest = max(longest, *(robot.obstacle for robot in robots))
        charged = max(charged, *(r.battery - b for r, b in zip(robots, before, strict=True)))
        floors |= {(robot.name, robot.floor.name) for robot in robots}
        if any(robot.silence for robot in robots):
            silent.add(world.time)
    assert 2.0 < longest <= 8.05
    assert charged > 0.0
    assert len(floors) > 3
    assert 10 * 1.0 < len(silent) * 0.5 < 22 * 4.0
    assert min(silent) > 30.0
    assert all(robot.last_order_id > 15 for robot in robots)


def test_an_idle_robot_with_a_low_battery_docks_and_charges() -> None:
    world = World(1, 1, seed=1)
    robot = world.robots["robot_0"]
    robot.battery = 20.0
    robot.drop({order.id for order in robot.orders})
    while robot.vertex != robot.floor.vertex_of("charger"):
        world.step(1.0)
        assert world.time < 200.0
        assert robot.orders == []
    world.step(60.0)
    assert robot.battery > 40.0


def test_a_hundred_robots_start_apart() -> None:
    world = World(100, 2, seed=1)
    world.step(10.0)
    spots = {(robot.floor.name, robot.pose.x, robot.pose.y) for robot in world.robots.values()}
    assert len(spots) > 60
    assert all(off_road(world, robot) < 1e-6 for robot in world.robots.values())


commands = st.lists(
    st.tuples(
        st.floats(0.0, 30.0),
        st.sampled_from(["Execute_order", "Cancel_order", "Clear_orders", "Pause", "Resume", "carry"]),
        st.integers(-1, 120),
        st.integers(0, 119),
    ),
    max_size=8,
)


def obey(world: World, verb: str, first: int, second: int) -> None:
    if verb == "Execute_order":
        order(world, first, second)
    elif verb == "carry":
        carry(world, first)
    else:
        call(world, verb, robot="robot_0", ind=first)


@given(seed=st.integers(0, 999), script=commands)
def test_the_same_seed_and_commands_give_the_same_run(
    seed: int, script: list[tuple[float, str, int, int]]
) -> None:
    worlds = World(3, 2, seed), World(3, 2, seed)
    for seconds, verb, first, second in script:
        for world in worlds:
            world.step(seconds)
            obey(world, verb, first, second)
        assert state(worlds[0]) == state(worlds[1])


def test_another_seed_gives_another_run() -> None:
    assert state(World(3, 2, 1)) != state(World(3, 2, 2))


@given(seed=st.integers(0, 999), script=commands)
def test_whatever_it_is_told_it_stays_on_the_road(
    seed: int, script: list[tuple[float, str, int, int]]
) -> None:
    world = World(2, 2, seed)
    last = 0
    for seconds, verb, first, second in script:
        obey(world, verb, first, second)
        for _ in range(math.ceil(seconds)):
            world.step(1.0)
            for robot in world.robots.values():
                assert off_road(world, robot) < 1e-6
                assert 0.0 <= robot.battery <= 100.0
                assert len(robot.orders) == len({order.id for order in robot.orders})
        robot = world.robots["robot_0"]
        assert robot.last_order_id >= last
        last = robot.last_order_id


@given(start=st.integers(0, 19), end=st.integers(100, 119), seed=st.integers(0, 99))
def test_every_order_is_driven_in_the_end(start: int, end: int, seed: int) -> None:
    world = World(1, 2, seed, quiet=True)
    order(world, start, end)
    run_until_idle(world, world.robots["robot_0"])
    assert world.robots["robot_0"].vertex == end
