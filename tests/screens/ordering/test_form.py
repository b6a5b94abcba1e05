"""Commands by key and mouse: what is asked first, and what reaches the robots."""

import msgspec
import pytest
from textual.widgets import Button, Input

from fleet_tui.model.link import Phase
from fleet_tui.screens.ordering.form import OrderForm
from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console
from tests.support.ordering import one_packet, place, sent, vertex
from tests.support.watched_store import config_of


async def test_an_order_by_keyboard_is_driven_and_leaves_the_queue(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
        await place(it)
        await it.shows("Base -> Consumidores", "queue")
        await it.shows("confirmed (seen in the queue as order 1)")
        start, end = vertex(it, "Base"), vertex(it, "Consumidores")
        assert sent(server) == [("Execute_order", {"initial_point": start, "end_point": end})]
        # Faster than it would be driven: the world is ours.
        for _ in range(3000):
            server.world.step(0.1)
        await it.until(lambda state: not state.robots["robot_0"].orders.orders)
        await it.shows("no orders", "queue")


async def test_keys_typed_right_after_o_belong_to_the_form(server: RosbridgeServer) -> None:
    """`p`, `x`, `P` in a label must not pause or cancel."""
    async with console(config_of(server.url, 1)) as it:
        one_packet(it, "opxP")
        await it.shows("pxP")
        assert sent(server) == []


async def test_a_robot_that_is_selected_in_the_same_packet_gets_the_order(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2)) as it:
        for keys, robot in (("]oBase\rConsumidores\r", "robot_1"), ("1oBase\rConsumidores\r", "robot_0")):
            server.bridge.services.calls.clear()
            one_packet(it, keys)
            await it.until(lambda _: server.bridge.services.calls)
            assert server.bridge.services.calls[0][0].startswith(f"/{robot}/")


async def test_a_whole_order_in_one_packet(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
        one_packet(it, "oBase\rConsumidores\rp")
        await it.until(lambda _: len(server.bridge.services.calls) == 2)
        start, end = vertex(it, "Base"), vertex(it, "Consumidores")
        assert sent(server) == [("Execute_order", {"initial_point": start, "end_point": end}), ("Pause", {})]


@pytest.mark.parametrize("opener", [":", "?"])
async def test_keys_typed_right_after_the_palette_or_help_belong_to_it(
    server: RosbridgeServer, opener: str
) -> None:
    async with console(config_of(server.url, 1)) as it:
        one_packet(it, opener + "pPoxX")
        await it.shows("pPoxX")
        one_packet(it, "\x1b")
        await it.hides("pPoxX")
        assert sent(server) == []


async def test_what_is_missing_is_named(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
        await it.press("o", "enter")
        await it.shows("From is missing")
        await it.type("zzz")
        await it.press("enter")
        await it.shows("no match for 'zzz'")
        await it.press("escape", "o")
        await it.type("Base")
        await it.press("enter", "enter")
        await it.shows("To is missing")
        await it.type("Base")
        await it.press("enter")
        await it.shows("same place")
        await it.press("escape")
        await it.hides("To is missing")
        assert sent(server) == []


async def test_with_cargo_and_no_orders_there_is_only_a_destination(server: RosbridgeServer) -> None:
    server.world.robots["robot_0"].cargo = True
    async with console(config_of(server.url, 1)) as it:
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        await it.press("o")
        await it.shows("Destination of the cargo")
        assert "From" not in it.text
        await it.type("Base")
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        wanted = {"agent": "robot_0", "end_point": vertex(it, "Base")}
        assert sent(server) == [("Execute_order_with_cargo", wanted)]


async def test_another_robot_in_the_form(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await it.press("o", "shift+tab")
        await it.type("_1")
        await it.press("home", "delete", "delete", "end")
        await it.press("escape", "o", "shift+tab", "end", "backspace", "1", "enter")
        await it.type("Base")
        await it.press("enter")
        await it.type("Cons")
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert server.bridge.services.calls[-1][0].startswith("/robot_1/")


@pytest.mark.parametrize("answer", ["n", "escape", "enter", "x", "q"])
async def test_a_cancel_asks_and_only_y_does_it(server: RosbridgeServer, answer: str) -> None:
    async with console(config_of(server.url, 1)) as it:
        await place(it)
        await it.shows("Base -> Consumidores", "queue")
        await it.press("x")
        await it.shows("Cancel order 1 of robot_0?")
        await it.press(answer)
        await it.press("escape")
        await it.hides("Cancel order 1")
        assert len(server.bridge.services.calls) == 1
        await it.press("x", "y")
        await it.until(lambda state: not state.robots["robot_0"].orders.orders)
        assert sent(server)[-1] == ("Cancel_order", {"robot": "robot_0", "ind": 1})


async def test_cancel_and_clear_by_mouse(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
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
        assert sent(server)[-1] == ("Clear_orders", {"robot": "robot_0", "ind": 0})


async def test_all_robots_orders_and_a_cancel_of_anothers(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await it.press("2")
        await place(it)
        await it.shows("Base -> Consumidores", "queue")
        await it.press("1", "*")
        await it.shows("robot_1 #", "queue")
        await it.press("x", "y")
        await it.until(lambda state: not state.robots["robot_1"].orders.orders)


async def test_pause_and_resume_at_once_and_pause_all_from_everywhere(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await it.press("p")
        await it.shows("paused", "fleet")
        await it.press("r")
        await it.until(lambda state: not (paused := state.robots["robot_0"].paused) or not paused.value)
        for opened in (["P"], ["o", "f12"], ["question_mark", "f12"], ["colon", "f12"], ["s", "f12"]):
            server.bridge.services.calls.clear()
            await it.press(*opened)
            await it.until(lambda _: len(server.bridge.services.calls) == 2)
            assert {name for name, _ in sent(server)} == {"Pause"}
            await it.press("escape", "escape")


async def test_ctrl_c_commands_nothing_and_does_not_leave(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
        await it.press("ctrl+c")
        await it.shows("Queue robot_0")
        assert it.app.is_running
        assert sent(server) == []


async def test_a_refusal_stands_in_the_robots_own_words(server: RosbridgeServer) -> None:
    service = "/robot_0/Application_layout/Execute_order"
    server.bridge.services.answers[service] = lambda args: {
        "request_id": 1,
        "status": "REJECTED: [red]door closed",
    }
    async with console(config_of(server.url, 1)) as it:
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
    first = RosbridgeServer(World(robots=1, floors=1, seed=1, quiet=True))
    await first.start()
    port = int(first.url.rpartition(":")[2])
    async with console(config_of(first.url, 1)) as it:
        await first.stop()
        await it.shows("no link")
        await it.shows("retry in")
        await it.press("p")
        await it.shows("not sent")
        second = RosbridgeServer(World(robots=1, floors=1, seed=1, quiet=True), port=port)
        await second.start()
        await it.until(lambda state: state.links["rosbridge"].phase is Phase.UP)
        await it.hides("retry in")
        heard = it.store.state.robots["robot_0"].heard or 0.0
        await it.until(lambda state: (state.robots["robot_0"].heard or 0.0) > heard)
        assert second.bridge.services.calls == []
        await second.stop()


async def test_a_start_before_the_server(server: RosbridgeServer) -> None:
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
        assert sent(server) == []


async def test_an_order_from_a_vertex_on_the_map(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
        await it.press("n", "n", "enter")
        await it.shows("Order")
        start = it.app.main.query_one("#from", Input).value
        await it.type("Consum")
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        ids = {"initial_point": vertex(it, start), "end_point": vertex(it, "Consumidores")}
        assert sent(server) == [("Execute_order", ids)]


async def test_with_cargo_a_vertex_on_the_map_is_where_it_goes(server: RosbridgeServer) -> None:
    server.world.robots["robot_0"].cargo = True
    async with console(config_of(server.url, 1)) as it:
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        await it.press("n", "n", "enter")
        await it.shows("Destination of the cargo")
        end = it.app.main.query_one("#to", Input).value
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert sent(server)[0][1]["end_point"] == vertex(it, end)


async def test_a_console_that_is_not_armed_sends_nothing_until_it_is(server: RosbridgeServer) -> None:
    config = config_of(server.url, 1)
    config = msgspec.structs.replace(config, operator=msgspec.structs.replace(config.operator, armed=False))
    async with console(config) as it:
        await it.shows("not armed")
        await it.press("p")
        await it.shows("not sent: this console is not armed")
        assert sent(server) == []
        await it.press("colon")
        await it.type("arm")
        await it.press("enter")
        await it.hides("not armed")
        await it.press("p")
        await it.until(lambda _: sent(server) == [("Pause", {})])


async def test_another_robot_in_the_form_means_other_ids(server: RosbridgeServer) -> None:
    """What was chosen for one robot is not sent to another: each has a graph of its own."""
    async with console(config_of(server.url, 2, 2)) as it:
        await it.press("o")
        await it.type("Base")
        await it.press("enter", "shift+tab", "shift+tab", "end", "backspace", "1", "tab", "tab")
        await it.type("Store")
        await it.press("enter")
        await it.shows("From: Enter selects the marked place of this robot")
        assert sent(server) == []


async def test_a_vertex_that_the_robot_does_not_know_opens_no_form(server: RosbridgeServer) -> None:
    config = config_of(server.url, 2, 2)
    first, second = config.robots
    only_below = msgspec.structs.replace(first, floors=["floor_0"])
    async with console(msgspec.structs.replace(config, robots=[only_below, second])) as it:
        await it.press("}", "n", "n", "enter")
        await it.shows("has no vertex")
        assert not it.app.main.query_one(OrderForm).is_open


async def test_the_same_label_on_two_floors_stays_what_was_picked(server: RosbridgeServer) -> None:
    server.world.robots["robot_0"].cargo = True
    async with console(config_of(server.url, 1, 2)) as it:
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        charts = it.store.state.robots["robot_0"].charts
        labels = [{"label": "Lift", "vertex_id": int(id_)} for id_ in charts["floor_1"].labels]
        server.bridge.publish_raw("/robot_0/floor_1/labeled_vertices", {"vertices": labels})
        await it.until(
            lambda state: set(state.robots["robot_0"].charts["floor_1"].labels.values()) == {"Lift"}
        )
        wanted = labels[3]["vertex_id"]
        assert isinstance(wanted, int)
        it.app.main.rest.orders.start_at(str(wanted), "floor_1")
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert sent(server)[0][1]["end_point"] == wanted


async def test_cargo_that_came_on_board_meanwhile_changes_the_form_not_the_command(
    server: RosbridgeServer,
) -> None:
    async with console(config_of(server.url, 1)) as it:
        await it.press("o")
        await it.type("Base")
        await it.press("enter")
        await it.type("Store")
        server.world.robots["robot_0"].cargo = True
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        await it.press("enter")
        await it.shows("now has cargo and no orders")
        assert sent(server) == []
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert [name for name, _ in sent(server)] == ["Execute_order_with_cargo"]


async def test_two_enters_in_a_menu_do_it_once(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
        await it.press("tab", "enter", "j")
        one_packet(it, "\r\r")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        await it.pilot.pause()
        assert sent(server) == [("Pause", {})]


async def test_a_click_beside_a_question_is_no(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
        await place(it)
        await it.shows("Base -> Consumidores", "queue")
        await it.press("X")
        await it.shows("Clear all 1 order")
        await it.pilot.click("#fleet", offset=(5, 1))
        await it.hides("Clear all 1 order")
        await it.press("y")
        assert len(server.bridge.services.calls) == 1


async def test_an_order_by_mouse_alone(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
        it.app.main.rest.orders.start()
        await it.shows("Receiving  (", "matches")
        for field in ("from", "to"):
            rows = it.app.main.query_one("#matches")
            labels = [rows.render_line(y).text for y in range(rows.size.height)]
            wanted = "Base" if field == "from" else "Store"
            row = next(y for y, text in enumerate(labels) if text.startswith(wanted))
            await it.pilot.click("#matches", offset=(3, row))
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        ids = {"initial_point": vertex(it, "Base"), "end_point": vertex(it, "Store")}
        assert sent(server) == [("Execute_order", ids)]


async def test_the_send_button_does_what_enter_does(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
        await it.press("o")
        # Not by a click at a place: the button moves with the number of matches above it.
        for label in ("Base", "Store"):
            await it.type(label)
            it.app.main.query_one("#send", Button).press()
            await it.settled()
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert [name for name, _ in sent(server)] == ["Execute_order"]


async def test_a_vertex_chosen_by_key_is_meant_even_where_a_robot_stands(server: RosbridgeServer) -> None:
    """robot_0 waits at Base."""
    async with console(config_of(server.url, 1)) as it:
        it.app.main.rest.map_controls.next_vertex(1)
        scene = it.app.main.rest.map.picture.scene
        assert scene is not None
        labelled = [found for found in scene.vertices if found.label]
        while it.app.main.rest.map.picture.options.cursor != next(
            (v.x, v.y) for v in labelled if v.label == "Base"
        ):
            it.app.main.rest.map_controls.next_vertex(1)
        await it.press("enter")
        await it.shows("Order")
        assert it.app.main.query_one("#from", Input).value == "Base"
