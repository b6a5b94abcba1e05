"""The dispatcher and the fleet adapters: requests as they take them, and their answers.

An unknown fleet, robot or task, and broken JSON, is answered by none of them.
"""

import json
from collections.abc import Callable, Mapping
from itertools import count
from typing import Any

from fleet_tui.simulator.rmf.member import SimMember
from fleet_tui.simulator.rmf.tasks import Json, SimTask

BIDDING = 2.0
"""Seconds for which fleets bid for a task."""
SELECTED = 1
DISPATCHED = 3
FAILED = 4
CANCELED_IN_FLIGHT = 5
"""States of a dispatch."""
KEPT = 20

Answer = tuple[str, Json]
"""The id of a request and its answer."""


class SimDispatch:
    """A task for which fleets still bid, or just did."""

    def __init__(self, task: SimTask) -> None:
        self.task = task
        self.left = BIDDING
        self.status = SELECTED
        self.errors: list[str] = []


class SimDispatcher:
    """Takes requests and assigns tasks to members. `millis` is the clock in milliseconds. The attributes
    without an underscore are for tests to read and to change."""

    refuses = ""
    """The reason that every request is refused, empty for none."""
    deaf = False
    """True: requests are neither carried out nor answered."""
    mute = False
    """True: requests are carried out, and not answered."""

    def __init__(self, members: Mapping[str, SimMember], millis: Callable[[], int]) -> None:
        self._members = members
        self._millis = millis
        self.requests: list[Json] = []
        """Every request that arrived, the newest last."""
        self.active: list[SimDispatch] = []
        self.finished: list[SimDispatch] = []
        self._numbers = count(1)
        self._handlers: Mapping[str, Callable[[Json], Json | None]] = {
            "dispatch_task_request": self._dispatch,
            "robot_task_request": self._direct,
            "cancel_task_request": self._cancel,
            "interrupt_task_request": self._interrupt,
            "resume_task_request": self._resume,
        }

    def restart(self) -> None:
        """Forget everything, as a process that is started again."""
        self.active = []
        self.finished = []
        self._numbers = count(1)

    def take(self, text: str, request_id: str) -> Answer | None:
        """Carry out a request, and return the answer if any of the nodes gives one."""
        try:
            request = json.loads(text)
            handler = self._handlers[request["type"]]
        except (ValueError, KeyError, TypeError):
            return None
        self.requests.append(request)
        if self.deaf:
            return None
        answer = _error(5, "Refused", self.refuses) if self.refuses else handler(request)
        return None if answer is None or self.mute else (request_id, answer)

    def step(self, dt: float) -> None:
        for one in list(self.active):
            one.left -= dt
            if one.left <= 0.0:
                self.active.remove(one)
                self._award(one)
                self.finished = [*self.finished, one][-KEPT:]

    def _award(self, one: SimDispatch) -> None:
        """Give a task to the robot with the fewest tasks, the first of equals."""
        able = [
            member
            for member in self._members.values()
            if not member.silence and not _unknown(member, one.task)
        ]
        if not able:
            one.status = FAILED
            one.errors = [
                json.dumps({"code": 9, "category": "Not Feasible", "detail": "no bid was received"})
            ]
            return
        one.status = DISPATCHED
        min(able, key=lambda member: len(member.tasks)).assign(one.task)

    def _task(self, request: Json, kind: str) -> SimTask:
        wanted = request["request"]
        places = tuple(wanted["description"]["places"])
        return SimTask(f"patrol.{kind}-{next(self._numbers)}", places, wanted.get("requester", ""))

    def _dispatch(self, request: Json) -> Json:
        task = self._task(request, "dispatch")
        self.active.append(SimDispatch(task))
        return {"success": True, "state": {**task.state(), "dispatch": {"status": "queued"}}}

    def _direct(self, request: Json) -> Json | None:
        member = self._members.get(f"{request['fleet']}/{request['robot']}")
        if member is None:
            return None
        task = self._task(request, "direct")
        if unknown := _unknown(member, task):
            return _error(4, "Invalid request", f"no place named {unknown}")
        member.assign(task)
        return {"success": True, "state": task.state()}

    def _found(self, task_id: str) -> tuple[SimMember, SimTask] | None:
        owned = ((member, task) for member in self._members.values() for task in member.tasks)
        return next((one for one in owned if one[1].id == task_id), None)

    def _cancel(self, request: Json) -> Json | None:
        pending = [one for one in self.active if one.task.id == request["task_id"]]
        for one in pending:
            self.active.remove(one)
            one.status = CANCELED_IN_FLIGHT
            self.finished.append(one)
        if pending:
            return {"success": True}
        if (found := self._found(request["task_id"])) is None:
            return None
        member, task = found
        member.cancel_task(task, request.get("labels", []), self._millis())
        return {"success": True}

    def _interrupt(self, request: Json) -> Json | None:
        if (found := self._found(request["task_id"])) is None:
            return None
        member, task = found
        if task is not member.active:
            return _error(
                6,
                "Invalid Circumstances",
                "Interrupting a task that is queued (not yet active) is not supported",
            )
        member.changed.append(task)
        return {"success": True, "token": task.interrupt(request.get("labels", []), self._millis())}

    def _resume(self, request: Json) -> Json | None:
        if (found := self._found(request["for_task"])) is None:
            return None
        member, task = found
        member.changed.append(task)
        unknown = task.resume(request["for_tokens"], request.get("labels", []), self._millis())
        return _error(7, "Unknown Tokens", f"[{', '.join(unknown)}]") if unknown else {"success": True}


def _unknown(member: SimMember, task: SimTask) -> str:
    return next((place for place in task.places if place not in member.places), "")


def _error(code: int, category: str, detail: str) -> dict[str, Any]:
    return {"success": False, "errors": [{"code": code, "category": category, "detail": detail}]}
