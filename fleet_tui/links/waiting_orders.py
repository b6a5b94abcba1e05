"""Queues for robots that drive one goal at a time: the orders that wait here, and the time at which each is
sent."""

import logging
import time
from collections.abc import Callable, Iterator

from fleet_tui.links.queue_file import QueueFile, WaitingOrder
from fleet_tui.model.commands import (
    RESTARTED,
    CancelOrder,
    ClearOrders,
    Command,
    CommandRecord,
    PlaceOrder,
    Queued,
    Stage,
)
from fleet_tui.model.events import CommandAdvanced, CommandIssued, Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.navigation_events import QueueHeld
from fleet_tui.model.request import given_now
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import StartCharging
from fleet_tui.orders.local_queue import failed_before, is_busy, next_to_send, orders_to_save, waiting
from fleet_tui.situation.pauses import late_goals
from fleet_tui.state.store import Store
from fleet_tui.text.language import Message

LOG = logging.getLogger(__name__)


MOST_WAITING = 100
"""Maximum number of orders that wait for one robot."""

Send = Callable[[int, Command, float], None]


class WaitingOrders:
    """Runs on the network loop, except `load`. `send` sends the command of a number, given at a monotonic
    second; `resend` sends it once more without reporting progress; `new_id` returns the number of a
    command."""

    def __init__(
        self,
        file: QueueFile | None,
        store: Store,
        apply: Callable[[Event], None],
        send: Send,
        resend: Callable[[Command], None],
        new_id: Callable[[], int],
    ) -> None:
        """Without a file this console keeps no orders."""
        self._file = file
        self._store = store
        self._apply = apply
        self._send = send
        self._new_id = new_id
        self._resend = resend
        self._stopped: set[str] = set()
        """Goals for which a pause was sent again."""
        self._leaving: set[int] = set()
        self._saved: list[WaitingOrder] = []
        self._foreign: list[WaitingOrder] = []
        self._has_loaded = False

    def load(self) -> None:
        """Load the orders of an earlier console, held until the operator releases them; again for robots that
        were added."""
        robots = self._store.state.robots.values()
        is_needed = any(robot.kind.keeps_goals for robot in robots)
        if self._file is not None and is_needed and self._claim(self._file):
            self._restore()

    def _claim(self, file: QueueFile) -> bool:
        """Become the console that keeps orders, and load those left in the file."""
        if not file.claim():
            return False
        if not self._has_loaded:
            self._has_loaded = True
            self._saved = self._foreign = file.load()
            if file.problem:
                LOG.warning("%s", file.problem)
            self._restore()
        return True

    def _restore(self) -> None:
        """Hold the saved orders of robots that are there by now."""
        state = self._store.state
        saved, self._foreign = self._foreign, []
        for kept in saved:
            robot = state.robots.get(kept.robot)
            is_ours = robot is not None and state.links[robot.link].url == kept.url
            if robot is None or not is_ours or not robot.kind.keeps_goals:
                self._foreign.append(kept)
                continue
            command_id, now = self._new_id(), time.monotonic()
            command = PlaceOrder(robot.name, kept.stops) if kept.stops else StartCharging(robot.name)
            self._apply(CommandIssued(command_id, command, now, kept.wall, kept.floor))
            self._apply(CommandAdvanced(command_id, Stage.WAITING, now, RESTARTED))
            self._apply(QueueHeld(robot.name, RESTARTED))

    def handles(self, command_id: int, command: Command, given_at: float) -> bool:
        """Carry out a command here if it concerns waiting orders."""
        state = self._store.state
        robot = state.robots[command.robot]
        if not robot.kind.keeps_goals:
            return False
        if isinstance(command, Queued) and is_busy(state, robot, command_id):
            stage, detail = self._enqueue(robot)
            self._apply(CommandAdvanced(command_id, stage, given_at, detail))
            return True
        if isinstance(command, StartCharging) and (failed := failed_before(state, robot, command_id)):
            self._apply(CommandAdvanced(command_id, Stage.NOT_SENT, given_at, failed))
            return True
        if isinstance(command, CancelOrder):
            for record in waiting(state, robot):
                if record.order_id == command.order_id:
                    self._drop(record, given_at)
                    self._confirm(command_id, given_at)
                    return True
        if isinstance(command, ClearOrders) and (kept := waiting(state, robot)):
            for record in kept:
                self._drop(record, given_at)
            if state.is_fresh(robot, "vehicle") and not is_busy(self._store.state, robot, command_id):
                self._confirm(command_id, given_at)  # the vehicle says that it has none
                return True
        return False

    def _enqueue(self, robot: Robot) -> tuple[Stage, Message]:
        if len(waiting(self._store.state, robot)) >= MOST_WAITING:
            return Stage.NOT_SENT, Message(
                "{name} already has {limit} orders waiting here, the maximum",
                name=robot.name,
                limit=MOST_WAITING,
            )
        busy = Message("is paused") if robot.paused_by_us else Message("has an order")
        if self._file is None:
            detail = Message(
                "{name} {busy} and has no queue: order from a console, or wait", name=robot.name, busy=busy
            )
            return Stage.NOT_SENT, detail
        if not self._claim(self._file):
            return Stage.NOT_SENT, Message(
                "{name} {busy}, and {owner} keeps the queue",
                name=robot.name,
                busy=busy,
                owner=self._file.owner,
            )
        return Stage.WAITING, Message("in the queue of this console ({owner})", owner=self._file.owner)

    def _confirm(self, command_id: int, at: float) -> None:
        """Report a cancellation of what only this console had."""
        for stage in (Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED):
            self._apply(CommandAdvanced(command_id, stage, at, Message("was waiting here")))

    def _drop(self, record: CommandRecord, at: float) -> None:
        self._apply(
            CommandAdvanced(record.id, Stage.CANCELLED, at, Message("by this console before it was sent"))
        )

    def tick(self, now: float) -> None:
        """Send the orders that may leave, and save the waiting ones. Called with each tick."""
        state = self._store.state
        self._save(state)
        self._leaving &= {record.id for record in state.commands if record.stage is Stage.WAITING}
        for pause in state.commands:
            late = {goal.uuid for goal in late_goals(state, pause)} - self._stopped
            if late:
                self._stopped |= late
                self._resend(pause.command)
        # Until an order that leaves is sent, no other one may overtake it: it may be moved up just now.
        busy = {record.command.robot for record in state.commands if record.id in self._leaving}
        for robot in state.robots.values():
            if robot.kind.keeps_goals and robot.name not in busy:
                self._give_up_charge(robot, now)
                record = next_to_send(state, robot)
                if record is not None:
                    self._leaving.add(record.id)
                    self._send(record.id, given_now(record.command, robot.kind, record.leg), now)

    def _give_up_charge(self, robot: Robot, now: float) -> None:
        """Do not begin a charge that is held: whoever resumes the robot may have it anywhere by then."""
        for record in waiting(self._store.state, robot)[:1]:
            if robot.held and isinstance(record.command, StartCharging):
                self._apply(CommandAdvanced(record.id, Stage.NOT_SENT, now, robot.held))

    def _save(self, state: FleetState) -> None:
        kept = [*self._foreign, *self._orders_to_save(state)]
        if self._file is not None and kept != self._saved:
            self._saved = kept
            self._file.save(kept)

    def _orders_to_save(self, state: FleetState) -> Iterator[WaitingOrder]:
        for robot in state.robots.values():
            if robot.kind.keeps_goals:
                url = state.links[robot.link].url
                for record, stops in orders_to_save(state, robot):
                    yield WaitingOrder(url, robot.name, stops, record.wall, record.before.floor)

    def close(self) -> None:
        """Let other consoles keep orders. Waiting ones stay in the file."""
        if self._file is not None:
            self._save(self._store.state)
            self._file.close()
