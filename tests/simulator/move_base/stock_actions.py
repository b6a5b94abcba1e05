"""roslibpy's own client of actionlib: gives goals to the server at the URL, prints how they ended as JSON."""

import json
import sys
import threading
from typing import Any

import roslibpy
from roslibpy.ros1.actionlib import ActionClient, Goal

PATIENCE = 20  # seconds for anything
TURN = {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}


def main() -> None:
    ros = roslibpy.Ros(sys.argv[1].removesuffix("/"))
    ros.run(timeout=PATIENCE)
    client = ActionClient(
        ros, "/robot_0/move_base", "move_base_msgs/MoveBaseAction", PATIENCE, omit_feedback=False
    )
    reached, cancelled = goal(client, 8.0), goal(client, 35.0)
    subscriptions: list[Any] = []
    reached.on("feedback", subscriptions.append)
    ends = [driven(reached)]
    cancelled.on("status", lambda status: status["status"] == 1 and cancelled.cancel())
    ends.append(driven(cancelled))
    print(json.dumps({"ends": ends, "feedback": subscriptions[0]}))
    ros.terminate()


def driven(goal: Goal) -> list[Any]:
    """Give a goal, and return the status and the text with which it ended."""
    over = threading.Event()

    def listen(status: dict[str, Any]) -> None:
        if status["status"] in (2, 3, 4, 5, 8):
            over.set()

    goal.on("status", listen)
    goal.send()
    goal.wait(PATIENCE)  # for the result, which may come before the status
    over.wait(PATIENCE)
    return [goal.status["status"], goal.status["text"]]


def goal(client: ActionClient, x: float) -> Goal:
    pose = {"position": {"x": x, "y": 0.0, "z": 0.0}, "orientation": TURN}
    target = {"header": {"frame_id": "map"}, "pose": pose}
    return Goal(client, roslibpy.Message({"target_pose": target}))


if __name__ == "__main__":
    main()
