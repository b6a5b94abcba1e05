"""Requests made during startup: they wait a moment for the link instead of being refused."""

from collections.abc import Callable
from typing import NamedTuple

from msgspec.structs import replace

from fleet_tui.model.commands import Command, PauseRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.request import Request

LINK_WITHIN = 1.0
PAUSE_WITHIN = 5.0
"""Seconds after which a request, and a pause, no longer wait for the first connection."""

LATEST = 0.5
"""Seconds after that within which the console must check again: a request is not sent long after its key."""

Give = Callable[[Request], None]


class _StartupRequest(NamedTuple):
    request: Request
    since: float

    @property
    def pauses(self) -> bool:
        return all(isinstance(one, PauseRobot) for one in self.request.commands)

    @property
    def until(self) -> float:
        return self.since + (PAUSE_WITHIN if self.pauses else LINK_WITHIN)


class StartupRequests:
    """Holds requests until the link of their robots is up, or the time limit has passed."""

    def __init__(self, give: Give, refuse: Callable[[str], None]) -> None:
        """`refuse` is called with the reason that a request is not sent."""
        self._give = give
        self._refuse = refuse
        self._waiting: list[_StartupRequest] = []

    def hold(self, state: FleetState, request: Request, now: float) -> Request | None:
        """Hold the commands that have to wait. Returns the others, None if there are none."""
        return self._hold_starting(state, _StartupRequest(request, now))

    def release(self, state: FleetState, now: float) -> None:
        """Send the requests that need not wait any longer; after the time limit the checks give the reason
        not to."""
        waiting, self._waiting = self._waiting, []
        for one in waiting:
            ready = self._hold_starting(state, one) if now < one.until else one.request
            if ready is None:
                continue
            if now > one.until + LATEST and not one.pauses:
                self._refuse(f"not sent: no link for {now - one.since:.1f} s, repeat the command")
            else:
                self._give(ready)

    def _hold_starting(self, state: FleetState, one: _StartupRequest) -> Request | None:
        """Hold the commands whose link is still starting, independently of the other links."""
        commands = one.request.commands
        starting = tuple(command for command in commands if _is_starting(state, command))
        if starting:
            self._waiting.append(_StartupRequest(replace(one.request, commands=starting), one.since))
        rest = tuple(command for command in commands if command not in starting)
        return replace(one.request, commands=rest) if rest else None


def _is_starting(state: FleetState, command: Command) -> bool:
    robot = state.robots.get(command.robot)
    return robot is not None and state.links[robot.link].is_starting
