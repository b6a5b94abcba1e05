"""One simulated robot: it drives, turns, carries and stops as it is told."""

import math

from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.robot import SimRobot
from tests.support.sim_world import call, off_road, order, run_until_idle


def test_the_cargo_is_on_board_between_start_and_end(world: World, robot: SimRobot) -> None:
    changes: list[tuple[int, bool]] = []
    order(world, 2, 5)
    while robot.orders:
        had = robot.cargo
        world.step(0.05)
        if robot.cargo != had:
            changes.append((robot.vertex, robot.cargo))
    assert changes == [(2, True), (5, False)]


def test_it_drives_at_its_speed_and_turns_in_place(world: World, robot: SimRobot) -> None:
    order(world, 4, 15)
    for _ in range(2000):
        before = robot.pose
        world.step(0.1)
        moved = math.dist((before.x, before.y), (robot.pose.x, robot.pose.y))
        turned = abs(math.remainder(robot.pose.yaw - before.yaw, math.tau))
        assert moved <= 0.11 + 1e-9
        assert turned <= 0.15 + 1e-9
        if turned > 0.1 and moved > 0.0:
            assert moved < 0.11 - 1e-9


def test_a_cancelled_robot_drives_on_to_the_next_vertex_and_stands(world: World, robot: SimRobot) -> None:
    order(world, 19, 12)
    while robot.bound is None or robot.pose.x == robot.floor.graph.vertices[robot.vertex].x:
        world.step(0.1)
    bound = robot.bound
    call(world, "Clear_orders", robot="robot_0", ind=0)
    world.step(60.0)
    vertex = robot.floor.graph.vertices[robot.vertex]
    assert (vertex.id, vertex.x, vertex.y) == (bound, robot.pose.x, robot.pose.y)


def test_an_order_on_the_way_somewhere_else_is_begun_at_the_next_vertex(
    world: World, robot: SimRobot
) -> None:
    order(world, 19, 12)
    for end in (0, 15, 4, 119, 11):
        world.step(4.3)
        call(world, "Clear_orders", robot="robot_0", ind=0)
        order(world, end, 2)
        for _ in range(60):
            world.step(0.1)
            assert off_road(world, robot) < 1e-6


def test_pause_stops_it_where_it_is_and_resume_goes_on(world: World, robot: SimRobot) -> None:
    order(world, 19, 12)
    world.step(8.0)
    assert call(world, "Pause") == {"success": True, "message": "paused"}
    before = robot.pose
    world.step(30.0)
    assert (robot.pose, robot.paused) == (before, True)
    assert call(world, "Resume") == {"success": True, "message": "running"}
    world.step(1.0)
    assert robot.pose != before
    run_until_idle(world, robot)
