"""Orders for the nearest idle robot: proposed, confirmed by the operator, checked again, sent."""

from collections.abc import Callable, Sequence
from functools import partial

from fleet_tui.commands.language.any_robot import parse_anyone
from fleet_tui.commands.language.completion import complete
from fleet_tui.commands.language.lookup import Place, is_still, order_of
from fleet_tui.commands.routes.dispatching import to_any
from fleet_tui.commands.routes.nearest import Nearest, nearest, why_none, why_not
from fleet_tui.model.request import Request
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import EMPTY, Message, joined, message_of
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.typed import Typed
from fleet_tui.ui.view.lines.questions import request_text


class AnyoneOrders:
    """Finds a robot for the places of an order. Nothing is sent without a yes to that robot."""

    def __init__(self, console: Console) -> None:
        self._store = console.store
        self._dispatch = console.dispatch
        self._notices = console.notices
        self._ask = console.ask

    def give(self, places: Sequence[Place], sent: Callable[[], None] = lambda: None) -> Message:
        """Ask whether the nearest idle robot shall visit the places, or any that a dispatcher chooses; `sent`
        is called when it was sent. Returns the reason not to, empty while the question is open."""
        if (request := to_any(self._store.state, places)) is None:
            return self._propose(places, sent, EMPTY)
        return self._dispatch.give(request, sent, asks=True)

    def _propose(self, places: Sequence[Place], sent: Callable[[], None], before: Message) -> Message:
        """Ask about the nearest robot; `before` is the reason why that is a second question."""
        found = nearest(self._store.state, places)
        if found is None:
            problem = sanitize(why_none(self._store.state, places))
        else:
            problem = self._dispatch.objection(self._request(found))
        if problem or found is None:
            return joined("; ", filter(None, (before, problem)))
        self._ask(partial(self._question, found, before), partial(self._send, found, places, sent))
        return EMPTY

    def _request(self, found: Nearest) -> Request:
        return order_of(self._store.state.robots[found.robot], found.places)

    def _question(self, found: Nearest, before: Message) -> Message:
        state = self._store.state
        asked = Message(
            "{order}?\nNearest idle, {metres} m away",
            order=request_text(state, self._request(found)),
            metres=f"{found.metres:.0f}",
        )
        reason = why_not(state, state.robots[found.robot])
        now = Message("It is now {reason}: Yes proposes the next one", reason=reason) if reason else EMPTY
        return joined("\n", filter(None, (before, asked, now)))

    def _send(self, found: Nearest, places: Sequence[Place], sent: Callable[[], None]) -> None:
        """Send the confirmed order; propose another robot if this one is not idle any more."""
        state = self._store.state
        robot = state.robots[found.robot]
        changed = [place.name for place in found.places if not is_still(robot, place)]
        if changed:
            problem: Message = Message(
                "not sent: {changed} of {robot} is a different place now",
                changed=sanitize(changed[0]),
                robot=found.robot,
            )
        elif reason := why_not(state, robot):
            problem = self._propose(
                places, sent, Message("{robot} is now {reason}", robot=found.robot, reason=reason)
            )
        else:
            problem = self._dispatch.give(self._request(found), sent)
        if problem:
            self._notices.say(problem)

    def typed(self, line: str) -> Typed | None:
        """Parse `anyone FROM TO`, None for any other line."""
        state = self._store.state
        try:
            places = parse_anyone(line, state)
        except CommandError as problem:
            return Typed(completed=complete(line, state), problem=sanitize(message_of(problem)))
        if places is None:
            return None
        names = " -> ".join(sanitize(place.name) for place in places)
        text = Message("nearest idle robot: {route}", route=names)
        if to_any(state, places) is not None:
            text = Message("any robot of the dispatcher: {route}", route=names)
        return Typed([(text, partial(self._do, places))], complete(line, state))

    def _do(self, places: Sequence[Place]) -> None:
        if problem := self.give(places):
            self._notices.say(problem)
