"""Places of a floor in the frame of the site, for formats with one frame for all floors."""

from msgspec.structs import replace

from fleet_tui.model.geometry import Pose
from fleet_tui.model.graphs.document import IDENTITY, DocumentFloor, DocumentVertex


def in_site(floor: DocumentFloor) -> DocumentFloor:
    """Return the floor with its vertices and control points in the site's frame."""
    if floor.to_site == IDENTITY:
        return floor
    frame = Pose(*floor.to_site)
    vertices = {id_: _moved(vertex, frame) for id_, vertex in floor.vertices.items()}
    edges = {
        id_: replace(edge, control_points=tuple(_place(frame, *point) for point in edge.control_points))
        for id_, edge in floor.edges.items()
    }
    return replace(floor, vertices=vertices, edges=edges, to_site=IDENTITY)


def _place(frame: Pose, x: float, y: float) -> tuple[float, float]:
    moved = frame.after(Pose(x, y))
    return moved.x, moved.y


def _moved(vertex: DocumentVertex, frame: Pose) -> DocumentVertex:
    moved = frame.after(Pose(vertex.x, vertex.y, vertex.heading or 0.0))
    heading = None if vertex.heading is None else moved.yaw
    return replace(vertex, x=moved.x, y=moved.y, heading=heading)
