"""What the map shows at one moment, free of how the fleet keeps it."""

from dataclasses import dataclass

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import Role
from fleet_tui.model.occupancy import OccupancyGrid


@dataclass(frozen=True, slots=True)
class SceneVertex:
    """A vertex at x, y in metres; `label` is empty for one without."""

    id: int
    x: float
    y: float
    role: Role = Role.PLAIN
    label: str = ""


@dataclass(frozen=True, slots=True)
class SceneRobot:
    """A robot at its last known pose. number: 1 = first of the config; age: seconds since heard of."""

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


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """One floor. Without `grid` the frame still gives the extent. edges: (x1, y1, x2, y2) in metres.

    Keep `grid`, `vertices` and `edges` the same objects while they are unchanged: the picture
    below the robots is made anew when one of them is another object.
    """

    floor: str
    frame: MapFrame
    grid: OccupancyGrid | None = None
    vertices: tuple[SceneVertex, ...] = ()
    edges: tuple[tuple[float, float, float, float], ...] = ()
    robots: tuple[SceneRobot, ...] = ()
    target_vertices: tuple[int, ...] = ()
    note: str = ""

    @property
    def selected(self) -> SceneRobot | None:
        """The selected robot, if it is on this floor."""
        return next((robot for robot in self.robots if robot.selected), None)
