"""Sites to simulate: bridges, and the robots behind each."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from fleet_tui.simulator.faults import Faults
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
        """The names of the robots."""
        return [KINDS[self.kind].named(number) for number in self.numbers]


@dataclass(frozen=True)
class SitedBridge:
    """A bridge of a generation of ROS, and the robots behind it."""

    ros: str
    crews: tuple[Crew, ...]


def site_of(kind: str, robots: int, ros: str = "", first: int = 0) -> Sequence[SitedBridge]:
    """The bridges of a site with this number of robots, those on ROS 1 first.

    `ros`: the generation of ROS, empty for the usual one of the kind; `first`: the number in the first
    robot's name. In a mixed fleet the kinds take turns.
    """
    if kind != MIXED:
        return [SitedBridge(ros or KINDS[kind].ros[0], (Crew(kind, range(first, first + robots)),))]
    kinds = mixed_kinds()
    numbers = {kind: range(first + turn, first + robots, len(kinds)) for turn, kind in enumerate(kinds)}
    return [
        SitedBridge(ros, tuple(Crew(kind, numbers[kind]) for kind in kinds if KINDS[kind].ros[0] == ros))
        for ros in sorted({KINDS[kind].ros[0] for kind in kinds})
    ]


def mixed_kinds() -> list[str]:
    """Return the kinds of a mixed fleet."""
    return [name for name, kind in KINDS.items() if kind.mixes]


def faults_of(bridges: Iterable[SitedBridge]) -> Mapping[str, Faults]:
    """The faults that each robot knows."""
    return {
        name: KINDS[crew.kind].faults for bridge in bridges for crew in bridge.crews for name in crew.names
    }


def needs_graph_files(kind: str) -> bool:
    """Tell whether some of the robots have their graph in a file, not in a topic."""
    kinds = [KINDS[name] for name in (mixed_kinds() if kind == MIXED else [kind])]
    return any(one.graph_files for one in kinds)
