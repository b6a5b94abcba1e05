"""move_base of one simulated robot, asked as clients do."""

from typing import Any

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.messages import solid
from fleet_tui.simulator.move_base.navigation import SimMoveBase
from fleet_tui.simulator.navigating.world import NavigatingWorld
from fleet_tui.simulator.ros.actionlib import GoalReport

FAR, NEAR = (35.0, 20.0), (8.0, 0.0)
Json = dict[str, Any]


def world() -> tuple[NavigatingWorld[SimMoveBase], SimMoveBase]:
    it = NavigatingWorld(SimMoveBase, 1, 1, seed=1, quiet=True)
    it.step(1.0)
    return it, it.navigation["robot_0"]


def goal(id_: str, spot: tuple[float, float] = FAR, secs: int = 0, frame: str = "map", **more: Json) -> Json:
    target = {"header": {"frame_id": frame}, "pose": solid(Pose(*spot)) | more}
    return {"goal_id": {"stamp": {"secs": secs, "nsecs": 0}, "id": id_}, "goal": {"target_pose": target}}


def cancelled(id_: str = "", secs: int = 0) -> Json:
    return {"stamp": {"secs": secs, "nsecs": 0}, "id": id_}


def stand(navigation: SimMoveBase) -> dict[str, int]:
    return {one.id: one.status for one in navigation.server.listed()}


def results(navigation: SimMoveBase) -> list[tuple[str, int, str]]:
    """The results since the last look."""
    found = [(one.id, one.status, one.text) for one in navigation.server.said if isinstance(one, GoalReport)]
    navigation.server.said.clear()
    return found


def finish(it: NavigatingWorld[SimMoveBase], navigation: SimMoveBase, limit: float = 300.0) -> None:
    end = it.time + limit
    while navigation.busy:
        it.step(0.1)
        assert it.time < end
