"""Requests made while the console starts: they wait a moment for the link instead of being refused."""

from collections.abc import Callable

from msgspec.structs import replace

from fleet_tui.model.commands import Command, PauseRobot, Wish
from fleet_tui.model.fleet import FleetState

LINK_WITHIN, PAUSE_WITHIN = 1.0, 5.0
"""Seconds after which a request, and one to pause, no longer waits for the first connection."""

Give = Callable[[Wish], None]


class Held:
    """Keeps requests until the link of their robots is there, or the time is up."""

    def __init__(self, give: Give) -> None:
        self._give = give
        self._waiting: list[tuple[Wish, float]] = []

    def hold(self, state: FleetState, wish: Wish, now: float) -> Wish | None:
        """Keep what has to wait. Returns what need not, None where that is nothing."""
        starting = tuple(one for one in wish.commands if _is_starting(state, one))
        if not starting:
            return wish
        pauses = all(isinstance(one, PauseRobot) for one in starting)
        until = now + (PAUSE_WITHIN if pauses else LINK_WITHIN)
        self._waiting.append((replace(wish, commands=starting), until))
        rest = tuple(one for one in wish.commands if one not in starting)
        return replace(wish, commands=rest) if rest else None

    def release(self, state: FleetState, now: float) -> None:
        """Give what need not wait any longer; where the time is up, the checks say why it is not sent."""
        if not self._waiting:
            return
        waiting, self._waiting = self._waiting, []
        for wish, until in waiting:
            if now < until and any(_is_starting(state, one) for one in wish.commands):
                self._waiting.append((wish, until))
            else:
                self._give(wish)


def _is_starting(state: FleetState, command: Command) -> bool:
    robot = state.robots.get(command.robot)
    return robot is not None and state.links[robot.link].is_starting
