"""Fleets of Open-RMF from the keyboard: orders to a robot and to any, followed, interrupted, resumed,
cancelled."""

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import at_vertices
from fleet_tui.simulator.kinds import play
from tests.support.console_pilot import console
from tests.support.rmf_site import FIRST, hospital, rmf_ready


def has_order(state: FleetState) -> bool:
    return bool(state.robots[FIRST].orders.open)


def is_driven(state: FleetState) -> bool:
    current = state.robots[FIRST].orders.current
    return current is not None and current.stops != ()


def is_held(state: FleetState) -> bool:
    return state.is_paused(state.robots[FIRST])


async def test_an_order_is_given_interrupted_resumed_and_cancelled_by_keys() -> None:
    async with hospital(robots=1, floors=3, speed=1.0) as site, console(site.config) as it:
        await it.until(rmf_ready)
        await it.press("o")
        await it.type("Kitchen")
        await it.press("enter")
        await it.type("Store")
        await it.press("enter")
        state = await it.until(is_driven)
        assert state.robots[FIRST].orders.open[0].stops == at_vertices("Kitchen", "Store")
        await it.shows("Kitchen -> Store")
        await it.press("p")
        await it.until(is_held)
        await it.shows("paused")
        await it.press("r")
        await it.until(lambda state: not is_held(state))
        await it.press("X", "y")
        await it.until(lambda state: not has_order(state))
    kinds = [str(one["type"]).removesuffix("_task_request") for one in site.sent()]
    assert kinds == ["robot", "interrupt", "resume", "cancel"]


async def test_an_order_to_any_robot_is_typed_and_confirmed() -> None:
    async with hospital(robots=2, speed=1.0) as site, console(site.config) as it:
        await it.until(rmf_ready)
        await it.press("colon")
        await it.type("anyone Store > Base")
        await it.shows("any robot of the dispatcher: Store -> Base")
        await it.press("enter")
        await it.shows("(any robot)")
        await it.press("y")
        await it.until(lambda state: any(robot.orders.open for robot in state.robots.values()))
    assert [one["type"] for one in site.sent()] == ["dispatch_task_request"]


async def test_an_idle_robot_says_that_it_can_not_be_paused() -> None:
    async with hospital(robots=1, speed=1.0) as site, console(site.config) as it:
        await it.until(rmf_ready)
        await it.press("p")
        await it.shows("an idle robot can't be paused")
    assert not site.sent()


async def test_the_key_for_trouble_goes_on_to_the_alarms_of_lifts_and_doors() -> None:
    async with hospital(robots=1, floors=2, speed=1.0) as site, console(site.config) as it:
        await it.until(rmf_ready)
        play(site.server, [("fire", FIRST), ("door", FIRST)])
        state = await it.until(lambda state: len(state.alarms) >= 2)
        alarms = [one.key for one in state.alarms if one.condition.kind == "facility"]
        listing = it.app.main.alarms.listing
        met = list[object]()
        for _ in range(3):
            await it.press("exclamation_mark")
            assert it.app.main.alarms.has_focus
            met.append(listing.cursor)
        assert sorted(map(str, met[:2])) == sorted(map(str, alarms)) and met[2] == met[0]
        play(site.server, [("issue", FIRST)])
        await it.until(lambda state: any(one.condition.kind == "issue" for one in state.alarms))
        await it.press("exclamation_mark", "exclamation_mark")
        assert not it.app.main.alarms.has_focus and it.app.main.navigation.robot == FIRST
        await it.press("exclamation_mark")
        assert listing.cursor in alarms
