"""Questions before something is lost: only y does it."""

from msgspec.structs import replace

from fleet_tui.config.schema import Alarms
from fleet_tui.model.commands import CancelOrder, ClearOrders, PauseRobot
from fleet_tui.model.events import BatteryReported, QueueReported
from fleet_tui.model.order import OrderQueue
from fleet_tui.situation.battery.charging import has_low_battery
from fleet_tui.ui.screens.confirm import Confirm
from fleet_tui.ui.screens.ordering.form import OrderForm
from tests.support.console_trips import trips
from tests.support.ordering import one_packet, order, place
from tests.support.planted_console import SITE, PlantedConsole, planted
from tests.support.watched_store import config_of


async def test_a_cancel_asks_and_only_y_does_it() -> None:
    async with planted() as it:
        await place(it)
        await it.shows("Base -> Consumidores", "queue")
        for answer in ("n", "escape", "enter", "x", "q"):
            await it.press("x")
            await it.shows("Cancel order 1 of robot_0?")
            await it.press(answer)
            await it.press("escape")
            await it.hides("Cancel order 1")
            assert len(it.sent) == 1, answer
        await it.press("x", "y")
        await it.until(lambda state: not state.robots["robot_0"].orders.orders)
        assert it.sent[-1] == CancelOrder("robot_0", "1")


async def test_a_question_closes_once_there_is_nothing_to_ask() -> None:
    async with planted() as it:
        await place(it)
        await it.shows("Base -> Consumidores", "queue")
        await it.press("x")
        await it.shows("Cancel order 1 of robot_0?")
        it.fleet.world.robots["robot_0"].drop({1})
        await it.hides("Cancel order 1 of robot_0?")
        await it.shows("not sent: ", "message")
        await it.press("y")
        assert len(it.sent) == 1


async def test_cancel_and_clear_by_mouse() -> None:
    async with planted() as it:
        await place(it)
        await it.shows("[Cancel]", "queue")
        await it.shows("[Clear all]", "queue")
        rows = it.pane("queue").splitlines()
        await it.pilot.click("#queue", offset=(rows[1].index("[Cancel]") + 2, 1))
        await it.shows("Cancel order 1 of robot_0?")
        await it.pilot.click("#no")
        await it.hides("Cancel order 1")
        await it.pilot.click("#queue", offset=(rows[0].index("[Clear all]") + 2, 0))
        await it.shows("Clear all 1 order of robot_0?")
        await it.pilot.click("#yes")
        await it.until(lambda state: not state.robots["robot_0"].orders.orders)
        assert it.sent[-1] == ClearOrders("robot_0")


async def test_a_click_beside_a_question_is_no() -> None:
    async with planted() as it:
        await place(it)
        await it.shows("Base -> Consumidores", "queue")
        await it.press("X")
        await it.shows("Clear all 1 order")
        await it.pilot.click("#fleet", offset=(5, 1))
        await it.hides("Clear all 1 order")
        await it.press("y")
        assert len(it.sent) == 1


async def test_a_warning_is_asked_and_only_y_sends() -> None:
    async with planted() as it:
        await it.press("p")
        await it.until(lambda state: (paused := state.robots["robot_0"].paused) and paused.value)
        for answer in ("enter", "escape", "n"):
            await place(it)
            await it.shows("robot_0 is paused: send anyway?")
            assert "Charge first" not in it.text
            await it.press(answer)
            await it.hides("send anyway?")
            await it.shows("To      Consumidores")
            await it.press("enter")
            await it.shows("robot_0 is paused: send anyway?")
            await it.press(answer, "escape")
            assert not it.app.main.query_one(OrderForm).is_open
        assert it.sent == [PauseRobot("robot_0")]
        await place(it)
        await it.shows("robot_0 is paused: send anyway?")
        await it.press("y")
        await it.until(lambda _: len(it.sent) == 2)
        assert not it.app.main.query_one(OrderForm).is_open


async def _asked_about_its_battery(it: PlantedConsole) -> None:
    it.fleet.world.robots["robot_0"].battery = 6.9
    await it.until(lambda state: has_low_battery(state, state.robots["robot_0"]))
    await place(it)
    await it.shows("battery of robot_0: 6 %, for ")
    await it.shows("C  Charge first")


async def test_a_robot_with_a_nearly_flat_battery_is_charged_in_place_of_a_far_order() -> None:
    async with planted() as it:
        await _asked_about_its_battery(it)
        await it.press("n")
        assert it.sent == []
        await it.press("enter", "C")
        await it.until(lambda _: it.sent)
        assert it.sent == [order(it, "Base", "Charger")]
        assert not it.app.main.query_one(OrderForm).is_open


async def test_a_robot_with_a_nearly_flat_battery_drives_a_far_order_after_a_yes() -> None:
    async with planted() as it:
        await _asked_about_its_battery(it)
        await it.press("y")
        await it.until(lambda _: trips(it) == ["Base -> Consumidores"])


async def test_a_charge_is_offered_by_mouse_and_to_no_robot_with_a_full_battery() -> None:
    async with planted() as it:
        await _asked_about_its_battery(it)
        await it.pilot.click("#charge")
        await it.until(lambda state: state.robots["robot_0"].orders.open)
        assert it.sent == [order(it, "Base", "Charger")]
        it.fleet.world.robots["robot_0"].battery = 80.0
        await it.until(lambda state: not has_low_battery(state, state.robots["robot_0"]))
        await it.press("x")
        await it.shows("Cancel order 1")
        await it.hides("Charge first")
        await it.press("C")
        assert len(it.sent) == 1 and it.app.main.query_one(Confirm).is_open


async def test_a_question_says_what_is_true_while_it_waits() -> None:
    # The other robot speaks: over a link that is silent for 2 s nothing is sent.
    config = replace(config_of(SITE, 2), alarms=Alarms(offline_after=600.0, no_answer_after=600.0))
    async with planted(config=config, faults="silent:robot_0") as it:
        one_packet(it, ":robot_0 Base > Store\r")
        await it.shows("robot_0 was never seen: send anyway?")
        it.store.apply(BatteryReported("robot_0", it.store.state.now, 50.0))
        await it.shows("the queue of robot_0 was not received")
        it.store.apply(QueueReported("robot_0", it.store.state.now, OrderQueue(0, "", ())))
        await it.shows("Send?")
        assert it.app.main.query_one(Confirm).is_open
        await it.press("y")
        await it.until(lambda _: trips(it) == ["Base -> Store"])


async def test_to_the_nearest_charger_asks_and_only_y_sends() -> None:
    async with planted() as it:
        await it.press("C")
        await it.shows("Send?")
        await it.press("n")
        await it.hides("Send?")
        assert it.sent == []
        await it.press("C", "y")
        state = await it.until(lambda state: state.robots["robot_0"].orders.orders)
        (order,) = state.robots["robot_0"].orders.orders
        graph = state.robots["robot_0"].maps["floor_0"].graph
        assert graph is not None and order.end is not None
        assert order.end.vertex in {one.id for one in graph.chargers}
