"""Simulated tasks, and their states as a fleet adapter writes them."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import count
from typing import Any

Json = dict[str, Any]

QUEUED = "queued"
UNDERWAY = "underway"
COMPLETED = "completed"
CANCELED = "canceled"
OVER = frozenset({COMPLETED, CANCELED})
SECONDS_PER_PLACE = 30


@dataclass(eq=False)
class SimTask:
    """A patrol over places. `fleet` and `robot` are empty until it is assigned. `interruptions` by token, as
    in its state; `done`: places that were reached."""

    id: str
    places: tuple[str, ...]
    requester: str = ""
    fleet: str = ""
    robot: str = ""
    status: str = QUEUED
    done: int = 0
    interruptions: dict[str, Json] = field(default_factory=dict)
    cancellation: Json | None = None
    _tokens: Iterator[int] = field(default_factory=count)

    @property
    def is_held(self) -> bool:
        return any("resumed_by" not in one for one in self.interruptions.values())

    def interrupt(self, labels: list[str], millis: int) -> str:
        token = str(next(self._tokens))
        self.interruptions[token] = {"unix_millis_request_time": millis, "labels": labels}
        return token

    def resume(self, tokens: list[str], labels: list[str], millis: int) -> list[str]:
        """End interruptions, and return the tokens that are unknown."""
        unknown = [one for one in tokens if "resumed_by" in self.interruptions.get(one, {"resumed_by": 0})]
        for token in set(tokens) - set(unknown):
            by = {"unix_millis_request_time": millis, "labels": labels}
            self.interruptions[token] = {**self.interruptions[token], "resumed_by": by}
        return unknown

    def cancel(self, labels: list[str], millis: int) -> None:
        self.status = CANCELED
        self.cancellation = {"unix_millis_request_time": millis, "labels": labels}

    def state(self) -> Json:
        """Return its state, as the API has it."""
        left = max(0, len(self.places) - self.done) * SECONDS_PER_PLACE * 1000
        booking = {"id": self.id, "unix_millis_earliest_start_time": 0}
        phases = {str(n): _phase(n, place) for n, place in enumerate(self.places, 1)}
        found: Json = {
            "booking": booking | ({"requester": self.requester} if self.requester else {}),
            "category": "patrol",
            "detail": "",
            "status": self.status,
            "estimate_millis": left,
            "phases": phases,
            "completed": list(range(1, self.done + 1)),
            "pending": list(range(self.done + 2, len(self.places) + 1)),
        }
        if self.robot:
            found["assigned_to"] = {"group": self.fleet, "name": self.robot}
        if self.status not in OVER and self.done < len(self.places):
            found["active"] = self.done + 1
        if self.interruptions:
            found["interruptions"] = self.interruptions
        if self.cancellation:
            found["cancellation"] = self.cancellation
        return found


def _phase(number: int, place: str) -> Json:
    return {"id": number, "category": "Go to place", "detail": f"[place:{place}]"}
