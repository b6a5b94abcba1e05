"""The single path of a request to the robots: checked, confirmed if there are warnings, sent."""

import time
from collections.abc import Callable
from functools import partial
from typing import NamedTuple, Protocol

from msgspec.structs import replace

from fleet_tui.commands.checks import SAME_WITHIN, acceptable, problems, repeated
from fleet_tui.commands.rights import needed_for
from fleet_tui.commands.subject import Subject, subject_of, what_changed
from fleet_tui.model.commands import Command, PauseRobot, PlaceOrder
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.problem import Permissions, Problem, Right
from fleet_tui.model.request import Request
from fleet_tui.orders.local_queue import hold_all
from fleet_tui.situation.battery.charging import has_low_battery
from fleet_tui.state.store import Store
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import EMPTY, Message, joined, message_of, verbatim
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.backend import Backend
from fleet_tui.ui.controllers.files import READ_ONLY
from fleet_tui.ui.controllers.notices import Notices
from fleet_tui.ui.view.lines.questions import losses, question

Prepare = Callable[[], Message]
"""Prepares a request that is about to be sent. Returns the reason not to send it, empty if there is none."""


class Ask(Protocol):
    """Asks a question until it is empty, and calls the next step only after a yes, another one if the
    operator rather charges the robot."""

    def __call__(
        self,
        question: Callable[[], Message],
        then: Callable[[], None],
        charge: Callable[[], None] | None = None,
    ) -> None: ...


LINK_WITHIN = 1.0
PAUSE_WITHIN = 5.0
"""Seconds after which a request, and a pause, no longer wait for the first connection."""

LATEST = 0.5
"""Seconds after that within which the console must check again: a request is not sent long after its key."""

Give = Callable[[Request], None]


class Dispatch:
    """Decides whether a command may be sent. Destructive ones are confirmed once; a pause never is."""

    def __init__(
        self, store: Store, backend: Backend, permissions: Permissions, notices: Notices, ask: Ask
    ) -> None:
        self._store = store
        self._backend = backend
        self._notices = notices
        self._ask = ask
        self.permissions = permissions
        self.given: dict[tuple[Command, ...], float] = {}
        self._startup = StartupRequests(self._give_waiting, notices.say)

    def arm(self) -> None:
        """Enable or disable commands from this console, including the orders that wait here."""
        if refusal := self.permissions.refusal(Right.DISPATCH):
            self._notices.say(refusal)
            return
        armed = not self.permissions.armed
        self.permissions = replace(self.permissions, armed=armed)
        for hold in () if armed else hold_all(self._store.state, Message("this console is not armed")):
            self._backend.post(hold)
        self._notices.say(Message("this console is armed") if armed else Message("this console is not armed"))

    def set_up_refusal(self, needed: Right = Right.SETUP) -> Message:
        """Return the reason that what needs a right can't begin at this console, empty if it can."""
        objection = self.permissions.objection(needed)
        if objection is None:
            return self._backend.refusal
        if objection.check == "read-only":
            return READ_ONLY
        if objection.check == "not armed":
            return self._backend.refusal or Message("not sent: {problem}", problem=objection.text)
        return objection.text

    def desk_refusal(self, needed: Right = Right.DISPATCH) -> Message:
        """Return the reason that nothing may be claimed or closed from this console, empty if it may: it need
        not be armed for that."""
        objection = self.permissions.objection(needed, arms=False)
        return objection.text if objection else self._backend.refusal

    def objections(self, request: Request) -> list[Problem]:
        """Return what speaks against a request, errors first."""
        found = problems(self._store.state, request, self.permissions)
        doubtful = [Problem("doubtful", request.doubt, blocks=False)] if request.doubt else []
        is_order = any(isinstance(command, PlaceOrder) for command in request.commands)
        if is_order and not any(problem.blocks for problem in found):
            from fleet_tui.commands.routes.doubts import doubts  # numpy: not before the first picture

            doubtful += doubts(self._store.state, request)
        return [*repeated(request, self.given, time.monotonic()), *found, *doubtful]

    def objection(self, request: Request) -> Message:
        """Return the reason not to send a request, warnings aside; empty if it may be sent."""
        wrong = [problem for problem in self.objections(request) if problem.blocks]
        if wrong and wrong[0].check == "not allowed":
            return wrong[0].text
        return self._backend.refusal or (
            Message("not sent: {problem}", problem=sanitize(wrong[0].text)) if wrong else EMPTY
        )

    def give(
        self,
        request: Request,
        sent: Callable[[], None] = lambda: None,
        prepare: Prepare | None = None,
        asks: bool = False,
    ) -> Message:
        """Send a request, after a question if something is lost or has a warning, or always (`asks`); `sent`
        is called when it was sent, or waits for the first connection, `prepare` just before. One with
        `prepare` or `asks` never waits.
        Returns the reason not to send it, empty if it was sent or the question is open."""
        if self._backend.refusal:
            return self.objection(request)
        if prepare is not None or asks:
            return self._give_now(request, sent, prepare, asks)
        request, left_out = acceptable(self._store.state, request)
        problem = self._give_able(request, sent)
        if left_out and not problem:
            self._notices.note(
                Message("not sent to {text}", text=joined("; ", (sanitize(one.text) for one in left_out)))
            )
        return problem

    def _give_able(self, request: Request, sent: Callable[[], None]) -> Message:
        may_send = not self.permissions.objection(needed_for(request.commands), not request.only_pauses)
        ready = self._startup.hold(self._store.state, request, time.monotonic()) if may_send else request
        if ready != request:
            self._notices.note(Message("waiting for the link"))
        if ready is None:
            sent()
            return EMPTY
        return self._give_now(ready, sent)

    def _give_waiting(self, request: Request) -> None:
        if problem := self._give_now(request, lambda: None):
            self._notices.say(problem)

    def release_startup(self) -> None:
        """Send the requests that waited for the link, once it is up."""
        self._startup.release(self._store.state, time.monotonic())

    def _give_now(
        self, request: Request, sent: Callable[[], None], prepare: Prepare | None = None, asks: bool = False
    ) -> Message:
        if problem := self.objection(request):
            return problem
        found = self.objections(request)
        if asks or found or any(losses(self._store.state, request)):
            asked = subject_of(self._store.state, request)
            send = partial(self._send_after_all, request, asked, sent, prepare)
            self._ask(partial(self._question, request, asked), send, self._charge_first(request, sent))
        elif problem := self._send(request, sent, prepare):
            self._notices.say(problem)
        return EMPTY

    def _charge_first(self, request: Request, sent: Callable[[], None]) -> Callable[[], None] | None:
        """Return what sends a robot with a low battery to a charger in place of a request, None for others,
        and if it can reach none."""
        names = {command.robot for command in request.commands if isinstance(command, PlaceOrder)}
        if len(names) != 1:
            return None
        from fleet_tui.commands.routes.charging import order_to_charger, way_to_charger  # numpy, as above

        state, robot = self._store.state, self._store.state.robots[names.pop()]
        if not has_low_battery(state, robot) or not way_to_charger(state, robot):
            return None
        if request.commands[-1] == order_to_charger(state, robot).commands[0]:
            return None

        def charge() -> None:
            state = self._store.state
            try:
                self.do(order_to_charger(state, state.robots[robot.name]), sent)
            except CommandError as problem:
                self._notices.say(sanitize(message_of(problem)))

        return charge

    def _question(self, request: Request, asked: Subject) -> Message:
        """Return the question, empty once there is nothing to ask: the order to cancel may have ended, or may
        be another one."""
        if problem := self.objection(request) or self.withdrawn(request, asked):
            self._notices.say(problem)
            return EMPTY
        return verbatim(question(self._store.state, request, self.objections(request)))

    def withdrawn(self, request: Request, asked: Subject) -> Message:
        """Return why a question is void: it is not about what was `asked` any more. Empty while it is."""
        change = what_changed(self._store.state, request, asked)
        return Message("not sent: {problem}", problem=sanitize(change)) if change else EMPTY

    def _send_after_all(
        self, request: Request, asked: Subject, sent: Callable[[], None], prepare: Prepare | None
    ) -> None:
        if problem := self.send_confirmed(request, asked, sent, prepare):
            self._notices.say(problem)

    def send_confirmed(
        self,
        request: Request,
        asked: Subject,
        sent: Callable[[], None] = lambda: None,
        prepare: Prepare | None = None,
    ) -> Message:
        """Send a confirmed request, checked again: the fleet may have changed during the question. Returns
        the reason that it, or a part of it, was not sent."""
        return self.objection(request) or self.withdrawn(request, asked) or self._send(request, sent, prepare)

    def _send(self, request: Request, sent: Callable[[], None], prepare: Prepare | None) -> Message:
        if prepare is not None and (problem := prepare()):
            return problem
        problem = self._backend.submit(*request.commands)
        now = time.monotonic()
        recent = {given: at for given, at in self.given.items() if now - at < SAME_WITHIN}
        self.given = {**recent, request.commands: now}
        sent()
        return problem

    def give_unasked(self, request: Request) -> list[Problem]:
        """Send a request without a question. Returns the objections, warnings included, errors first; empty
        if it was sent."""
        if refusal := self._backend.refusal:
            return [Problem("read-only", refusal)]
        if found := problems(self._store.state, request, self.permissions):
            return found
        unsent = self._backend.submit(*request.commands)
        return [Problem("no link", unsent)] if unsent else []

    def post(self, event: Event) -> None:
        """Apply an operator's change of this console's own queue, or show the reason not to."""
        if problem := self.set_up_refusal(Right.DISPATCH) or self._backend.post(event):
            self._notices.say(problem)

    def do(
        self,
        request: Request,
        sent: Callable[[], None] = lambda: None,
        prepare: Prepare | None = None,
        asks: bool = False,
    ) -> None:
        """Send a request, or show the reason not to."""
        if problem := self.give(request, sent, prepare, asks):
            self._notices.say(problem)


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

    def __init__(self, give: Give, refuse: Callable[[Message], None]) -> None:
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
                self._refuse(
                    Message(
                        "not sent: no link for {seconds} s, repeat the command",
                        seconds=f"{now - one.since:.1f}",
                    )
                )
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
