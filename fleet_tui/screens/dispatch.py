"""The one way from a wish to the robots: checked, asked where something speaks against it, sent."""

import time
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from fleet_tui.model.commands import Command
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.request import Request
from fleet_tui.screens.held import Held
from fleet_tui.screens.part import Part
from fleet_tui.state.store import Store
from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.lines.commands import newest

if TYPE_CHECKING:
    from fleet_tui.model.problem import Problem
    from fleet_tui.screens.confirm import Confirm


class Dispatch(Part):
    """What destroys asks once; a pause never asks."""

    store: Store
    submit: Callable[[Command], None]
    read_only: bool
    armed: bool
    confirm: "Confirm"

    def __init__(self) -> None:
        super().__init__()
        self._given: dict[tuple[Command, ...], float] = {}
        self.said, self._said_at = "", 0.0
        self._held = Held(lambda wish: self._give_held(wish), lambda problem: self.say(problem))

    @property
    def state(self) -> FleetState:
        """The newest picture of the fleet."""
        return self.store.state

    def _problems(self, wish: Request) -> "list[Problem]":
        # Here, not above: the first paint does without them.
        from fleet_tui.model.problem import Permissions
        from fleet_tui.rules.commands.checks import problems, repeated

        found = problems(self.state, wish, Permissions(self.read_only, self.armed))
        return [*repeated(wish, self._given, time.monotonic()), *found]

    def give(self, wish: Request, sent: Callable[[], None] = lambda: None) -> str:
        """Send a wish, after asking where something is lost or was warned of; `sent` is called when it
        has left, or waits for the first connection. Returns why it is not sent, empty where it is or where
        that is asked."""
        # Here, not above: the first paint does without them.
        from fleet_tui.rules.commands.checks import acceptable

        wish, left_out = acceptable(self.state, wish)
        problem = self._give_able(wish, sent)
        if left_out and not problem:
            self.note(f"not sent to {'; '.join(sanitize(one.text) for one in left_out)}")
        return problem

    def _give_able(self, wish: Request, sent: Callable[[], None]) -> str:
        may_send = self.armed and not self.read_only
        ready = self._held.hold(self.state, wish, time.monotonic()) if may_send else wish
        if ready != wish:
            self.note("waiting for the link")
        if ready is None:
            sent()
            return ""
        return self._give_now(ready, sent)

    def _give_held(self, wish: Request) -> None:
        if problem := self._give_now(wish, lambda: None):
            self.say(problem)

    def release_held(self) -> None:
        """Give what waited for the link, when that is there."""
        self._held.release(self.state, time.monotonic())

    def _give_now(self, wish: Request, sent: Callable[[], None]) -> str:
        from fleet_tui.view.lines.questions import losses, question

        found = self._problems(wish)
        for problem in found:
            if problem.blocks:
                return f"not sent: {sanitize(problem.text)}"
        if found or any(losses(self.state, wish)):
            self.confirm.ask(
                lambda: question(self.state, wish, self._problems(wish)),
                partial(self._send_after_all, wish, sent),
            )
        else:
            self._send(wish, sent)
        return ""

    def _send_after_all(self, wish: Request, sent: Callable[[], None]) -> None:
        """While it was asked, the fleet went on: what must not be sent now is not."""
        wrong = [problem.text for problem in self._problems(wish) if problem.blocks]
        if wrong:
            self.say(f"not sent: {sanitize(wrong[0])}")
        else:
            self._send(wish, sent)

    def _send(self, wish: Request, sent: Callable[[], None]) -> None:
        for command in wish.commands:
            self.submit(command)
        from fleet_tui.rules.commands.checks import SAME_WITHIN

        now = time.monotonic()
        recent = {given: at for given, at in self._given.items() if now - at < SAME_WITHIN}
        self._given = {**recent, wish.commands: now}
        sent()

    def do(self, wish: Request) -> None:
        """Send a wish, or say why not."""
        if problem := self.give(wish):
            self.say(problem)

    def say(self, text: str) -> None:
        """Tell the operator why nothing happened."""
        self.note(text)
        self.tick()

    def note(self, text: str) -> None:
        """Tell it with the next tick."""
        self.said, self._said_at = text, newest(self.state)

    def tick(self) -> None:
        """Show the newest state."""
        raise NotImplementedError
