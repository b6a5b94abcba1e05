"""The map image that a `graph` command is given."""

from pathlib import Path

from fleet_tui.maps.images import load_floor_map
from fleet_tui.model.graphs.document import GraphDocument
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.text.errors import GraphError, MapError
from fleet_tui.text.language import Message


def map_grid(file: str, document: GraphDocument) -> OccupancyGrid:
    """Return the grid of a map image. Raises MapError, and GraphError unless the graph has one floor."""
    if len(document.floors) != 1:
        names = ", ".join(list(document.floors)[:10]) or "none"
        raise GraphError(
            Message("a map is of one floor, and the file has {names}: choose one with --floor", names=names)
        )
    loaded = load_floor_map("", Path(file), added=False)
    if loaded.grid is None:
        raise MapError(loaded.problem)
    if not loaded.tied:
        raise MapError(
            Message("map {name}: has no place in the world: give its map_server YAML", name=Path(file).name)
        )
    return loaded.grid
