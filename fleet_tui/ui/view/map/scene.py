"""The scene: the content of the map at one moment, independent of the fleet's state."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.geometry import Line, MapFrame, Pose
from fleet_tui.model.graph import Role
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.set_up.streams import Points
from fleet_tui.ui.view.map.camera import Area


@dataclass(frozen=True, slots=True)
class SceneVertex:
    """A vertex at x, y in metres; `label` is empty for one without."""

    id: str
    x: float
    y: float
    role: Role = Role.PLAIN
    label: str = ""


class SceneRobot(NamedTuple):
    """A robot at its last known pose. number: 1 = first of the config; mark: its number on the map if that is
    another; age: seconds since its last message; size: length and width in metres, None if unknown; alarmed:
    an alarm of it waits for an acknowledgement; acknowledged: it has alarms, and none waits; jumped: its
    localisation has just moved it; misplaced: its pose is inside a wall or off the map; waits: it has stood
    with an order for long; said: its most urgent alarm; estimated: its pose is one between nodes.

    A tuple, because a hundred of them are made ten times a second: it takes a third of the time."""

    name: str
    number: int
    pose: Pose
    cargo: bool = False
    selected: bool = False
    online: bool = True
    paused: bool = False
    obstacle: bool = False
    other_map: bool = False
    age: float = 0.0
    size: tuple[float, float] | None = None
    mark: str = ""
    alarmed: bool = False
    acknowledged: bool = False
    jumped: bool = False
    waits: bool = False
    said: str = ""
    misplaced: bool = False
    estimated: bool = False

    @property
    def is_odd(self) -> bool:
        """Tell whether it may need a person soon, or a person knows of its trouble."""
        return self.waits or self.obstacle or self.acknowledged or self.misplaced


@dataclass(frozen=True, slots=True)
class Mission:
    """The remaining route of the selected robot on a floor, along the graph: the current order, and those
    after it. edge: the robot's current edge, from the vertex behind it to the one ahead, the start of the
    current way."""

    current: tuple[Line, ...] = ()
    following: tuple[Line, ...] = ()
    edge: Line | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """One floor at the monotonic second `at`. Without `grid` the frame still gives the extent.

    waits: the note is no problem yet, shortly after the start; elsewhere: robots in trouble on other floors,
    in words; area: left, top, right, bottom in map pixels of the ground that is worth seeing, None for all;
    beams: ends of the selected robot's laser beams, in metres from the robot, seen from `beams_at`; path: its
    planned path; closed: the edges that people closed; blocked: those on which a robot with an alarm is in
    the way; deadlocked: the next edges of robots that wait for each other; picked: the id of the vertex
    marked in an order being typed; one_way: the edges that lead only from start to end; trail: past positions
    of robots, rows of x, y in metres and the age in seconds.

    Keep `grid`, `vertices` and `edges` the same objects while they are unchanged: the picture below the
    robots is redrawn when one of them is another object."""

    floor: str
    frame: MapFrame
    grid: OccupancyGrid | None = None
    vertices: tuple[SceneVertex, ...] = ()
    edges: tuple[Line, ...] = ()
    robots: tuple[SceneRobot, ...] = ()
    target_vertices: tuple[str, ...] = ()
    note: str = ""
    elsewhere: str = ""
    one_way: tuple[Line, ...] = ()
    mission: Mission | None = None
    trail: NDArray[np.float64] | None = None
    at: float = 0.0
    area: Area | None = None
    waits: bool = False
    beams: Points | None = None
    beams_at: Pose | None = None
    beams_are_old: bool = False
    picked: str = ""
    path: Points | None = None
    closed: tuple[Line, ...] = ()
    blocked: tuple[Line, ...] = ()
    deadlocked: tuple[Line, ...] = ()

    def with_note(self, note: str) -> "Scene":
        """Return the scene with a note that is no problem."""
        return replace(self, note=note, waits=True)

    @property
    def selected(self) -> SceneRobot | None:
        """The selected robot, if it is on this floor."""
        return next((robot for robot in self.robots if robot.selected), None)
