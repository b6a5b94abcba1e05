"""Substitutes for a pause, which navigation stacks do not have."""

from collections.abc import Iterator, Sequence
from typing import Literal

from msgspec import Struct

from fleet_tui.model.kind import PAUSE, RESUME
from fleet_tui.robots.adapter import Outgoing, Publication, ServiceCall
from fleet_tui.robots.ros.names import Names


class PauseSettings(Struct, frozen=True):
    """`pause`: the substitute for a pause. `hold` cancels the goal and keeps it in this console, `lock` locks
    the motors over `[profile.topics] pause_navigation`, empty is none."""

    pause: Literal["hold", "lock", ""] = "hold"


class Pauses:
    """The pauses of one site's robots: services if it names both, else by its settings."""

    def __init__(self, names: Names, settings: PauseSettings) -> None:
        self._names = names
        # One service alone is not used: its pause could not be resumed.
        self._has_services = all(names.service(key, "robot") for key in ("pause", "resume"))
        self._wants_lock = settings.pause == "lock"
        has_lock = bool(names.topic("pause_navigation", "robot"))
        self._locks = self._wants_lock and has_lock
        self.holds = settings.pause == "hold" and not self._has_services
        """To pause is to cancel the goal, which this console keeps."""
        self.may_lock = self.holds and has_lock
        """A second pause locks the motors of a robot that the first one did not stop."""

    @property
    def accepted(self) -> tuple[str, ...]:
        """Return the requests that such robots accept."""
        return (PAUSE, RESUME) if self.holds or self._locks or self._has_services else ()

    @property
    def unset(self) -> dict[str, str]:
        """The key that is empty if a pause over a lock lacks its topic."""
        if self.accepted or not self._wants_lock:
            return {}
        return dict.fromkeys((PAUSE, RESUME), f"{self._names.table}.topics.pause_navigation")

    def switch(self, key: str, robot: str) -> Sequence[Outgoing]:
        """Return the messages that pause or resume a robot, by the `key` of the service; empty if its goal is
        held."""
        names = self._names
        if self._has_services:
            return (ServiceCall(names.service(key, robot), names.service_type(key), {}),)
        if self._locks:
            return (self.lock(robot, key == "pause"),)
        return ()

    def lock(self, robot: str, is_locked: bool) -> Publication:
        """Return the message that locks or releases the motors of a robot."""
        topic, type_ = self._names.topic("pause_navigation", robot), self._names.type("pause_navigation")
        return Publication(topic, type_, {"data": is_locked})

    def services(self, robot: str) -> Iterator[tuple[str, str, str]]:
        """Return key, name and type of each service that pauses or resumes a robot."""
        for key in ("pause", "resume"):
            if name := self._names.service(key, robot):
                yield key, name, self._names.service_type(key)

    def publications(self, robot: str) -> Sequence[tuple[str, str]]:
        """Return name and type of the topic of the lock, if any."""
        names = self._names
        if not (self._locks or self.may_lock) or self._has_services:
            return ()
        return ((names.topic("pause_navigation", robot), names.type("pause_navigation")),)
