"""Fields of the order form: what a field means."""

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console
from tests.support.ordering import sent
from tests.support.watched_store import config_of


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


async def test_the_same_label_on_two_floors_stays_what_was_picked(server: RosbridgeServer) -> None:
    server.world.robots["robot_0"].cargo = True
    async with console(config_of(server.url, 1, 2)) as it:
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        maps = it.store.state.robots["robot_0"].maps
        labels = [{"label": "Lift", "vertex_id": int(id_)} for id_ in maps["floor_1"].labels]
        server.bridge.publish_raw("/robot_0/floor_1/labeled_vertices", {"vertices": labels})
        await it.until(lambda state: set(state.robots["robot_0"].maps["floor_1"].labels.values()) == {"Lift"})
        wanted = labels[3]["vertex_id"]
        assert isinstance(wanted, int)
        it.app.main.features.orders.start_at(str(wanted), "floor_1")
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert sent(server)[0][1]["end_point"] == wanted
