"""Orders, cancellations and interruptions as requests to a dispatcher or to a fleet adapter.

Each is published once, and never latched: a dispatcher that was restarted would carry it out again.
"""

from collections.abc import Iterable, Mapping, Sequence

import msgspec

from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.navigation import Goal
from fleet_tui.model.order import OrderState, Stop
from fleet_tui.model.robot import Robot
from fleet_tui.orders.goals import active
from fleet_tui.robots.adapter import Publication
from fleet_tui.robots.rmf.names import fleet_and_name
from fleet_tui.robots.ros.names import Names
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message, in_english

PREFIX = "fleet-tui-"
DIGITS = 12
LABELS = ["fleet-tui"]

Json = Mapping[str, object]


def order(names: Names, robot: Robot, command: PlaceOrder, unique: str) -> Sequence[Publication]:
    """Return the request of an order, to its robot or to any. Raises CommandError."""
    if not command.stops:
        raise CommandError(Message("an order needs a destination"))
    places = [_place(robot, stop) for stop in command.stops]
    request = {
        "unix_millis_earliest_start_time": 0,
        "category": "patrol",
        "description": {"places": places, "rounds": 1},
        "labels": LABELS,
        "requester": _id(unique),
    }
    if command.to_any:
        return _requests(names, unique, [{"type": "dispatch_task_request", "request": request}])
    fleet, name = fleet_and_name(robot.name)
    asked = {"type": "robot_task_request", "robot": name, "fleet": fleet, "request": request}
    return _requests(names, unique, [asked])


def _place(robot: Robot, stop: Stop) -> str:
    """Return the name of a place. Raises CommandError for one without a name."""
    if stop.pose is not None:
        raise CommandError(Message("orders of this kind lead to named places only"))
    labels = (known.labels[stop.vertex] for known in robot.maps.values() if stop.vertex in known.labels)
    if (place := next(labels, "")) == "":
        raise CommandError(
            Message(
                "vertex {vertex} has no name: orders of this kind lead to named places only",
                vertex=stop.vertex,
            )
        )
    return place


def cancel(names: Names, tasks: Iterable[str], unique: str) -> Sequence[Publication]:
    asked = [{"type": "cancel_task_request", "task_id": task, "labels": LABELS} for task in tasks]
    return _requests(names, unique, asked)


def own_tasks(robot: Robot) -> list[str]:
    """Return the open tasks that this console gave to a robot."""
    return [one.uuid for one in active(robot.goals) if one.is_ours]


def interrupt(names: Names, robot: Robot, unique: str) -> Sequence[Publication]:
    """Return the request that interrupts the task under way. Raises CommandError without one: an idle robot
    can't be paused."""
    found = [one for one in active(robot.goals) if one.state is OrderState.IN_PROCESS]
    if not found:
        raise CommandError(
            Message("{name} has no task under way: an idle robot can't be paused", name=robot.name)
        )
    asked = [{"type": "interrupt_task_request", "task_id": one.uuid, "labels": LABELS} for one in found]
    return _requests(names, unique, asked)


def resume(names: Names, robot: Robot, unique: str) -> Sequence[Publication]:
    """Return the requests that end all interruptions of a robot, whoever made them. Raises CommandError
    without one."""
    held = [one for one in active(robot.goals) if one.state is OrderState.PAUSED]
    asked = [_resumption(one) for one in held if one.tokens]
    if not asked:
        emergency = Message("its task is held by an emergency and continues when that ends")
        raise CommandError(emergency if held else Message("{name} has no interrupted task", name=robot.name))
    return _requests(names, unique, asked)


def _resumption(task: Goal) -> Json:
    tokens = list(task.tokens)
    return {"type": "resume_task_request", "for_task": task.uuid, "for_tokens": tokens, "labels": LABELS}


def _id(unique: str) -> str:
    return f"{PREFIX}{unique[:DIGITS]}"


def _requests(names: Names, unique: str, asked: Sequence[Json]) -> Sequence[Publication]:
    """Return the messages; the ids of all but the first have a number after a dot."""
    topic, type_, id_ = names.topic("requests", ""), names.type("requests"), _id(unique)
    if not topic:
        raise CommandError(Message("{table}.topics.requests is empty", table=names.table))
    return [
        Publication(
            topic,
            type_,
            {
                "json_msg": msgspec.json.encode(one, enc_hook=in_english).decode(),
                "request_id": f"{id_}.{n}" if n else id_,
            },
            id_,
            is_request=True,
        )
        for n, one in enumerate(asked)
    ]
