"""The live map of the shown floor, and one look at that of each other floor with a small map."""

from collections.abc import Callable

from msgspec.structs import replace

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import Phase
from fleet_tui.orders.mode import mapping_text
from fleet_tui.state.reducer import LIVE_MAPS_KEPT
from fleet_tui.ui.view.map.floor_scene import live_map, map_owner
from fleet_tui.ui.view.selection import Selection

PATIENCE = 5.0
"""Seconds that a floor has to send its map, before the next one is asked."""
MOST = LIVE_MAPS_KEPT - 1
"""Floors that are asked: more maps are not kept beside the shown one."""


class LiveMap:
    """Subscribes to one live map at a time: maps are the largest messages of a bridge, and rarely change.
    `subscribe` takes a robot and a floor, "" for none."""

    def __init__(self, subscribe: Callable[[str, str], None]) -> None:
        self._subscribe = subscribe
        self._subscribed: tuple[str, str] | None = None
        self._asked: dict[str, float] = {}
        """Other floors, by the time when their turn ends."""
        self._asked_for = ""

    def show(self, state: FleetState, selection: Selection, others: bool) -> None:
        """Subscribe to the map of the shown floor, unless a file has it. With `others`, each other floor
        without a map is asked once for each selected robot, after the shown one has come: what is kept of the
        others is dropped when more robots have been looked at."""
        if self._asked_for != selection.robot:
            self._asked = {}
            self._asked_for = selection.robot
        wanted = self._of(state, selection)
        if wanted is None:
            return
        if others and not (wanted[1] and (_is_missing(state, selection) or _is_mapping(state, selection))):
            wanted = self._next_other(state, selection) or wanted
        if wanted != self._subscribed:
            self._subscribed = wanted
            self._subscribe(*wanted)

    def _of(self, state: FleetState, selection: Selection) -> tuple[str, str] | None:
        """Return the robot and the floor to subscribe to."""
        owner = map_owner(state, selection)
        if owner is None:
            return None
        is_live = state.floors[selection.floor].grid is None or _is_mapping(state, selection)
        return owner.name, selection.floor if is_live else ""

    def _next_other(self, state: FleetState, selection: Selection) -> tuple[str, str] | None:
        for floor in state.floors:
            other = replace(selection, floor=floor)
            found = self._of(state, other) if _is_missing(state, other) else None
            if floor == selection.floor or found is None or not _is_up(state, found[0]):
                continue
            if floor not in self._asked and len(self._asked) == MOST:
                break
            if state.now < self._asked.setdefault(floor, state.now + PATIENCE):
                return found
        return None


def _is_missing(state: FleetState, selection: Selection) -> bool:
    known, owner = state.floors[selection.floor], map_owner(state, selection)
    kept = live_map(state, known, owner.maps[selection.floor]) if owner is not None else None
    return (known.grid or kept) is None


def _is_up(state: FleetState, robot: str) -> bool:
    return state.links[state.robots[robot].link].phase is Phase.UP


def _is_mapping(state: FleetState, selection: Selection) -> bool:
    return bool(mapping_text(state.robots[selection.robot]))
