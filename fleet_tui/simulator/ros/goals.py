"""Goals of a ROS 2 action server: accepted, executed, cancelled, ended, forgotten."""

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Message = dict[str, Any]

ACCEPTED, EXECUTING, CANCELING, SUCCEEDED, CANCELED, ABORTED = range(1, 7)
OK, REJECTED, UNKNOWN, TERMINATED = range(4)  # return codes of action_msgs/CancelGoal
KEPT = 15.0  # seconds for which an ended goal is listed
LISTED = 100  # goals at most

Id = bytes
"""16 bytes."""


def uuid_of(id_: Id) -> NDArray[np.uint8]:
    """An id as a message holds it."""
    return np.frombuffer(id_, dtype=np.uint8)


@dataclass(eq=False)
class ServedGoal:
    """A goal that a server has accepted; `stamp` is when, in nanoseconds since 1970."""

    id: Id
    stamp: int
    request: Message
    status: int = ACCEPTED
    result: Message = field(default_factory=dict)
    age: float = 0.0
    """Seconds since it was accepted, and once it is over since its end."""

    @property
    def over(self) -> bool:
        return self.status >= SUCCEEDED


class ActionServer:
    """One action; its name without the namespace's slashes is `verb`. Its attributes are for tests too.

    `decide`: whether a goal is accepted; `begin`: begins to carry out an accepted goal.
    """

    def __init__(
        self, name: str, type_: str, decide: Callable[[Message], bool], begin: Callable[[ServedGoal], None]
    ) -> None:
        self.name = name
        self.type = type_
        self.verb = name.rpartition("/")[2]
        self._decide = decide
        self._begin = begin
        self.goals: dict[Id, ServedGoal] = {}
        self.reports: deque[list[tuple[Id, int, int]]] = deque(maxlen=LISTED)
        """The statuses that are still to be published: id, stamp and status of each goal."""
        self.alive = True
        """False: its node is not running; it neither answers nor publishes."""
        self.refuses_cancel = False
        """True: cancellations are refused."""

    @property
    def running(self) -> list[ServedGoal]:
        """The goals that have not ended, the oldest first."""
        return [goal for goal in self.goals.values() if not goal.over]

    def take(self, id_: Id, stamp: int, request: Message) -> ServedGoal | None:
        """Accept a goal and begin it; None if it is rejected."""
        if not self._decide(request):
            return None
        goal = self.goals[id_] = ServedGoal(id_, stamp, request)
        for old in [one for one in self.goals.values() if one.over][: max(0, len(self.goals) - LISTED)]:
            del self.goals[old.id]
        self._report()
        self.advance(goal, EXECUTING)
        self._begin(goal)
        return goal

    def advance(self, goal: ServedGoal, status: int, result: Message | None = None) -> None:
        """Change the status of a goal. An ended goal keeps its status."""
        if goal.over:
            return
        goal.status = status
        if goal.over:
            goal.age = 0.0
            goal.result = result or {}
        self._report()

    def age(self, dt: float) -> None:
        """Advance by dt seconds: ended goals are forgotten, which the status topic shows only with its next
        message."""
        for goal in list(self.goals.values()):
            goal.age += dt
            if goal.over and goal.age > KEPT:
                del self.goals[goal.id]

    def cancel(self, id_: Id, stamp: int) -> Message:
        """Answer a CancelGoal: one goal; without an id all goals up to the stamp; without a stamp all."""
        known = self.goals.get(id_)
        if any(id_) and not stamp:
            if known is None or known.status not in (ACCEPTED, EXECUTING):
                return _answer(UNKNOWN if known is None else TERMINATED, [])
            meant = [known]
        else:
            meant = [
                goal for goal in self.goals.values() if goal is known or not stamp or goal.stamp <= stamp
            ]
        meant = [goal for goal in meant if goal.status in (ACCEPTED, EXECUTING)]
        if meant and self.refuses_cancel:
            return _answer(REJECTED, [])
        for goal in meant:
            self.advance(goal, CANCELING)
        return _answer(OK, meant)

    def die(self) -> None:
        """Crash the node: its goals are lost without a result."""
        self.alive = False
        self.goals.clear()
        self.reports.clear()

    def _report(self) -> None:
        self.reports.append([(goal.id, goal.stamp, goal.status) for goal in self.goals.values()])


def _answer(code: int, goals: list[ServedGoal]) -> Message:
    return {"return_code": code, "goals_canceling": goals}
