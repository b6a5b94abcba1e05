"""Sites to simulate: bridges, and the robots behind each."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from fleet_tui.simulator.faults.plays import Faults
from fleet_tui.simulator.kinds import KINDS

MIXED = "mixed"
"""The word for a site with robots of every kind."""


@dataclass(frozen=True)
class Crew:
    """The robots of one kind, by the numbers in their names."""

    kind: str
    numbers: range

    @property
    def names(self) -> list[str]:
        return [KINDS[self.kind].named(turn, number) for turn, number in enumerate(self.numbers)]


@dataclass(frozen=True)
class SitedBridge:
    """A bridge of a generation of ROS, and the robots behind it. `name`: that of its link."""

    name: str
    ros: str
    crews: tuple[Crew, ...]


def site_of(kind: str, robots: int, ros: str = "", first: int = 0) -> Sequence[SitedBridge]:
    """The bridges of a site with this number of robots, those on ROS 1 first.

    `ros`: the generation of ROS, empty for the usual one of the kind; `first`: the number in the first
    robot's name. In a mixed fleet the kinds take turns.
    """
    if kind != MIXED:
        return [_bridge("", ros or KINDS[kind].ros[0], Crew(kind, range(first, first + robots)))]
    crews = [Crew(kind, range(first + turn, first + robots, len(KINDS))) for turn, kind in enumerate(KINDS)]
    bridges = dict[tuple[str, str], list[Crew]]()
    for crew in crews:
        one = KINDS[crew.kind]
        bridges.setdefault((one.ros[0], crew.kind if one.is_apart else ""), []).append(crew)
    return [_bridge(kind, ros, *bridges[ros, kind]) for ros, kind in sorted(bridges)]


def _bridge(name: str, ros: str, *crews: Crew) -> SitedBridge:
    return SitedBridge(name or f"ros{ros}", ros, crews)


def faults_of(bridges: Iterable[SitedBridge]) -> Mapping[str, Faults]:
    """The faults that each robot knows."""
    return {
        name: KINDS[crew.kind].faults for bridge in bridges for crew in bridge.crews for name in crew.names
    }


def needs_graph_files(kind: str) -> bool:
    """Tell whether some of the robots have their graph in a file, not in a topic."""
    kinds = [KINDS[name] for name in (KINDS if kind == MIXED else [kind])]
    return any(one.graph_files for one in kinds)
