"""The kinds of simulated robots: one line each."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

from fleet_tui.simulator.faults import FAULTS
from fleet_tui.simulator.faults.plays import Faults
from fleet_tui.simulator.move_base.faults import FAULTS as MOVE_BASE_FAULTS
from fleet_tui.simulator.nav2.faults import FAULTS as NAV2_FAULTS
from fleet_tui.simulator.navigating.profile import profile as navigating
from fleet_tui.simulator.oh_ressources.profile import profile as oh_ressources
from fleet_tui.simulator.rmf.faults import FAULTS as RMF_FAULTS
from fleet_tui.simulator.rmf.naming import full_name
from fleet_tui.simulator.rmf.profile import profile as rmf

if TYPE_CHECKING:
    # The command line lists kinds and faults: it must not wait for those to be imported.
    from fleet_tui.simulator.fleets import Fleet
    from fleet_tui.simulator.server import RosbridgeServer


class Build(Protocol):
    """Makes a fleet; the numbers in the robots' names are from `first` on, each `step`th."""

    def __call__(self, robots: int, floors: int, seed: int, first: int, step: int) -> "Fleet":
        """Make it."""


@dataclass(frozen=True)
class SimKind:
    """A kind of robots: the generations of ROS it runs on, the usual one first, and its faults.

    `profile`: the table of the configuration that says how the simulated ones differ from the usual, by the
    number of floors.
    """

    build: Build
    ros: tuple[str, ...]
    faults: Faults
    profile: Callable[[int], Mapping[str, Any]]
    graph_files: bool = False
    """Their graph is no topic but a file."""
    named: Callable[[int, int], str] = "robot_{1}".format
    """Returns the name of the robot with a number, the first argument being its turn in this kind."""
    is_apart: bool = False
    """In a mixed fleet they have a bridge of their own: Nav2 has another type of /map."""


def _oh_ressources(robots: int, floors: int, seed: int, first: int, step: int) -> "Fleet":
    from fleet_tui.simulator.oh_ressources.fleet import OhFleet
    from fleet_tui.simulator.oh_ressources.world import World

    return OhFleet(World(robots, floors, seed, first=first, step=step))


def _move_base(robots: int, floors: int, seed: int, first: int, step: int) -> "Fleet":
    from fleet_tui.simulator.move_base.fleet import MoveBaseFleet

    return MoveBaseFleet(robots, floors, seed, first=first, step=step)


def _nav2(robots: int, floors: int, seed: int, first: int, step: int) -> "Fleet":
    from fleet_tui.simulator.nav2.fleet import Nav2Fleet

    return Nav2Fleet(robots, floors, seed, first=first, step=step)


def _rmf(robots: int, floors: int, seed: int, first: int, step: int) -> "Fleet":
    from fleet_tui.simulator.rmf.fleet import RmfFleet

    return RmfFleet(robots, floors, seed, first=first, step=step)


KINDS: Mapping[str, SimKind] = {
    "oh_ressources": SimKind(_oh_ressources, ("1", "2"), FAULTS, oh_ressources),
    "move_base": SimKind(_move_base, ("1",), MOVE_BASE_FAULTS, navigating, graph_files=True),
    "nav2": SimKind(_nav2, ("2",), NAV2_FAULTS, navigating, graph_files=True),
    "rmf": SimKind(_rmf, ("2",), RMF_FAULTS, rmf, named=full_name, is_apart=True),
}


def play(server: "RosbridgeServer", wanted: Iterable[tuple[str, str]]) -> None:
    """Apply these faults to these robots from now on."""
    for name, robot in wanted:
        KINDS[server.bridge.services.fleet_of(robot).kind].faults[name][1](server, robot)
