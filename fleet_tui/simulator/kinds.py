"""The kinds of simulated robots: one line each."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from fleet_tui.simulator.faults import FAULTS
from fleet_tui.simulator.faults.plays import Faults
from fleet_tui.simulator.move_base.faults import FAULTS as MOVE_BASE_FAULTS
from fleet_tui.simulator.nav2.faults import FAULTS as NAV2_FAULTS
from fleet_tui.simulator.rmf.faults import FAULTS as RMF_FAULTS
from fleet_tui.simulator.rmf.naming import full_name

if TYPE_CHECKING:
    # The command line lists kinds and faults: it must not wait for those to be imported.
    from fleet_tui.simulator.fleets import Fleet
    from fleet_tui.simulator.server import RosbridgeServer


Build = Callable[[int, int, int, int, int], "Fleet"]
"""Makes a fleet from the number of robots, that of floors, the seed, and the first number in the names of the
robots and the step to the next."""
Profile = Callable[[int], Mapping[str, Any]]
"""Returns the table of the configuration that says how the simulated robots differ from the usual, by the
number of floors."""


def _oh_ressources_profile(_floors: int) -> Mapping[str, Any]:
    """The topics on which they report a pause, and those of set-up."""
    topics = ("paused", "goal", "goal_cancel", "scan", "mode")
    return {
        "topics": {
            **{key: f"/{{robot}}/{key}" for key in topics},
            "initial_pose": "/{robot}/initialpose",
            "drive": "/{robot}/cmd_vel",
            "camera": "/{robot}/camera/image_raw/compressed",
            **{key: f"/{{robot}}/{{floor}}/{key}" for key in ("graph_save", "labels_save")},
        },
        "services": {
            **dict.fromkeys(("mapping_on", "mapping_off"), "/{robot}/set_mapping"),
            "map_save": "/{robot}/save_map",
        },
    }


def _navigating_profile(floors: int) -> Mapping[str, Any]:
    """The topic of the mode, with several floors also those of the robot's floor and of a map per floor."""
    several = {"floor": "/{robot}/floor", "map": "/{floor}/map"} if floors > 1 else {}
    return {"topics": {"mode": "/{robot}/mode", **several}}


def _usual_names(_floors: int) -> Mapping[str, Any]:
    return {}


@dataclass(frozen=True)
class SimKind:
    """A kind of robots: the generations of ROS it runs on, the usual one first, and its faults."""

    build: Build
    ros: tuple[str, ...]
    faults: Faults
    profile: Profile
    graph_files: bool = False
    """Their graph is no topic but a file."""
    named: Callable[[int, int], str] = "robot_{1}".format
    """Returns the name of the robot with a number, the first argument being its turn in this kind."""
    is_apart: bool = False
    """In a mixed fleet they have a bridge of their own: Nav2 has another type of /map."""


def _oh_ressources(robots: int, floors: int, seed: int, first: int, step: int) -> "Fleet":
    from fleet_tui.simulator.oh_ressources.fleet import OhFleet

    return OhFleet(robots, floors, seed, first=first, step=step)


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
    "oh_ressources": SimKind(_oh_ressources, ("1", "2"), FAULTS, _oh_ressources_profile),
    "move_base": SimKind(_move_base, ("1",), MOVE_BASE_FAULTS, _navigating_profile, graph_files=True),
    "nav2": SimKind(_nav2, ("2",), NAV2_FAULTS, _navigating_profile, graph_files=True),
    "rmf": SimKind(_rmf, ("2",), RMF_FAULTS, _usual_names, named=full_name, is_apart=True),
}


def play(server: "RosbridgeServer", wanted: Iterable[tuple[str, str]]) -> None:
    """Apply these faults to these robots from now on."""
    for name, robot in wanted:
        KINDS[server.bridge.services.fleet_of(robot).kind].faults[name][1](server, robot)
