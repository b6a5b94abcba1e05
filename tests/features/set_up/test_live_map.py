"""The live map of the shown floor; those of other floors once, where small maps show them."""

from msgspec.structs import replace

from fleet_tui.features.set_up.live_map import MOST, PATIENCE, LiveMap
from fleet_tui.model import events
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.occupancy import grid_from_ros
from fleet_tui.ui.view.selection import Selection
from tests.support.fleets import R0, fleet, link_up, reduced

SHOWN = Selection(R0, "floor_0")
GRID = grid_from_ros(MapFrame(1.0, 2, 1), b"\0d")


def site(floors: int = 3, robots: int = 1) -> FleetState:
    frames = (events.FrameReceived(R0, f"floor_{n}", GRID.frame) for n in range(floors))
    return reduced(fleet(robots, floors), link_up(1.0), *frames)


def seen(state: FleetState, floor: int) -> FleetState:
    return reduced(state, events.GridReceived(R0, f"floor_{floor}", GRID))


def later(state: FleetState, seconds: float) -> FleetState:
    return replace(state, now=state.now + seconds)


class Bridge:
    """Notes what the console subscribes to."""

    def __init__(self) -> None:
        self.asked = list[str]()
        self.live = LiveMap(lambda _robot, floor: self.asked.append(floor))

    def after(self, state: FleetState, others: bool = True, shown: Selection = SHOWN) -> list[str]:
        self.live.show(state, shown, others)
        return self.asked


def test_the_shown_floor_comes_first_then_each_other_once_then_the_shown_one_again() -> None:
    bridge, state = Bridge(), site()
    assert bridge.after(state) == ["floor_0"]
    assert bridge.after(later(state, 60)) == ["floor_0"], "its own map has not come"
    state = seen(state, 0)
    assert bridge.after(state)[1:] == ["floor_1"]
    state = seen(state, 1)
    assert bridge.after(state)[2:] == ["floor_2"]
    assert bridge.after(later(state, PATIENCE / 2))[2:] == ["floor_2"]
    state = later(state, PATIENCE)
    assert bridge.after(state)[3:] == ["floor_0"], "the third has none"
    assert bridge.after(later(state, 60))[3:] == ["floor_0"], "and is not asked for again"


def test_a_map_that_was_dropped_is_asked_for_again_once_another_robot_is_selected() -> None:
    state = seen(reduced(site(2, 2), events.FrameReceived("robot_1", "floor_1", GRID.frame)), 0)
    bridge, other = Bridge(), Selection("robot_1", "floor_0")
    kept = seen(state, 1)
    assert bridge.after(kept) == ["floor_0"]
    assert bridge.after(kept, shown=other) == ["floor_0"] * 2, "it is drawn with the one of robot_0"
    assert bridge.after(later(state, 60), shown=other)[2:] == ["floor_1"]
    assert bridge.after(later(state, 120), shown=other)[3:] == ["floor_0"]
    assert bridge.after(later(state, 180), shown=SHOWN)[4:] == ["floor_1"]


def test_without_small_maps_and_while_mapping_only_the_shown_floor_is_subscribed_to() -> None:
    bridge, state = Bridge(), seen(site(), 0)
    assert bridge.after(state, others=False) == ["floor_0"]
    robot = replace(state.robots[R0], mapping_by_us=True)
    assert bridge.after(replace(state, robots={R0: robot})) == ["floor_0"]
    assert bridge.after(seen(site(), 0), shown=Selection(R0, "floor_1"))[1:] == ["floor_1"]


def test_a_floor_with_a_file_needs_no_live_map_and_without_a_link_nothing_is_asked() -> None:
    state = site(2)
    filed = {name: replace(floor, grid=GRID) for name, floor in state.floors.items()}
    assert Bridge().after(replace(state, floors=filed)) == [""]
    assert Bridge().after(seen(reduced(fleet(1, 2)), 0)) == ["floor_0"]


def test_no_more_floors_are_asked_than_maps_are_kept() -> None:
    bridge, state = Bridge(), seen(site(8), 0)
    for floor in range(1, 8):
        bridge.after(state)
        state = seen(later(state, PATIENCE), floor) if floor <= MOST else later(state, PATIENCE)
    assert bridge.after(state) == [*(f"floor_{n}" for n in range(1, MOST + 1)), "floor_0"]
