"""Goals of a ROS 1 actionlib SimpleActionServer: one is carried out, a newer one waits."""

import math
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

Message = dict[str, Any]

PENDING, ACTIVE, PREEMPTED, SUCCEEDED, ABORTED, REJECTED, PREEMPTING, RECALLING, RECALLED = range(9)
ENDED = frozenset({PREEMPTED, SUCCEEDED, ABORTED, REJECTED, RECALLED})
KEPT = 5.0  # seconds for which a goal stays listed after its end
LISTED = 1000  # goals at most

TAKEN = "This goal has been accepted by the simple action server"
# Its misspelling is the real server's.
REPLACED = "This goal was canceled because another goal was recieved by the simple action server"
TOO_OLD = (
    "This goal handle was canceled by the action server because its timestamp is before the timestamp of the"
    " last cancel request"
)


@dataclass(frozen=True)
class GoalReport:
    """A goal as listed on the status topic; `stamp` in nanoseconds since 1970."""

    id: str
    stamp: int
    status: int
    text: str


@dataclass(eq=False)
class ActionlibGoal:
    """A goal known to a server; `request` is None if only its cancellation has arrived."""

    id: str
    stamp: int
    request: Message | None
    status: int = PENDING
    text: str = ""
    left: float = math.inf
    """Seconds for which it stays listed."""

    @property
    def over(self) -> bool:
        return self.status in ENDED

    @property
    def report(self) -> GoalReport:
        return GoalReport(self.id, self.stamp, self.status, self.text)


class SimpleActionServer:
    """One action, as its node `name` has it. `clock`: nanoseconds since 1970.

    Its attributes are for tests and faults to read and change. The goal that was carried out last stays
    listed until the next one is; goals that were let go of stay for KEPT seconds.
    """

    def __init__(self, name: str, clock: Callable[[], int]) -> None:
        self.name = name
        self._clock = clock
        self.goals: dict[str, ActionlibGoal] = {}
        self.current: ActionlibGoal | None = None
        """The goal that is carried out, or was last."""
        self.next: ActionlibGoal | None = None
        """The goal that waits to be carried out."""
        self.kept = KEPT
        """Seconds for which a goal is listed that it has let go of."""
        self.said: deque[GoalReport | list[GoalReport]] = deque(maxlen=LISTED)
        """Results and lists of goals that are still to be published, the oldest first."""
        self._last_cancel = 0
        self._made = 0

    @property
    def running(self) -> list[ActionlibGoal]:
        """The goals that have not ended, the oldest first."""
        return [goal for goal in self.goals.values() if goal.request is not None and not goal.over]

    def listed(self) -> list[GoalReport]:
        return [goal.report for goal in self.goals.values()]

    def take(self, id_: str, stamp: int, request: Message, rejected: bool = False) -> None:
        """Receive a goal: one that is known is ignored. `rejected`: refuse it."""
        known = self.goals.get(id_)
        if known is not None:
            if known.status == RECALLING and known.request is None:
                known.request = request
                known.left = self.kept if stamp else math.inf
                self.end(known, RECALLED, "")
            return
        goal = ActionlibGoal(id_ or self._new_id(), stamp or self._clock(), request)
        self._add(goal)
        if stamp and stamp <= self._last_cancel:
            self._drop(goal, RECALLED, TOO_OLD)
        elif rejected:
            self._drop(goal, REJECTED, "")
        elif any(one is not None and goal.stamp < one.stamp for one in (self.current, self.next)):
            self._drop(goal, RECALLED, REPLACED)
        else:
            if self.next is not None:
                self._drop(self.next, RECALLED, REPLACED)
            self.next = goal

    def cancel(self, id_: str, stamp: int) -> None:
        """Cancel a goal by its id, and with a stamp every goal up to it; without both all goals."""
        for goal in self.goals.values():
            if (not id_ and not stamp) or goal.id == id_ or (stamp and goal.stamp <= stamp):
                self._request_cancel(goal)
        if id_ and id_ not in self.goals:
            # Kept in case the goal follows; without a stamp the real server never forgets it.
            self._add(ActionlibGoal(id_, stamp, None, RECALLING, left=self.kept if stamp else math.inf))
        self._last_cancel = max(self._last_cancel, stamp)

    def accept(self) -> ActionlibGoal | None:
        """Replace the current goal by the waiting one; None if there is no waiting goal."""
        goal, self.next = self.next, None
        if goal is None:
            return None
        if self.current is not None:
            if not self.current.over:
                self.end(self.current, PREEMPTED, REPLACED)
            self.current.left = self.kept
        self.current = goal
        goal.status = PREEMPTING if goal.status == RECALLING else ACTIVE
        goal.text = TAKEN
        self.said.append(self.listed())
        return goal

    def end(self, goal: ActionlibGoal, status: int, text: str) -> None:
        """End a goal that has not ended, and publish its result."""
        goal.status = status
        goal.text = text
        self.said += [goal.report, self.listed()]

    def age(self, dt: float) -> None:
        for goal in list(self.goals.values()):
            goal.left -= dt
            if goal.left <= 0.0:
                del self.goals[goal.id]

    def restart(self) -> None:
        """Restart the node: its goals are lost without a result."""
        self.goals.clear()
        self.said.clear()
        self.current = self.next = None
        self._last_cancel = 0
        self.said.append([])

    def _request_cancel(self, goal: ActionlibGoal) -> None:
        if goal is not self.current and goal is not self.next:
            goal.left = self.kept
        if goal.status in (PENDING, ACTIVE):
            goal.status = RECALLING if goal.status == PENDING else PREEMPTING
            self.said.append(self.listed())

    def _drop(self, goal: ActionlibGoal, status: int, text: str) -> None:
        goal.left = self.kept
        self.end(goal, status, text)

    def _add(self, goal: ActionlibGoal) -> None:
        self.goals[goal.id] = goal
        if len(self.goals) > LISTED:
            held = (self.current, self.next)
            del self.goals[next(one.id for one in self.goals.values() if one not in held)]

    def _new_id(self) -> str:
        self._made += 1
        secs, nsecs = divmod(self._clock(), 10**9)
        return f"{self.name}-{self._made}-{secs}.{nsecs}"
