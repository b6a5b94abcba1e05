"""Capabilities of navigating robots, common to all stacks."""

import math
from collections.abc import Callable, Mapping, Sequence

from fleet_tui.model.kind import CANCEL, CLEAR, GRAPH, ORDER, ORDER_TO, Kind
from fleet_tui.robots.ros.names import Names
from fleet_tui.robots.ros.set_up.requests import SetUpRequests
from fleet_tui.robots.ros_navigation import reading
from fleet_tui.robots.ros_navigation.pauses import Pauses

TOPICS = ("odometry", "pose", "battery")
ORDERING = (ORDER, ORDER_TO, CANCEL, CLEAR)
BATTERY_SILENCE = 60.0
"""Seconds after which a battery reading is old: some drivers publish it every ten seconds."""
READERS: Mapping[str, Callable[[Names], reading.Read]] = {
    "odometry": reading.read_odometry,
    "pose": reading.read_localisation,
    "battery": reading.read_battery,
    "floor": reading.read_floor,
    "plan": reading.read_plan,
}
"""Readers of the topics common to all of them."""


def kind_of_goals(
    name: str,
    names: Names,
    pauses: Pauses,
    set_up: SetUpRequests,
    reports: Sequence[str],
    silence: Mapping[str, float],
) -> Kind:
    """Return a kind of robots that drive one goal at a time. `reports` are its values besides position,
    charge and maps, `silence` theirs."""
    return Kind(
        name,
        tuple(key for key in (*TOPICS, *reports, "mode") if _has(names, key)),
        (*ORDERING, *pauses.accepted, *set_up.accepted),
        {**_usual_silence(names), **silence, **names.profile.silence},
        {**pauses.unset, **set_up.unset},
        frames_are_floors=False,
        reports_ends=True,
        keeps_goals=True,
        holds=pauses.holds,
        may_lock=pauses.may_lock,
        takes_stops=True,
        changes_floors=False,
        loads_graphs=GRAPH in set_up.accepted,
        streams=set_up.streams,
        pose_topic=names.topic("pose", "{robot}") or names.topic("tf", "{robot}"),
        odometry_topic=names.topic("odometry", "{robot}"),
    )


def _usual_silence(names: Names) -> Mapping[str, float]:
    # The localisation of a robot at rest is silent: only odometry shows that it is online.
    placed = {} if _has(names, "odometry") else {"pose": math.inf}
    return {"battery": BATTERY_SILENCE, "mode": math.inf, **placed}


def _has(names: Names, key: str) -> bool:
    if key == "pose":
        return True  # without a topic its transforms tell it, or the feedback on a goal
    return key not in names.vocabulary.topics or bool(names.topic(key, "robot", "floor"))
