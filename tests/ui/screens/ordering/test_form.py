"""Commands by key and mouse: what is asked first, and what reaches the robots."""

import msgspec
from textual.widgets import Button, Input

from fleet_tui.config.start import extended
from fleet_tui.model.commands import CancelOrder, PauseRobot, ResumeRobot
from fleet_tui.model.link import Phase
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console
from tests.support.ordering import one_packet, order, place
from tests.support.planted_console import SITE, planted
from tests.support.watched_store import config_of


async def test_an_order_by_keyboard_is_driven_and_leaves_the_queue() -> None:
    async with planted() as it:
        await place(it)
        await it.shows("Base -> Consumidores", "queue")
        await it.shows("confirmed (seen in the queue as order 1)")
        assert it.sent == [order(it, "Base", "Consumidores")]
        # Faster than it would be driven: the world is ours.
        for _ in range(3000):
            it.fleet.world.step(0.1)
        await it.until(lambda state: not state.robots["robot_0"].orders.orders)
        await it.shows("no orders", "queue")


async def test_keys_typed_right_after_o_belong_to_the_form() -> None:
    """`p`, `x`, `P` in a label must not pause or cancel."""
    async with planted() as it:
        one_packet(it, "opxP")
        await it.shows("pxP")
        assert it.sent == []


async def test_a_robot_that_is_selected_in_the_same_packet_gets_the_order() -> None:
    async with planted(2) as it:
        for keys, robot in (("]oBase\rConsumidores\r", "robot_1"), ("[oBase\rConsumidores\r", "robot_0")):
            it.sent.clear()
            one_packet(it, keys)
            await it.until(lambda _: it.sent)
            assert it.sent == [order(it, "Base", "Consumidores", robot=robot)]


async def test_a_whole_order_in_one_packet() -> None:
    async with planted() as it:
        one_packet(it, "oBase\rConsumidores\rp")
        await it.shows("1 key dropped, typed on after Enter")
        await it.until(lambda _: it.sent)
        assert it.sent == [order(it, "Base", "Consumidores")]


async def test_all_robots_orders_and_a_cancel_of_anothers() -> None:
    async with planted(2, 2) as it:
        await it.press("1")
        await place(it)
        await it.shows("Base -> Consumidores", "queue")
        await it.press("[", "*")
        await it.shows("robot_1 #", "queue")
        await it.press("x", "y")
        await it.until(lambda state: not state.robots["robot_1"].orders.orders)
        assert it.sent[1:] == [CancelOrder("robot_1", "1")]


async def test_pause_and_resume_at_once_and_pause_all_from_everywhere() -> None:
    async with planted(2, 2) as it:
        await it.press("p")
        await it.shows("paused", "fleet")
        await it.press("r")
        await it.until(lambda state: not (paused := state.robots["robot_0"].paused) or not paused.value)
        for opened in (["P"], ["o", "f12"], ["question_mark", "f12"], ["colon", "f12"], ["s", "f12"]):
            it.sent.clear()
            await it.press(*opened)
            assert it.sent == [PauseRobot("robot_0"), PauseRobot("robot_1")]
            await it.press("escape", "escape")


async def test_ctrl_c_commands_nothing_and_does_not_leave() -> None:
    async with planted() as it:
        await it.press("ctrl+c")
        await it.shows("Queue robot_0")
        assert it.app.is_running
        assert it.sent == []


async def test_a_refusal_stands_in_the_robots_own_words() -> None:
    service = "/robot_0/Application_layout/Execute_order"
    async with planted() as it:
        it.fleet.server.bridge.services.answers[service] = lambda args: {
            "request_id": 1,
            "status": "REJECTED: [red]door closed",
        }
        await place(it)
        await it.shows("refused (REJECTED: [red]door closed)")


async def test_a_call_never_answered_is_said(server: RosbridgeServer) -> None:
    server.bridge.services.silent_services.add("/robot_0/Application_layout/Pause")
    config = config_of(server.url, 1)
    config = msgspec.structs.replace(
        config, alarms=msgspec.structs.replace(config.alarms, no_answer_after=0.3)
    )
    async with console(config) as it:
        await it.press("p")
        await it.shows("no answer")


async def test_loss_and_return_of_the_server_are_shown_and_heal() -> None:
    first = RosbridgeServer(OhFleet(robots=1, floors=1, seed=1, quiet=True))
    await first.start()
    port = int(first.url.rpartition(":")[2])
    async with console(config_of(first.url, 1)) as it:
        await first.stop()
        await it.shows("no link")
        await it.shows("retry in")
        await it.press("p")
        await it.shows("not sent")
        await it.shows("rosbridge no link", "alarms")
        await it.press("exclamation_mark")
        await it.shows("rosbridge no link", "message")
        await it.press("o")
        await it.shows("no link: an order is not sent now, and not later")
        await it.press("escape")
        second = RosbridgeServer(OhFleet(robots=1, floors=1, seed=1, quiet=True), port=port)
        await second.start()
        await it.until(lambda state: state.links["rosbridge"].phase is Phase.UP)
        await it.hides("retry in")
        received = it.store.state.robots["robot_0"].last_received or 0.0
        await it.until(lambda state: (state.robots["robot_0"].last_received or 0.0) > received)
        assert second.bridge.services.calls == []
        await second.stop()


async def test_a_start_before_the_server() -> None:
    async with console(config_of("ws://127.0.0.1:9", 1), wait=False) as it:
        await it.shows("no link")
        await it.shows("never seen", "fleet")


async def test_read_only_stands_on_the_screen(server: RosbridgeServer) -> None:
    config = config_of(server.url, 1)
    config = msgspec.structs.replace(
        config, operator=msgspec.structs.replace(config.operator, read_only=True)
    )
    async with console(config) as it:
        await it.shows("read-only")
        await it.press("p")
        await it.shows("not sent (this console is read-only)")
        assert server.bridge.services.calls == []


async def test_a_console_that_is_not_armed_sends_nothing_but_pauses_until_it_is() -> None:
    config = config_of(SITE, 1)
    config = msgspec.structs.replace(config, operator=msgspec.structs.replace(config.operator, armed=False))
    async with planted(config=config) as it:
        await it.shows("not armed")
        await it.press("r")
        await it.shows("not sent: this console is not armed")
        assert it.sent == []
        await it.press("p")
        await it.until(lambda _: it.sent == [PauseRobot("robot_0")])
        it.sent.clear()
        await it.press("colon")
        await it.type("arm")
        await it.press("enter")
        await it.hides("not armed")
        await it.press("r")
        await it.until(lambda _: it.sent == [ResumeRobot("robot_0")])


async def test_the_send_button_does_what_enter_does() -> None:
    async with planted() as it:
        await it.press("o")
        # Not by a click at a place: the button moves with the number of matches above it.
        for label in ("Base", "Store"):
            await it.type(label)
            it.app.main.query_one("#send", Button).press()
            await it.settled()
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [order(it, "Base", "Store")]


async def test_a_vertex_chosen_by_key_is_meant_even_where_a_robot_stands() -> None:
    """robot_0 waits at Base."""
    async with planted() as it:
        it.app.main.features.map_controls.next_vertex(1)
        scene = it.app.main.features.map.picture.scene
        assert scene is not None
        labelled = [found for found in scene.vertices if found.label]
        while it.app.main.features.map.picture.options.cursor != next(
            (v.x, v.y) for v in labelled if v.label == "Base"
        ):
            it.app.main.features.map_controls.next_vertex(1)
        await it.press("enter")
        await it.shows("Order")
        assert it.app.main.query_one("#from", Input).value == "Base"


async def test_a_robot_without_a_graph_has_no_places_and_the_form_says_so() -> None:
    async with planted(2) as it:
        it.store.put(extended(it.store.state, config_of(SITE, 3)))
        await it.press("[", "o")
        await it.shows("robot_2 has no route graph yet")
        await it.press("B", "enter")
        await it.shows("robot_2 has no route graph yet")


async def test_the_form_is_beside_the_map_where_the_fleet_is() -> None:
    async with planted(2, 2, (80, 24)) as it:
        view, form = it.app.main.features.map, it.app.main.features.order_form
        await it.shows("Base", "map")
        await it.shows("Recent")
        await it.settled()
        before = view.region
        await it.press("o")
        await it.type("Disp")
        await it.until(lambda _: form.region.area > 0)
        assert view.region == before and not view.region.overlaps(form.region)
        assert form.region.bottom == 22, "message and keys stay"


async def test_the_map_keeps_its_scale_while_the_form_covers_a_part_of_it() -> None:
    async with planted(2, 2, (70, 24)) as it:
        view = it.app.main.features.map

        def scale() -> float:
            assert view.picture.scene is not None
            return view.picture.viewport.camera(view.picture.scene).scale

        await it.shows("Base", "map")
        before, height = scale(), view.size.height
        await it.press("o")
        await it.type("Disp")
        await it.until(lambda _: view.size.height < height)
        await it.shows("Dispatch", "map")
        assert scale() == before
        await it.press("escape")
        await it.until(lambda _: view.size.height == height)
        await it.shows("Base", "map")
        assert scale() == before


async def test_a_name_that_is_no_place_is_told_while_it_is_typed() -> None:
    async with planted() as it:
        await it.press("o")
        await it.type("Consumidorez")
        await it.shows("From: no match for 'Consumidorez', did you mean Consumidores?")
        assert it.app.main.query_one("#send", Button).disabled
        await it.press("backspace")
        await it.hides("no match")
        assert not it.app.main.query_one("#send", Button).disabled
