"""Checks before a command leaves: one function for each, with its name.

The same for keys, menus, forms, typed lines and the command line; the first of three gates. The second asks
the operator: `ui/controllers/dispatch.py`, or `cli/orders/sending.py` for the command line. The last one
is at the link: `links/fleet_link.py`. A pause is never held back.
"""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence

from msgspec.structs import replace

from fleet_tui.commands.abilities import unaccepted
from fleet_tui.commands.rights import needed_for
from fleet_tui.commands.route_checks import (
    floor_mismatch,
    mistakable,
    no_path,
    no_way_there,
    same_place,
    unknown_vertex,
)
from fleet_tui.commands.set_up import checks as set_up
from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PlaceOrder, ResumeRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.model.order import PENDING
from fleet_tui.model.problem import Permissions, Problem
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.orders.local_queue import all_orders, clearable, orders_of
from fleet_tui.orders.masters import VEHICLE_CHECKS
from fleet_tui.situation.pauses import own_pause_text
from fleet_tui.situation.robots import absence
from fleet_tui.text.errors import did_you_mean
from fleet_tui.text.language import Message, counted
from fleet_tui.text.limits import some
from fleet_tui.text.units import age


def claimed(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that no other console of the desk has claimed the robot."""
    if names := state.desk.other_holders(robot.name):
        yield Problem(
            "claimed",
            Message("{name} is claimed by {names}", name=robot.name, names=" and ".join(names)),
            blocks=False,
        )


_NOT_POSITIVE = re.compile(r"-[0-9]+|0+", re.ASCII)
SAME_WITHIN = 1.0
"""Seconds within which the same orders given again count as a slip."""


Check = Callable[[FleetState, Robot, Command], Iterator[Problem]]


def unknown_robot(state: FleetState, name: str) -> Problem:
    """Check that the robot exists."""
    return Problem(
        "unknown robot",
        Message(
            "unknown robot {name}{did_you_mean}", name=name, did_you_mean=did_you_mean(name, state.robots)
        ),
    )


def no_link(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that commands would get through."""
    link = state.links[robot.link]
    if link.phase is not Phase.UP:
        reason = link.reason or Message("not connected yet")
        yield Problem("no link", Message("{name} is unreachable: {reason}", name=robot.name, reason=reason))
    elif link.command_path is CommandPath.DEAD:
        yield Problem(
            "no link",
            Message(
                "no command path to {name}: {command_reason}",
                name=robot.name,
                command_reason=link.command_reason,
            ),
        )


def silent(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that the robot is online."""
    if isinstance(command, ResumeRobot):
        return
    fact = None if state.is_online(robot) else absence(state, robot)
    if fact is not None:
        yield Problem(fact.kind.word, fact.question, blocks=False)


def paused(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that an order would be driven now."""
    if isinstance(command, PlaceOrder) and state.is_paused(robot):
        how = Message("paused") if robot.paused is not None else own_pause_text(state, robot)
        yield Problem("paused", Message("{name} is {how}", name=robot.name, how=how), blocks=False)


def unconfirmable_queue(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that the progress of an order can be seen."""
    if not isinstance(command, PlaceOrder) or robot.last_received is None or not state.is_online(robot):
        return
    if robot.kind.expects("queue") and not state.is_fresh(robot, "queue"):
        since = (
            Message("was not received")
            if robot.queue is None
            else Message("is {age} old", age=age(state.now - robot.queue.at))
        )
        text = Message(
            "the queue of {name} {since}: the order can't be confirmed", name=robot.name, since=since
        )
        yield Problem("queue unheard", text, blocks=False)


def not_in_queue(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that the order to cancel exists."""
    if not isinstance(command, CancelOrder):
        return
    # If ids are numbers: other kinds have their own words for all orders.
    if _NOT_POSITIVE.fullmatch(command.order_id):
        text = Message(
            "order id {order_id} means all orders to the robot: use clear instead", order_id=command.order_id
        )
        yield Problem("id means all", text)
        return
    old = not state.is_fresh(robot, "queue")
    order = next((one for one in all_orders(state, robot) if one.id == command.order_id), None)
    if order is None and robot.kind.lists_orders:
        if robot.kind.keeps_goals:
            text = Message("{name} has no order {order_id}", name=robot.name, order_id=command.order_id)
        else:
            text = Message(
                "order {order_id} is not in the queue of {name}", order_id=command.order_id, name=robot.name
            )
        if old:
            text = Message("{problem} at last report", problem=text)
        yield Problem("not in the queue", text, blocks=not old)
    elif order is not None and order.is_over:
        text = Message(
            "order {order_id} of {name} is already {state_text}",
            order_id=command.order_id,
            name=robot.name,
            state_text=order.state_text,
        )
        yield Problem("not in the queue", text, blocks=not old)


def nothing_to_clear(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that there is an order to clear."""
    if isinstance(command, ClearOrders) and robot.kind.lists_orders:
        if clearable(state, robot):
            return
        old, ours = not state.is_fresh(robot, "queue"), Message(" of this console") * robot.kind.clears_own
        text = Message(
            "{name} {fact}",
            name=robot.name,
            fact=Message("had no orders{ours} at last report", ours=ours)
            if old
            else Message("has no orders{ours}", ours=ours),
        )
        is_on_its_way = not all(one.is_decided for one in orders_of(state, robot))
        yield Problem("nothing to clear", text, blocks=not (old or is_on_its_way))


def cargo(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check the start: cargo on board without an order has only a destination; without cargo a start is
    needed."""
    if not isinstance(command, PlaceOrder) or not robot.kind.brings_cargo:
        return
    waiting = sum(order.state in PENDING for order in robot.orders.orders)
    if not command.with_cargo:
        if robot.has_cargo and not robot.orders.orders:
            start = robot.name_of(command.stops[0].vertex) or command.stops[0].vertex
            text: Message = Message(
                "{name} carries cargo: drive to {start} first?", name=robot.name, start=start
            )
            yield Problem("cargo on board", text, blocks=False)
    elif not robot.has_cargo:
        sure = state.is_fresh(robot, "cargo")
        text = Message("{name} has no cargo on board: an order needs From and To", name=robot.name)
        yield Problem(
            "no cargo",
            text if sure else Message("{name} does not report cargo on board", name=robot.name),
            sure,
        )
    elif waiting:
        text = counted(
            "{name} has cargo on board, and {count} order pending",
            "{name} has cargo on board, and {count} orders pending",
            waiting,
            name=robot.name,
        )
        yield Problem("cargo on board", text, blocks=False)


CHECKS: tuple[Check, ...] = (
    no_link,
    *set_up.CHECKS,
    unknown_vertex,
    same_place,
    no_path,
    not_in_queue,
    nothing_to_clear,
    silent,
    unconfirmable_queue,
    paused,
    floor_mismatch,
    claimed,
    *VEHICLE_CHECKS,
)
OF_ROBOT: tuple[Check, ...] = (no_link, silent, unconfirmable_queue, paused, claimed, *VEHICLE_CHECKS)
"""Checks that need no more of an order than its robot."""
FIRST: tuple[Check, ...] = (no_way_there, cargo)
"""Checks of only the first command to a robot: the others follow it."""


OF_ANY: tuple[Check, ...] = (no_link, unknown_vertex, same_place)  # its dispatcher knows the rest


def not_accepted(state: FleetState, commands: Sequence[Command]) -> list[Problem]:
    """Return the commands that robots can't take because of their kind; robots with the same reason are named
    together."""
    robots: dict[str, list[str]] = {}
    for command in commands:
        if reason := unaccepted(state, command):
            robots.setdefault(reason, []).append(command.robot)
    return [
        Problem(
            "not accepted", Message("{some}: {reason}", some=some(list(dict.fromkeys(names))), reason=reason)
        )
        for reason, names in robots.items()
    ]


def acceptable(state: FleetState, request: Request) -> tuple[Request, list[Problem]]:
    """Return the part of a request that the robots' kinds accept, and the rest: the others don't wait for a
    robot that can't. A request that none accepts is unchanged: `problems` has the reason."""
    able = tuple(command for command in request.commands if not unaccepted(state, command))
    if not able or len({command.robot for command in request.commands}) == 1:
        return request, []
    left_out = [command for command in request.commands if command not in able]
    return replace(request, commands=able), not_accepted(state, left_out)


def robot_problems(state: FleetState, robot: Robot) -> list[Problem]:
    """Return what speaks against any order to a robot, errors first."""
    order = PlaceOrder(robot.name, ())
    found = dict.fromkeys(problem for check in OF_ROBOT for problem in check(state, robot, order))
    return sorted(found, key=lambda problem: not problem.blocks)


def problems(state: FleetState, request: Request, allowed: Permissions) -> list[Problem]:
    """Return all objections to a request, errors first; the only place that runs the checks."""
    needed = needed_for(request.commands)
    if refusal := allowed.refusal(needed):
        return [Problem("not allowed", refusal)]
    if impossible := not_accepted(state, request.commands):
        return impossible
    if request.only_pauses:
        return []
    objection = allowed.objection(needed)
    found, asked = [objection] if objection else list[Problem](), set[str]()
    for command in request.commands:
        if (robot := state.robots.get(command.robot)) is None:
            found.append(unknown_robot(state, command.robot))
            continue
        is_of_any = isinstance(command, PlaceOrder) and command.to_any
        for check in OF_ANY if is_of_any else CHECKS if robot.name in asked else CHECKS + FIRST:
            found += check(state, robot, command)
        if robot.name not in asked:
            found += mistakable(robot, request.floors)
            found += set_up.busy(state, robot) if request.alone else ()
        asked.add(robot.name)
    return sorted(dict.fromkeys(found), key=lambda problem: not problem.blocks)


def repeated(request: Request, given: Mapping[tuple[Command, ...], float], now: float) -> list[Problem]:
    """Check for the same orders given again at once. `given`: the time of each (monotonic)."""
    at = given.get(request.commands)
    places = any(isinstance(command, PlaceOrder) for command in request.commands)
    if at is None or now - at >= SAME_WITHIN or not places:
        return []
    return [Problem("repeated", Message("same order sent {seconds} s ago", seconds=f"{now - at:.1f}"))]
