"""Classes of alarms, rationalised as in ISA-18.2: cause, consequence, the operator's action, time to act."""

from typing import NamedTuple


class AlarmClass(NamedTuple):
    """`priority` is the usual one; `minutes` is the time within which the action still helps."""

    priority: str
    cause: str
    consequence: str
    action: str
    minutes: float


CLASSES = {
    "link": AlarmClass(
        "high",
        "no connection to a bridge",
        "its robots are neither seen nor commanded",
        "Start rosbridge, or mend the network; `doctor` names the step that fails",
        1,
    ),
    "commands": AlarmClass(
        "high",
        "telemetry flows, but calls would not get through",
        "no order, no pause reaches the robots of the link",
        "Restart the robots' nodes or the ROS master; pause robots at themselves",
        1,
    ),
    "messages": AlarmClass(
        "high",
        "rosbridge runs without the robots' message package",
        "nothing of these robots can be read",
        "Source the robots' workspace and restart rosbridge",
        10,
    ),
    "obstacle": AlarmClass(
        "high",
        "in contact with an obstacle for longer than `obstacle_after`",
        "the robot does not drive on; others queue behind it",
        "Clear the path at the robot",
        5,
    ),
    "blocked": AlarmClass(
        "high",
        "stopped by its collision monitor for longer than `obstacle_after`",
        "the robot does not drive on; its goal may be aborted",
        "Clear the path at the robot",
        5,
    ),
    "offline": AlarmClass(
        "medium",
        "silent for longer than `offline_after`",
        "it drives on unseen, and takes no command",
        "Look at the robot: power, Wi-Fi, its nodes",
        5,
    ),
    "stuck": AlarmClass(
        "medium",
        "an order, no obstacle, no pause, and no movement for `stuck_after`",
        "its order is not carried out",
        "Press w for the reasons; cancel the order or go to the robot",
        10,
    ),
    "command": AlarmClass(
        "medium",
        "a command was refused, not confirmed or carried out late; an order was lost, failed or replaced",
        "the robots do something else than was asked; a pause that failed is high",
        "Read the reason, look at the robot, give the command again",
        2,
    ),
    "localisation": AlarmClass(
        "medium",
        "the robot does not know where it is on its map",
        "it may drive into something, or stop",
        "Pause it and set its pose",
        2,
    ),
    "held": AlarmClass(
        "low",
        "orders wait in this console; medium where another client took the robot",
        "they are not carried out",
        "Resume the robot, or clear its orders",
        30,
    ),
    "late": AlarmClass(
        "medium",
        "messages of a link come a second late or more",
        "what is shown of its robots is old",
        "Subscribe to fewer topics, lower rates at the robots, or run a second bridge",
        10,
    ),
    "behind": AlarmClass(
        "medium",
        "this console reads a second late or more",
        "what is shown is old",
        "Close other programs here, or watch fewer topics",
        10,
    ),
    "battery": AlarmClass(
        "low",
        "below `battery_low`; below `battery_critical` it is medium",
        "the robot stops on its way",
        "Send it to a charger",
        20,
    ),
    "pause": AlarmClass(
        "low",
        "paused for longer than `pause_after`",
        "its orders wait",
        "Resume it, or find out who paused it",
        30,
    ),
    "data": AlarmClass(
        "low",
        "something could not be read in the last 10 s",
        "one value of the robot, or of the link, is missing",
        "Open diagnostics (d), page Raw, key b: the bad message",
        60,
    ),
}
"""All of them, by the name that the config uses."""
