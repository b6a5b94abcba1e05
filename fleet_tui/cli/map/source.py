"""The map of a file, or the live one behind an address."""

from functools import partial
from pathlib import Path

from fleet_tui.cli.session import WaitingStore, has_link, session
from fleet_tui.config.schema import Config
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.text.errors import FleetError, LinkError, MapError, did_you_mean
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import sanitize

SCHEMES = ("ws://", "wss://")
YAML = (".yaml", ".yml")


def map_from(source: str, floor: str, seconds: float) -> tuple[OccupancyGrid, str]:
    """Return a map and its name. `floor`: of an address with several; `seconds` to wait for a live one.
    Raises FleetError."""
    if source.startswith(SCHEMES):
        from fleet_tui.cli.chosen import chosen

        return _live(chosen(None, source), floor, seconds)
    if floor:
        raise MapError(Message("--floor is for the address of a bridge: a file has one map"))
    if is_picture(source):
        raise MapError(
            sanitize(
                Message("{name} has no scale: `fleet-tui map place` gives it one", name=Path(source).name)
            )
        )
    return map_file(Path(source)), Path(source).name


def is_picture(source: str) -> bool:
    """Tell whether it is a plain picture, which has no scale."""
    return not source.startswith(SCHEMES) and Path(source).suffix.lower() not in YAML


def map_file(path: Path) -> OccupancyGrid:
    """Return the map of a file; that of a plain picture has a metre per pixel. Raises MapError."""
    from fleet_tui.maps.images import load_floor_map

    loaded = load_floor_map("", path, added=False)
    if loaded.grid is None:
        raise MapError(sanitize(loaded.problem))
    return loaded.grid


def _live(config: Config, floor: str, seconds: float) -> tuple[OccupancyGrid, str]:
    names = [one.name for one in config.floors]
    if floor and floor not in names:
        raise MapError(
            Message(
                "unknown floor {floor}{did_you_mean}", floor=floor, did_you_mean=did_you_mean(floor, names)
            )
        )
    if not floor and len(names) != 1:
        raise MapError(Message("several floors: choose one with --floor: {names}", names=", ".join(names)))
    floor = floor or names[0]
    with session(config) as (link, store):
        return _received(link, store, floor, seconds), floor


def _received(link: FleetLink, store: WaitingStore, floor: str, seconds: float) -> OccupancyGrid:
    """Wait for the live map of a floor, of each of its robots in turn. Raises FleetError."""
    robots = [name for name, robot in store.state.robots.items() if floor in robot.maps]
    for name in robots:
        link.show_map(name, floor)
        store.wait(partial(_has_grid, store, name, floor), seconds / len(robots))
        if (grid := _grid(store, name, floor)) is not None:
            return grid
    if not has_link(store.state):
        raise LinkError(Message("no link to the bridge"))
    raise FleetError(
        Message("no live map of {floor} within {seconds} s", floor=floor, seconds=f"{seconds:g}")
    )


def _has_grid(store: WaitingStore, robot: str, floor: str, _: FleetState) -> bool:
    return _grid(store, robot, floor) is not None


def _grid(store: WaitingStore, robot: str, floor: str) -> OccupancyGrid | None:
    return store.state.robots[robot].maps[floor].grid or store.state.floors[floor].live
