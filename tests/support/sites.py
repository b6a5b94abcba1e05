"""A fleet on two sites."""

from msgspec.structs import replace

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.schema import Config, Link
from fleet_tui.config.start import initial_state
from fleet_tui.model.fleet import FleetState
from tests.support.fleets import T0, battery, link_up, reduced, tick
from tests.support.watched_store import config_of


def config_of_sites(first: Link, second: Link) -> Config:
    """Two robots on the first link, one on the second, each link with a floor of its own."""
    return replace(
        config_of(first.url),
        rosbridge=first,
        links={"b": second},
        floors=[FloorEntry("floor_0"), FloorEntry("floor_1")],
        robots=[
            RobotEntry("robot_0", floors=["floor_0"]),
            RobotEntry("robot_2", floors=["floor_0"]),
            RobotEntry("robot_1", floors=["floor_1"], link="b"),
        ],
    )


def two_sites(first: str = "north", second: str = "south") -> FleetState:
    """A robot of the second site has an alarm."""
    config = config_of_sites(Link("ws://a", site=first), Link("ws://b", site=second))
    low = battery(T0, 5.0, "robot_1")
    return reduced(initial_state(config, T0), link_up(T0), replace(link_up(T0), link="b"), low, tick(T0))
