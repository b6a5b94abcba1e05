"""Fields of the order form: what a field means."""

from tests.support.fleets import place_order
from tests.support.ordering import order
from tests.support.planted_console import planted


async def test_another_robot_in_the_form() -> None:
    async with planted(2, 2) as it:
        await it.press("o", "shift+tab")
        await it.type("_1")
        await it.press("home", "delete", "delete", "end")
        await it.press("escape", "o", "shift+tab", "end", "backspace", "1", "enter")
        await it.type("Base")
        await it.press("enter")
        await it.type("Cons")
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [order(it, "Base", "Consumidores", robot="robot_1")]


async def test_the_same_label_on_two_floors_stays_what_was_picked() -> None:
    async with planted(1, 2) as it:
        it.fleet.world.robots["robot_0"].cargo = True
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        maps = it.store.state.robots["robot_0"].maps
        labels = [{"label": "Lift", "vertex_id": int(id_)} for id_ in maps["floor_1"].labels]
        it.publish("/robot_0/floor_1/labeled_vertices", {"vertices": labels})
        await it.until(lambda state: set(state.robots["robot_0"].maps["floor_1"].labels.values()) == {"Lift"})
        wanted = labels[3]["vertex_id"]
        assert isinstance(wanted, int)
        it.app.main.features.orders.start_at(str(wanted), "floor_1")
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [place_order("robot_0", wanted)]
