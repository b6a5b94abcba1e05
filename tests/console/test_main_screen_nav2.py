"""The console on a simulated Nav2 fleet: what is on the screen, and orders from the keyboard."""

import pytest

from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.simulator.nav2.navigation import TO_POSE
from tests.support.console_pilot import Console, console
from tests.support.nav2_site import Holds, Site, nav2_ready, placed

R0 = "robot_0"
WIDE = (220, 40)


async def order(it: Console, *places: str) -> None:
    """Place an order by the promised keys. On a busy machine the link may be gone for a moment, and a value
    old: then Enter again, or a yes."""
    rest, before = it.app.main.features, len(placed(it.store.state))
    await it.press("o")
    for place in places:
        await it.type(place)
        await it.press("enter")
    while rest.order_form.is_open:
        await it.until(nav2_ready)
        await it.press("enter")
    if rest.confirm.is_open:
        await it.press("y")
    await it.until(lambda state: len(placed(state)) > before)


def of_order(stage: Stage, n: int = 0) -> Holds:
    return lambda state: len(placed(state)) > n and placed(state)[n].stage is stage


async def test_map_graph_and_robots_are_on_the_screen(site: Site) -> None:
    async with console(site.config, WIDE) as it:
        await it.shows("Consumidores", "map")
        await it.shows("robot_1", "fleet")
        assert "floor_0" in it.text
        await it.shows("0 alarms")
        await it.until(lambda state: state.floors["floor_0"].live)
        await it.shows("▄▄▄", "map")
        await it.shows("%", "fleet")


async def test_what_such_robots_lack_is_nowhere(site: Site) -> None:
    async with console(site.config, WIDE) as it:
        await it.shows("robot_1", "fleet")
        assert "cargo" not in it.text.lower() and "obstacle" not in it.text
        await it.press("o")
        await it.shows("From")
        assert "cargo" not in it.text.lower()
        await it.press("escape")
        await it.press("w")
        await it.shows("1. no orders")
        assert "cargo" not in it.text.lower() and "missing" not in it.text


async def test_an_order_from_the_keyboard_drives_with_its_progress_and_ends(site: Site) -> None:
    site.server.speed = 4.0
    async with console(site.config, WIDE) as it:
        await order(it, "Receiving", "Base")
        await it.shows("Receiving -> Base", "queue")
        await it.shows("confirmed (seen in the queue as order ")
        await it.shows("stop 1 of 2", "queue")
        await it.shows(" m left", "fleet")
        await it.press("w")
        await it.shows("robot_0 is driving")
        await it.press("escape")
        site.server.speed = 40.0
        await it.until(of_order(Stage.DONE))
        await it.shows("done", "queue")


async def test_an_order_to_a_place_alone(site: Site) -> None:
    async with console(site.config, WIDE) as it:
        await it.press(":")
        await it.type("order robot_0 Receiving")
        await it.press("enter")
        question = it.app.main.features.confirm
        await it.until(lambda state: state.commands or question.is_open)
        if question.is_open:  # a value of the robot was old at that moment: the machine is busy
            await it.press("y")
        await it.until(of_order(Stage.DONE))
    (request,) = site.navigation().received
    assert request["pose"]["pose"]["position"]["y"] == 7.0


async def test_x_cancels_the_order_under_the_cursor(site: Site) -> None:
    site.server.speed = 1.0
    async with console(site.config, WIDE) as it:
        await order(it, "Consumidores", "Base")
        await it.until(of_order(Stage.CONFIRMED))
        await it.shows("Consumidores -> Base", "queue")
        await it.press("x", "y")
        await it.until(of_order(Stage.CANCELLED))
        await it.shows("cancelled", "queue")


async def test_a_second_order_waits_here_and_the_title_says_whose_queue_it_is(site: Site) -> None:
    site.server.speed = 1.0
    async with console(site.config, WIDE) as it:
        await it.shows("Consumidores", "map")
        await order(it, "Consumidores", "Base")
        await it.until(of_order(Stage.CONFIRMED))
        await order(it, "Base", "Receiving")
        await it.until(of_order(Stage.WAITING, 1))
        await it.shows("waiting here", "queue")
        await it.shows("Queue robot_0 2 orders", "queue")
        assert "from here" not in it.pane("queue"), "some are from elsewhere"
        await it.press("down", "down")
        await it.press("p")
        await it.shows("stopped, goal kept here")
        await it.until(lambda state: not site.navigation().robot.driving)
        site.server.speed = 40.0
        await it.press("r")
        await it.until(of_order(Stage.DONE, 0))
        await it.until(of_order(Stage.DONE, 1))


async def test_a_goal_of_another_client_is_shown_as_such_and_stopped(site: Site) -> None:
    site.server.speed = 1.0
    site.navigation().give(35.0, 20.0)
    async with console(site.config, WIDE) as it:
        await it.shows("(elsewhere)", "queue")
        await it.press("x", "y")
        await it.until(lambda state: not state.robots[R0].orders.open)
        assert not site.navigation().servers[TO_POSE].running


@pytest.mark.parametrize("key", ["P", "f12"])
async def test_all_robots_stop_with_their_goals(site: Site, key: str) -> None:
    site.server.speed = 1.0
    for robot in site.fleet.robots:
        site.navigation(robot).give(35.0, 20.0)
    async with console(site.config, WIDE) as it:
        await it.until(lambda state: all(robot.orders.open for robot in state.robots.values()))
        await it.press(key)
        await it.until(lambda state: not any(robot.orders.open for robot in state.robots.values()))
        assert not any(robot.driving for robot in site.fleet.robots.values())


async def test_why_a_robot_that_recovers_stands(site: Site) -> None:
    async with console(site.config, WIDE) as it:
        await order(it, "Consumidores", "Base")
        await it.until(lambda _: site.navigation().robot.driving)
        site.navigation().robot.block()

        def recovers(state: FleetState) -> bool:
            progress = state.robots[R0].progress
            return progress is not None and bool(progress.value.recoveries)

        await it.until(recovers)
        await it.press("w")
        await it.shows("blocked ")
        await it.shows("recovering")


async def test_why_orders_are_held_and_that_resume_helps(site: Site) -> None:
    site.server.speed = 1.0
    async with console(site.config, WIDE) as it:
        await order(it, "Consumidores", "Base")
        await it.until(of_order(Stage.CONFIRMED))
        await order(it, "Base", "Receiving")
        await it.until(of_order(Stage.WAITING, 1))
        await it.until(lambda _: site.navigation().robot.driving)
        first = placed(it.store.state)[0].order_id
        site.navigation().servers["follow_waypoints"].cancel(bytes(16), 0)
        await it.shows(f"held: order {first}: cancelled elsewhere", "queue")
        await it.press("w")
        await it.shows("1 order waiting here: resume to continue")


async def test_why_and_the_diagnostics_name_missing_odometry(site: Site) -> None:
    async with console(site.config, WIDE) as it:
        await it.until(nav2_ready)
        site.navigation().robot.odometry = False
        await it.until(lambda state: state.is_old(state.robots[R0], "pose"))
        await it.press("w")
        await it.shows("no odometry on /robot_0/odom")
        await it.press("d")
        await it.until(lambda state: "▸○ " in it.text)
        assert any("▸○" in line and "/robot_0/odom" in line for line in it.text.splitlines())
