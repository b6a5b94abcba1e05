"""One simulated robot of a fleet: it drives the places of its tasks one after the other."""

import random

from fleet_tui.simulator.rmf.naming import fleet_of, full_name
from fleet_tui.simulator.rmf.tasks import COMPLETED, QUEUED, UNDERWAY, SimTask
from fleet_tui.simulator.robot import STEP, SimRobot
from fleet_tui.simulator.warehouse import Building

IDLE = 0
CHARGING = 1
MOVING = 2
PAUSED = 3
WAITING = 4
"""Modes of a robot."""


class SimMember:
    """A robot that a fleet adapter drives. `changed` are tasks whose states are not published yet.
    Fleets take turns: `turn`."""

    silence = 0.0
    """Seconds for which its driver has lost it."""

    def __init__(
        self,
        turn: int,
        index: int,
        building: Building,
        vertex: int,
        rng: random.Random,
        quiet: bool,
        fleets: tuple[str, ...],
    ) -> None:
        self.body = SimRobot(index, building, vertex, rng, quiet)
        self.index = index
        self.wheels = self.body.wheels
        self.own_name = self.body.name
        self.fleet = fleet_of(turn, fleets)
        self.name = full_name(turn, index, fleets)
        self.places = {label: id_ for floor in building.floors for id_, label in floor.labels.items()}
        self.tasks: list[SimTask] = []
        """The task under way, then those that wait."""
        self.changed: list[SimTask] = []
        self.issues: list[dict[str, str]] = []

    @property
    def active(self) -> SimTask | None:
        first = self.tasks[0] if self.tasks else None
        return first if first is not None and first.status == UNDERWAY else None

    @property
    def mode(self) -> int:
        """The mode that its driver reports."""
        body = self.body
        if body.paused:
            return PAUSED
        if body.obstacle:
            return WAITING
        if body.bound is not None:
            return MOVING
        return CHARGING if body.floor.types[body.vertex] == "charger" else IDLE

    def assign(self, task: SimTask) -> None:
        task.fleet = self.fleet
        task.robot = self.own_name
        task.status = QUEUED
        self.tasks.append(task)
        self.changed.append(task)

    def cancel_task(self, task: SimTask, labels: list[str], millis: int) -> None:
        is_active = task is self.active
        task.cancel(labels, millis)
        self.tasks.remove(task)
        self.changed.append(task)
        if is_active:
            self.body.drop({order.id for order in self.body.orders})

    def live(self) -> None:
        """Advance by a step, and bring its tasks on. A robot that its driver has lost stands."""
        if self.silence:
            self.silence = max(0.0, self.silence - STEP)
            return
        task = self.active
        self.body.paused = task is not None and task.is_held
        self.body.step()
        if task is not None and not self.body.orders and not task.is_held:
            self._reach(task)
        elif task is None and self.tasks:
            self._begin(self.tasks[0])

    def _begin(self, task: SimTask) -> None:
        task.status = UNDERWAY
        self.changed.append(task)
        self._drive_to(task.places[0])

    def _reach(self, task: SimTask) -> None:
        task.done += 1
        self.changed.append(task)
        if task.done < len(task.places):
            self._drive_to(task.places[task.done])
            return
        task.status = COMPLETED
        self.tasks.remove(task)

    def _drive_to(self, place: str) -> None:
        vertex = self.places[place]
        self.body.take(vertex, vertex, 0, loaded=True)
