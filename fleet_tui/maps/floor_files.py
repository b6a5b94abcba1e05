"""The files of a configuration's floors: maps and route graphs."""

from collections.abc import Iterator

from fleet_tui.config.schema import Config
from fleet_tui.maps.route_graphs import load_floor_graph
from fleet_tui.model.events import FloorGraphLoaded, FloorMapLoaded


def load_floors(config: Config) -> Iterator[FloorGraphLoaded | FloorMapLoaded]:
    """Load every file one by one, small ones first. Large images take long: not for the loop."""
    yield from load_graphs(config)
    yield from load_maps(config)


def load_graphs(config: Config) -> Iterator[FloorGraphLoaded]:
    """Load the graph files alone, for commands that draw no map."""
    for floor in config.floors:
        if floor.graph:
            yield load_floor_graph(floor.name, config.beside(floor.graph))


def load_maps(config: Config) -> Iterator[FloorMapLoaded]:
    """Load the map files alone."""
    # Its libraries take longer to import than a whole command without a screen.
    from fleet_tui.maps.images import load_floor_map

    for floor in config.floors:
        if floor.map:
            yield load_floor_map(floor.name, config.beside(floor.map), config.profile.origin == "added")
