"""Questions before a request that loses something, or that has warnings."""

from collections.abc import Iterator, Sequence
from typing import assert_never

from fleet_tui.commands.set_up.losses import set_up_losses
from fleet_tui.model.commands import CancelOrder, ClearOrders, PauseRobot, PlaceOrder, ResumeRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.problem import Problem
from fleet_tui.model.request import Request
from fleet_tui.model.set_up.commands import SetUpCommand
from fleet_tui.orders.local_queue import all_orders, clearable
from fleet_tui.orders.newest import is_paused_elsewhere
from fleet_tui.situation.batches import batch_name
from fleet_tui.text.language import counted, tr, translate
from fleet_tui.text.limits import some
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.lines.commands import command_text
from fleet_tui.ui.view.tables.missions import mission

SHOWN = 6


def losses(state: FleetState, request: Request) -> Iterator[str]:
    """Return the losses, one line each; empty if there are none."""
    for command in request.commands:
        robot = state.robots[command.robot]
        match command:
            case CancelOrder(name, order_id):
                yield tr("Cancel order {order_id} of {name}?", order_id=sanitize(order_id), name=name)
                orders = all_orders(state, robot)
                yield from (mission(robot, order) for order in orders if order.id == order_id)
            case ClearOrders(name):
                orders = clearable(state, robot)
                yield translate(
                    counted(
                        "Clear all {count} order of {name}?",
                        "Clear all {count} orders of {name}?",
                        len(orders),
                        name=name,
                    )
                )
                yield from (f"  {sanitize(order.id)}  {mission(robot, order)}" for order in orders[:SHOWN])
                if len(orders) > SHOWN:
                    yield tr("  and {count} more", count=len(orders) - SHOWN)
            case SetUpCommand():
                yield from map(translate, set_up_losses(state, robot, command))
            case PlaceOrder() | PauseRobot() | ResumeRobot():
                pass
            case _:
                assert_never(command)


def request_text(state: FleetState, request: Request) -> str:
    first = command_text(state, request.commands[0])
    if len({command.robot for command in request.commands}) > 1:
        return translate(batch_name(state, request.commands))
    robot = request.commands[0].robot
    if isinstance(asked := request.commands[0], PlaceOrder) and asked.to_any:
        first = first.removeprefix(f"{robot} ")  # it is not that robot's before it has it
    rest = (
        command_text(state, command).removeprefix(f"{robot} {tr('order')} ")
        for command in request.commands[1:]
    )
    return ", ".join([first, *rest])


def question(state: FleetState, request: Request, found: Sequence[Problem]) -> str:
    against = [translate(sanitize(problem.text)) for problem in found]
    lost = list(losses(state, request))
    if lost:
        return "\n".join([*lost, *against])
    told = ", ".join(against)
    ask = (
        [told if told.endswith("?") else tr("{told}: send anyway?", told=told)] if against else [tr("Send?")]
    )
    resumed = {command.robot for command in request.commands if isinstance(command, ResumeRobot)}
    robots = list(dict.fromkeys(command.robot for command in request.commands))
    more = tr(" and {count} more", count=len(robots) - SHOWN) if len(robots) > SHOWN else ""
    named = [", ".join(map(sanitize, robots[:SHOWN])) + more] if len(robots) > 1 else []
    elsewhere = [
        name for name in robots if name in resumed and is_paused_elsewhere(state, state.robots[name])
    ]
    if len(robots) > 1 and elsewhere:
        named.append(
            tr("{elsewhere} paused elsewhere: {some}", elsewhere=len(elsewhere), some=some(elsewhere))
        )
    return "\n".join([*ask, request_text(state, request), *named])
